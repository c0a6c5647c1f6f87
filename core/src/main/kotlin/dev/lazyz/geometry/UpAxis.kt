package dev.lazyz.geometry

import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * The axis of a model that points up. In Lazy Z it is y; `Scene.withUpAxis` rotates scenes in which it is another one.
 *
 * The rotation only exchanges and negates coordinates, so nothing is rounded: with z up, (x, y, z) becomes (x, z, -y).
 *
 * @property id short name: `x`, `-x`, `y`, `-y`, `z`, `-z`
 */
public enum class UpAxis(public val id: String, private val sources: IntArray, private val signs: IntArray) {
    /** (x, y, z) becomes (-y, x, z). */
    X("x", intArrayOf(1, 0, 2), intArrayOf(-1, 1, 1)),

    /** (x, y, z) becomes (y, -x, z). */
    MINUS_X("-x", intArrayOf(1, 0, 2), intArrayOf(1, -1, 1)),

    /** Nothing changes. */
    Y("y", intArrayOf(0, 1, 2), intArrayOf(1, 1, 1)),

    /** (x, y, z) becomes (x, -y, -z). */
    MINUS_Y("-y", intArrayOf(0, 1, 2), intArrayOf(1, -1, -1)),

    /** (x, y, z) becomes (x, z, -y). Usual in STL files, in 3MF files and in CAD. */
    Z("z", intArrayOf(0, 2, 1), intArrayOf(1, 1, -1)),

    /** (x, y, z) becomes (x, -z, y). */
    MINUS_Z("-z", intArrayOf(0, 2, 1), intArrayOf(1, -1, 1)),
    ;

    /** Returns the point or direction [v] of a model with this axis up, in a world with y up. A new vector. */
    public fun toWorld(v: Vector3dc): Vector3d = Vector3d(component(v, 0), component(v, 1), component(v, 2))

    /** Returns the point or direction of a model with this axis up that [toWorld] converts to [v]. A new vector. */
    public fun toModel(v: Vector3dc): Vector3d {
        val model = Vector3d()
        for (row in 0 until 3) model.setComponent(sources[row], if (signs[row] > 0) v.get(row) else -v.get(row))
        return model
    }

    /**
     * Returns points or directions in a world with y up. Each is the first three of [stride] numbers; the others are
     * kept. A new array, except for [Y].
     */
    internal fun toWorld(xyz: FloatArray, stride: Int = 3): FloatArray = if (this == Y) {
        xyz
    } else {
        val turned = FloatArray(xyz.size)
        for (row in 0 until stride) {
            val from = if (row < 3) sources[row] else row
            val isNegated = row < 3 && signs[row] < 0
            for (at in row until xyz.size step stride) {
                val number = xyz[at - row + from]
                turned[at] = if (isNegated) -number else number
            }
        }
        turned
    }

    private fun component(v: Vector3dc, row: Int): Double {
        val number = v.get(sources[row])

        // Without -0, so that the origin of the world stays what it is
        return if (signs[row] > 0) number else 0.0 - number
    }
}
