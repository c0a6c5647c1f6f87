package dev.lazyz.scenes.threemf

import dev.lazyz.Rgba
import dev.lazyz.geometry.Box
import dev.lazyz.scenes.LengthUnit
import dev.lazyz.scenes.collections.Floats
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.meshes.ColorNumbers
import dev.lazyz.scenes.meshes.TexturePlaces
import dev.lazyz.scenes.meshes.VertexArrays
import org.joml.Matrix4d
import org.joml.Vector3d

/** The content of a model part. Objects have the numbers that the part gives them. */
internal class ThreeMfModel(val path: String) {
    val objects = HashMap<Int, ThreeMfObject>()
    val looks = ThreeMfLooks()

    /** The items to build, in order. Only those of the package's main part are used. */
    val items = ArrayList<ObjectReference>()

    /** The unit of lengths. */
    var unit = LengthUnit.MILLIMETRE

    /** Whether the part requires slices to be understood. */
    var requiresSlices = false
}

/**
 * A reference to an object, with a transform.
 *
 * @property path the part that contains the object
 * @property number the object's number in that part
 * @property transform transform from the object's space to the space of the object or build that contains the reference
 */
internal class ObjectReference(val path: String, val number: Int, val transform: Matrix4d)

/**
 * An object to build: triangles, or a combination of other objects.
 *
 * @property isSupport whether the object only supports others during printing
 * @property name name in the file
 */
internal class ThreeMfObject(val isSupport: Boolean, val name: String) {
    val components = ArrayList<ObjectReference>()

    /** x, y, z of each vertex as the nearest floats. [remainders] are the numbers in the file minus these floats. */
    val positions = Floats()
    private val remainders = Floats()

    /** Vertex numbers, three for each triangle. */
    val triangles = Ints()

    /**
     * Four numbers for each triangle, up to the last triangle with a look: the number of its group, and for each corner
     * the index in the group. The group is -1 for triangles without their own look.
     */
    val looks = Ints()

    /**
     * The default look for triangles without their own: a group and an index in it. The group is -1 if there is none.
     */
    var defaultGroup = -1
    var defaultIndex = 0

    /** Adds a coordinate. [nearest] is the float that is nearest to it. */
    fun add(coordinate: Double, nearest: Float) {
        positions.add(nearest)
        remainders.add((coordinate - nearest).toFloat())
    }

    /**
     * Returns the vertices. If their distance from the world's origin is large compared to their extent, they are
     * relative to an origin of their own.
     */
    fun vertices(): VertexArrays {
        val near = positions.toArray()
        val origin = Box.around(near)?.origin()
        if (origin == null || origin == Vector3d()) return VertexArrays(near)
        val far = FloatArray(near.size) { (near[it] - origin.get(it % 3) + remainders[it]).toFloat() }
        return VertexArrays(far, origin = origin)
    }
}

/** The groups of colours and texture coordinates of a model part, by number, and their content. */
internal class ThreeMfLooks {
    val palette = ColorNumbers()
    val places = TexturePlaces()

    /** The textures by number. */
    val textures = HashMap<Int, ThreeMfTexture>()

    /** The groups by number. */
    val groups = HashMap<Int, Group>()

    /** Display properties by number: one for each element of the group that refers to them, or one with textures. */
    val finishes = HashMap<Int, List<ThreeMfFinish>>()

    /** Returns how element [index] of [group] reflects light, or null if the file does not say. */
    fun finish(group: Group, index: Int): ThreeMfFinish? {
        val owner = group.first ?: group
        val place = if (group.first == null) index else group.firstIndices[index]
        val found = finishes[owner.ownFinishes[place] ?: owner.finishes] ?: return null
        return found.singleOrNull()?.takeIf { it.textures != null } ?: found.getOrNull(place)
    }

    /**
     * A group that corners can refer to: [numbers] of colours, or of texture coordinates.
     *
     * @property texture number of the texture, or -1 for colours
     */
    class Group(val texture: Int = -1) {
        val numbers = Ints()

        /** The colour on which the texture lies, or null if there is none. */
        var ground: Rgba? = null

        /** The number of the display properties of all elements, or -1, and those that elements name themselves. */
        var finishes = -1
        val ownFinishes = HashMap<Int, Int>(0)

        /** The lowest of several layers, and which of its elements each element has; null for a group of one layer. */
        var first: Group? = null
        val firstIndices = Ints()
    }
}

/**
 * A texture in the package.
 *
 * @property path name of the part that contains the image
 * @property wrapU tiling in the direction of u: `wrap`, `mirror`, `clamp` or `none`; null if not given
 * @property wrapV tiling in the direction of v; see [wrapU]
 * @property isSmooth whether texels are interpolated
 */
internal class ThreeMfTexture(val path: String, val wrapU: String?, val wrapV: String?, val isSmooth: Boolean)
