package dev.lazyz.conformance.frames.world

import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Surface
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import org.joml.Vector3d

/** Generates meshes: a few large triangles or dozens of small ones, flat, bent, intersecting, closed. */
internal class WorldMeshes(private val materials: Arbitrary<Coded<Material>>) {
    /** Positions, and three vertex numbers for each triangle. */
    class Geometry(val positions: FloatArray, val triangles: IntArray)

    fun any(): Arbitrary<Coded<Surface>> = coded(
        mixed(3 to strips(), 3 to sheets(), 2 to crossings(), 2 to levels(), 2 to solids()), WorldAttributes.any(),
    )

    /** Generates a large sheet, behind or intersecting most other surfaces. */
    fun backdrop(): Arbitrary<Coded<Surface>> {
        val corners = Combinators.combine(ints(-4, 4), ints(-4, 4), ints(-16, 4)).`as` { tiltX, tiltY, z ->
            rectangle(6.0) { x, y -> z / 8.0 + (tiltX * x + tiltY * y) / 32.0 }
        }
        return coded(corners.map { joined(listOf(it)) }, WorldAttributes.any())
    }

    /** Generates large and small triangles with vertex normals, with either winding. */
    fun turned(): Arbitrary<Coded<Surface>> {
        val either = Combinators.combine(mixed(2 to sheets(), 1 to solids(), 1 to crossings()), ints(0, 1))
            .`as` { geometry, turn -> if (turn == 0) geometry else reversed(geometry) }
        return coded(either, WorldAttributes.withNormals())
    }

    private fun coded(shapes: Arbitrary<Geometry>, attributes: Arbitrary<WorldAttributes>): Arbitrary<Coded<Surface>> =
        Combinators.combine(shapes, attributes, materials).`as` { shape, attribute, material ->
            val positions = shape.positions
            val normals = attribute.normals(positions)
            val uvs = attribute.uvs(positions)
            val colors = attribute.colors(positions)
            val uvs2 = attribute.uvs2(positions)
            val tangents = attribute.tangents(positions)
            val words = listOfNotNull(
                code(positions),
                "intArrayOf(${shape.triangles.joinToString()})",
                material.code,
                normals?.let { "normals = ${code(it)}" },
                uvs?.let { "uvs = ${code(it)}" },
                colors?.let { "colors = ${code(it)}" },
                uvs2?.let { "uvs2 = ${code(it)}" },
                tangents?.let { "tangents = ${code(it)}" },
            )
            Coded(
                Mesh(
                    positions, shape.triangles, material.value, normals, uvs, colors, uvs2 = uvs2, tangents = tangents,
                ),
                words.joinToString(prefix = "Mesh(", postfix = ")"),
            )
        }

