package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.scenes.loading.PixelDefaults
import dev.lazyz.scenes.meshes.MissingNormals
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface

/** Points, and the three modes that join vertices to lines (section 3.7.2.1). */
internal object GltfPoints {
    const val POINTS = 0
    private const val LINES = 1
    private const val LOOP = 2

    /**
     * Returns the points or lines that the vertex numbers [indices] describe. An incomplete last line segment is
     * dropped.
     *
     * @param material null if the file gives none
     */
    fun of(
        mode: Int,
        indices: IntArray,
        positions: FloatArray,
        material: Material?,
        normals: FloatArray?,
        colors: FloatArray?,
    ): Surface {
        val own = if (mode == POINTS) MissingNormals.ofPoints(normals) else null
        val paint = material ?: PixelDefaults.material(own != null, colors != null)
        if (mode != POINTS) return Lines(positions, segments(mode, indices), PixelDefaults.LINE_WIDTH, paint, colors)
        return Points(
            gather(positions, indices, 3),
            PixelDefaults.POINT_SIZE,
            paint,
            own?.let { gather(it, indices, 3) },
            colors?.let { gather(it, indices, 4) },
        )
    }

    /** Returns vertex numbers, two for each segment. */
    fun segments(mode: Int, indices: IntArray): IntArray {
        if (mode == LINES) return indices.copyOf(indices.size / 2 * 2)
        val isClosed = mode == LOOP && indices.size > 1
        val count = maxOf(indices.size - 1, 0) + (if (isClosed) 1 else 0)
        return IntArray(2 * count) { indices[(it / 2 + it % 2) % indices.size] }
    }

    private fun gather(numbers: FloatArray, indices: IntArray, width: Int): FloatArray =
        FloatArray(width * indices.size) { numbers[width * indices[it / width] + it % width] }
}

/** The three modes that join vertices to triangles (section 3.7.2.1). */
internal object GltfTriangles {
    const val TRIANGLES = 4
    const val STRIP = 5
    const val FAN = 6

    /**
     * Returns vertex numbers, three for each triangle. All triangles have the same winding as the first. Vertices of an
     * incomplete last triangle are dropped.
     */
    fun of(mode: Int, indices: IntArray): IntArray {
        if (mode == TRIANGLES) return if (indices.size % 3 == 0) indices else indices.copyOf(indices.size / 3 * 3)
        val triangles = IntArray(3 * maxOf(indices.size - 2, 0))
        for (i in 0 until triangles.size / 3) {
            val isOdd = i % 2
            triangles[3 * i] = indices[if (mode == FAN) i + 1 else i]
            triangles[3 * i + 1] = indices[if (mode == FAN) i + 2 else i + 1 + isOdd]
            triangles[3 * i + 2] = indices[if (mode == FAN) 0 else i + 2 - isOdd]
        }
        return triangles
    }
}
