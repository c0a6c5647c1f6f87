package dev.lazyz.drawing

import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh

/** Closed meshes with known edges, counter-clockwise seen from outside. */
internal object Solids {
    /** A box of 12 triangles, 8 vertices. */
    fun box(x0: Float, y0: Float, z0: Float, x1: Float, y1: Float, z1: Float, material: Material = Material()): Mesh {
        val positions = FloatArray(24) {
            val corner = it / 3
            when (it % 3) {
                0 -> if (corner and 1 == 0) x0 else x1
                1 -> if (corner and 2 == 0) y0 else y1
                else -> if (corner and 4 == 0) z0 else z1
            }
        }
        val quads = listOf(
            listOf(0, 2, 3, 1), listOf(4, 5, 7, 6), listOf(0, 1, 5, 4), listOf(2, 6, 7, 3), listOf(0, 4, 6, 2),
            listOf(1, 3, 7, 5),
        )
        val triangles = quads.flatMap { (a, b, c, d) -> listOf(a, b, c, a, c, d) }
        return Mesh(positions, triangles.toIntArray(), material)
    }

    fun cube(material: Material = Material()): Mesh = box(-1f, -1f, -1f, 1f, 1f, 1f, material)

    /** A torus around the y axis. */
    fun torus(large: Double, small: Double, around: Int, across: Int): Mesh {
        val positions = FloatArray(3 * around * across) {
            val a = 2 * StrictMath.PI * (it / 3 / across) / around
            val b = 2 * StrictMath.PI * (it / 3 % across) / across
            val r = large + small * StrictMath.cos(b)
            when (it % 3) {
                0 -> r * StrictMath.cos(a)
                1 -> small * StrictMath.sin(b)
                else -> -r * StrictMath.sin(a)
            }.toFloat()
        }
        val triangles = (0 until around).flatMap { i ->
            (0 until across).flatMap { j ->
                val p = i * across + j
                val q = (i + 1) % around * across + j
                val r = (i + 1) % around * across + (j + 1) % across
                val s = i * across + (j + 1) % across
                listOf(p, q, r, p, r, s)
            }
        }
        return Mesh(positions, triangles.toIntArray())
    }

    /** A sphere of radius 1: circles of latitude with [around] vertices each, and two poles. */
    fun sphere(around: Int, rings: Int): Mesh {
        val positions = ArrayList<Float>()
        for (ring in 1 until rings) {
            val b = StrictMath.PI * ring / rings
            for (i in 0 until around) {
                val a = 2 * StrictMath.PI * i / around
                positions += (StrictMath.sin(b) * StrictMath.cos(a)).toFloat()
                positions += StrictMath.cos(b).toFloat()
                positions += (-StrictMath.sin(b) * StrictMath.sin(a)).toFloat()
            }
        }
        val north = positions.size / 3
        positions += listOf(0f, 1f, 0f, 0f, -1f, 0f)
        val triangles = ArrayList<Int>()
        for (i in 0 until around) {
            val j = (i + 1) % around
            triangles += listOf(north, i, j)
            triangles += listOf(north + 1, (rings - 2) * around + j, (rings - 2) * around + i)
            for (ring in 0 until rings - 2) {
                val p = ring * around
                val q = (ring + 1) * around
                triangles += listOf(p + i, q + i, q + j, p + i, q + j, p + j)
            }
        }
        return Mesh(positions.toFloatArray(), triangles.toIntArray())
    }

    /** [mesh] with vertices of its own for each triangle. */
    fun split(mesh: Mesh): Mesh = Mesh(
        FloatArray(3 * mesh.triangles.size) { mesh.positions[3 * mesh.triangles[it / 3] + it % 3] },
        IntArray(mesh.triangles.size) { it },
        mesh.material,
    )
}