    /** Generates triangles that share edges with their neighbours or cover each other. */
    private fun strips(): Arbitrary<Geometry> = Combinators
        .combine(WorldShapes.points.list().ofMinSize(3).ofMaxSize(6), ints(0, 2).list().ofMinSize(1).ofMaxSize(6))
        .`as` { corners, turns ->
            val positions = corners.flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }
            val triangles = turns.flatMapIndexed { i, turn -> listOf(i, i + 1 + turn % 2, i + 2 - turn % 2) }
                .map { it % corners.size }
            Geometry(positions.toFloatArray(), triangles.toIntArray())
        }

    /**
     * Generates a grid with two triangles per cell, flat or bent, mostly in front of the camera, of either orientation.
     */
    private fun sheets(): Arbitrary<Geometry> {
        val heights = ints(-8, 8).list().ofMinSize(1).ofMaxSize(4)
        val turns = oneOf(0, 3, 0, 3, 0, 3, 1, 2)
        val sizes = oneOf(2.0, 3.0, 1.0)
        return Combinators.combine(ints(1, 4), ints(1, 4), heights, turns, ints(-8, 8), sizes)
            .`as` { columns, rows, bends, turn, place, half ->
                val positions = ArrayList<Float>()
                for (i in 0 until (columns + 1) * (rows + 1)) {
                    val u = half * (2.0 * (i % (columns + 1)) / columns - 1.0)
                    val v = half * (2.0 * (i / (columns + 1)) / rows - 1.0)
                    val w = place / 8.0 + bends[i % bends.size] / 16.0
                    val axes = listOf(u, v, w)
                    for (axis in 0 until 3) positions.add(axes[(axis + turn) % 3].toFloat())
                }
                val triangles = (0 until columns * rows).flatMap { cell ->
                    val a = cell / columns * (columns + 1) + cell % columns
                    val c = a + columns + 1
                    listOf(a, a + 1, c, c, a + 1, c + 1)
                }
                Geometry(positions.toFloatArray(), triangles.toIntArray()).let { if (turn < 3) it else reversed(it) }
            }
    }

    /** Generates large faces through nearly the same points at nearly the same angles. */
    private fun crossings(): Arbitrary<Geometry> {
        val face = Combinators.combine(ints(-2, 2), ints(-2, 2), ints(-1, 1)).`as` { tiltX, tiltY, z ->
            rectangle(2.0) { x, y -> (z + tiltX * x + tiltY * y) / 64.0 }
        }
        return face.list().ofMinSize(2).ofMaxSize(5).map { joined(it) }
    }

    /**
     * Generates faces parallel to the screen of a camera along the z axis, and sloped ones that end at the same depths.
     */
    private fun levels(): Arbitrary<Geometry> {
        val face = Combinators.combine(ints(-2, 2), ints(-2, 2), ints(-8, 8), ints(-8, 8)).`as` { near, far, x, y ->
            rectangle(1.0) { _, side -> if (side < 0) near / 2.0 else far / 2.0 }
                .map { Vector3d(it.x + x / 8.0, it.y + y / 8.0, it.z) }
        }
        return face.list().ofMinSize(1).ofMaxSize(6).map { joined(it) }
    }

    /** Generates octahedra, some with each edge split in two. */
    private fun solids(): Arbitrary<Geometry> =
        Combinators.combine(WorldShapes.centers, oneOf(1.5, 1.0, 2.0), oneOf(0, 0, 0, 1)).`as` { center, radius, cuts ->
            var corners = OCTAHEDRON
            repeat(cuts) {
                corners = corners.flatMap { (a, b, c) ->
                    val ab = middle(a, b)
                    val bc = middle(b, c)
                    val ca = middle(c, a)
                    listOf(Triple(a, ab, ca), Triple(ab, b, bc), Triple(ca, bc, c), Triple(ab, bc, ca))
                }
            }
            val numbers = LinkedHashMap<Vector3d, Int>()
            val triangles = corners.flatMap { (a, b, c) -> listOf(a, b, c) }
                .map { numbers.getOrPut(it) { numbers.size } }
            val positions = numbers.keys.map { Vector3d(it).mul(radius).add(center) }
                .flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }
            Geometry(positions.toFloatArray(), triangles.toIntArray())
        }

    private companion object {
        val OCTAHEDRON: List<Triple<Vector3d, Vector3d, Vector3d>> = (0 until 8).map { octant ->
            val x = Vector3d(if (octant and 1 == 0) 1.0 else -1.0, 0.0, 0.0)
            val y = Vector3d(0.0, if (octant and 2 == 0) 1.0 else -1.0, 0.0)
            val z = Vector3d(0.0, 0.0, if (octant and 4 == 0) 1.0 else -1.0)
            if (x.x * y.y * z.z > 0.0) Triple(x, y, z) else Triple(x, z, y)
        }

        /** The midpoint of [a] and [b], moved outwards, roughly onto the sphere through both. */
        fun middle(a: Vector3d, b: Vector3d): Vector3d = Vector3d(a).add(b).mul(0.75)

        fun rectangle(half: Double, height: (x: Double, y: Double) -> Double): List<Vector3d> =
            listOf(-1 to -1, 1 to -1, 1 to 1, -1 to 1).map { (x, y) ->
                Vector3d(x * half, y * half, height(x * half, y * half))
            }

        /** Joins faces of four corners, with two triangles each. */
        fun joined(faces: List<List<Vector3d>>): Geometry = Geometry(
            faces.flatten().flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }.toFloatArray(),
            faces.indices.flatMap { listOf(0, 1, 2, 0, 2, 3).map { corner -> 4 * it + corner } }.toIntArray(),
        )

        fun reversed(geometry: Geometry): Geometry = Geometry(geometry.positions, geometry.triangles.reversedArray())
    }
}
