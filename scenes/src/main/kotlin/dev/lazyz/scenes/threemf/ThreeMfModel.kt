package dev.lazyz.scenes.threemf

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.collections.Floats
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.meshes.VertexArrays
import org.joml.Matrix4d
import org.joml.Vector3d

/** What a model part defines, by the numbers that the part gives to it. */
internal class ThreeMfModel(val path: String) {
    val objects = HashMap<Int, ThreeMfObject>()
    val looks = ThreeMfLooks()

    /** The items to build, in order; of the first part only. */
    val items = ArrayList<Placement>()
}

/**
 * An object put somewhere.
 *
 * @property path the part that the object is in
 * @property number the object's there
 * @property transform where to
 */
internal class Placement(val path: String, val number: Int, val transform: Matrix4d)

/**
 * A thing to build: triangles, or other objects put together.
 *
 * @property isSupport whether it is there only to hold up others while they are printed
 * @property name what the file calls it
 */
internal class ThreeMfObject(val isSupport: Boolean, val name: String) {
    val components = ArrayList<Placement>()

    /** x, y, z of each vertex: the nearest floats, and what the numbers in the file are more than those. */
    val positions = Floats()
    private val remainders = Floats()

    /** Three vertex numbers a triangle. */
    val triangles = Ints()

    /**
     * For each triangle up to the last that has them, the number of the group of its looks, and three numbers in it, one
     * a corner; the group is -1 where it has none.
     */
    val looks = Ints()

    /** The group and the number in it for triangles without looks of their own; the group is -1 if there are none. */
    var defaultGroup = -1
    var defaultIndex = 0

    /** Adds a coordinate, which is nearest to the float [nearest]. */
    fun add(coordinate: Double, nearest: Float) {
        positions.add(nearest)
        remainders.add((coordinate - nearest).toFloat())
    }

    /** Returns the vertices; relative to an origin if they are far away from that of the world, for their size. */
    fun vertices(): VertexArrays {
        val near = positions.toArray()
        val origin = Box.around(near)?.origin()
        if (origin == null || origin == Vector3d()) return VertexArrays(near)
        val far = FloatArray(near.size) { (near[it] - origin.get(it % 3) + remainders[it]).toFloat() }
        return VertexArrays(far, origin = origin)
    }
}
