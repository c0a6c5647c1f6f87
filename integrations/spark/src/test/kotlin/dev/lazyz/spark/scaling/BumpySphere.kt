package dev.lazyz.spark.scaling

import dev.lazyz.spark.triangles.TriangleScene
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.surface.Mesh
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory

/** Which triangles a partition has. */
internal enum class Split {
    /** A range of submission indices, which are near each other in space: as in most files. */
    RANGES,

    /** Any triangles of the mesh, at random. */
    SCATTERED,
}

/**
 * A sphere with bumps, which hide each other, as rows of a table of triangles. Immutable.
 *
 * @param rings squares from pole to pole; around the sphere there are twice as many
 */
internal class BumpySphere(private val rings: Int) {
    private val columns = 2 * rings
    private val positions = FloatArray(3 * (rings + 1) * (columns + 1))

    init {
        for (i in 0..rings) ring(rings, i).let { it.copyInto(positions, i * it.size) }
    }

    /** Number of triangles. */
    val triangles: Int = 2 * rings * columns

    /** Returns the camera that shows the sphere. */
    fun camera(width: Int, height: Int): Camera {
        val mesh = Mesh(positions, IntArray(3 * triangles) { vertex(it / 3, it % 3) })
        return SCENE.scene(mesh).camera(width, height)
    }

    /** Returns the rows of partition [part] of [parts]. */
    fun rows(part: Int, parts: Int, split: Split): List<Row> = when (split) {
        Split.RANGES -> (start(part, parts) until start(part + 1, parts)).map(::row)
        Split.SCATTERED -> (0 until triangles).filter { Math.floorMod(mixed(it), parts) == part }.map(::row)
    }

    private fun start(part: Int, parts: Int): Int = (triangles.toLong() * part / parts).toInt()

    /** The multiplicative hash of Knuth, The Art of Computer Programming 3, section 6.4: its upper bits are mixed. */
    private fun mixed(index: Int): Int = (index * KNUTH) ushr 12

    private fun row(index: Int): Row {
        val values = arrayOfNulls<Any>(10)
        values[0] = index.toLong()
        for (i in 0 until 9) values[1 + i] = positions[3 * vertex(index, i / 3) + i % 3]
        return RowFactory.create(*values)
    }

    /** Returns the number of the vertex at a [corner] of a triangle. */
    private fun vertex(index: Int, corner: Int): Int {
        val square = index / 2
        val first = square / columns * (columns + 1) + square % columns
        val below = columns + 1
        return first + if (index % 2 == 0) intArrayOf(0, 1, below)[corner] else intArrayOf(1, below + 1, below)[corner]
    }

    companion object {
        /** Returns x, y, z of each vertex of ring [i] from the pole, of a sphere of so many [rings]. */
        fun ring(rings: Int, i: Int): FloatArray {
            val columns = 2 * rings
            val ring = FloatArray(3 * (columns + 1))
            val down = PI * i / rings
            for (j in 0..columns) {
                val around = 2 * PI * j / columns
                val radius = 1 + BUMP * sin(WAVES * down) * cos(WAVES * around)
                ring[3 * j] = (radius * sin(down) * cos(around)).toFloat()
                ring[3 * j + 1] = (radius * cos(down)).toFloat()
                ring[3 * j + 2] = (radius * sin(down) * sin(around)).toFloat()
            }
            return ring
        }

        /** The scene around any of the triangles. */
        val SCENE: TriangleScene = TriangleScene { Scene(listOf(it)) }

        private const val BUMP = 0.1
        private const val WAVES = 12
        private const val KNUTH = -1640531535
    }
}
