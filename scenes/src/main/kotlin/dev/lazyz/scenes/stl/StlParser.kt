package dev.lazyz.scenes.stl

import dev.lazyz.geometry.Box
import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.ColorNumbers
import dev.lazyz.scenes.meshes.CornerMesh
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Reads stereolithography files, ASCII and binary (3D Systems, "Stereolithography Interface Specification", 1989).
 *
 * Each solid becomes a mesh. Corners at the same position become one vertex, and normals are smoothed up to creases of
 * [CREASE_ANGLE] degrees. The facets' own normals are ignored: many programs leave them zero or wrong, and the order of
 * the corners, counter-clockwise seen from outside, gives the same information. Colours of facets in the binary form
 * become vertex colours, see [StlColors].
 */
internal object StlParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. Printed parts have chamfers of 45 degrees. */
    const val CREASE_ANGLE = 30.0

    override fun parse(source: Source): Scene {
        val meshes = meshes(source)
        if (meshes.isEmpty()) source.warn("there are no facets, so there is nothing to see")
        return Scene(meshes.map { source.loading.smoothed(source, it, CREASE_ANGLE) })
    }

    private fun ascii(source: Source): List<Solid> = FarOrigin.reading(
        source.loading,
        read = { origin ->
            val solids = ArrayList<Solid>()
            StlAscii(source, origin).read { name ->
                source.loading.items(source, 1)
                Solid(name, origin = origin).also(solids::add)
            }
            solids
        },
        bounds = { solids -> solids.mapNotNull { Box.around(it.positions()) }.reduceOrNull(Box::union) },
    )

    private fun meshes(source: Source): List<Mesh> {
        val solids = if (StlBinary.isBinary(source.bytes, source.bytes.size.toLong())) {
            listOf(StlBinary.read(source))
        } else {
            source.decodeText()
            ascii(source)
        }
        source.release()
        for (solid in solids) {
            source.loading.triangles(source, solid.triangleCount.toLong())
            source.loading.vertices(source, solid.vertexCount.toLong())
        }
        return solids.filter { it.triangleCount > 0 }.map { it.mesh(source) }
    }
}

/**
 * Triangles that are given without shared vertices. Corners with equal coordinates are merged into one vertex.
 *
 * Coordinates must be exactly equal, where -0 equals 0 and all NaN are equal. Corners that are only close to each other
 * are not merged. Not thread safe.
 *
 * @property name name in the file
 * @param expectedTriangles number of triangles to reserve memory for
 * @param palette the colours of triangles, or null if they have none
 * @param origin the point that was subtracted from all positions
 */
internal class Solid(
    val name: String,
    expectedTriangles: Int = 0,
    private val palette: ColorNumbers? = null,
    private val origin: Vector3dc = Vector3d(),
) : CornerSink {
    /** Bits of x, y, z. A closed mesh has half as many vertices as triangles. */
    private val positions = DistinctTriples(expectedTriangles / 2)
    private val triangles = Ints(3 * expectedTriangles)

    /** For each triangle, the number of its colour, or -1. */
    private val colors = Ints()

    /** Number of triangles so far. */
    val triangleCount: Int get() = triangles.size / 3

    /** Number of vertices so far. */
    val vertexCount: Int get() = positions.size

    override fun add(x: Float, y: Float, z: Float) {
        // Adding 0 turns -0 into 0, and toBits turns every NaN into the same bits
        triangles.add(positions.addPoint(x, y, z))
    }

    /** Sets the colour of the triangle that was added last; [number] is its number in the palette. */
    fun color(number: Int) {
        colors.add(number)
    }

    /** Returns x, y, z of each vertex so far. */
    fun positions(): FloatArray {
        val coordinates = FloatArray(3 * positions.size)
        for (i in 0 until positions.size) {
            for (axis in 0 until 3) coordinates[3 * i + axis] = Float.fromBits(positions.get(i, axis))
        }
        return coordinates
    }

    /** Returns the solid, which was read from [source], as a mesh without normals. Do not add corners afterwards. */
    fun mesh(source: Source): Mesh {
        val coordinates = positions()
        val material = Material(name = name)
        if (palette == null) return Mesh(coordinates, triangles.toArray(), material, origin = origin)
        val mesh = CornerMesh(VertexArrays(coordinates), palette)
        for (corner in 0 until triangles.size) {
            source.step()
            mesh.add(triangles[corner], colors[corner / 3])
        }
        return mesh.mesh(source, material)
    }
}
