package dev.lazyz.shading

import dev.lazyz.world.surface.Mesh

/**
 * Vertices in clip space with their attributes, [stride] numbers for each.
 *
 * The first four are the homogeneous position; x, y and z are in -w..w if it is visible. The others are attributes, in
 * the order of the constants below. Attributes that a surface does not have stay 0 and are not read.
 *
 * @property stride [STRIDE], or [LONG_STRIDE] if the vertices can have tangents or a second set of texture coordinates
 */
internal class Vertices(count: Int, @JvmField val stride: Int = STRIDE) {
    /** The numbers of all vertices. */
    var data: DoubleArray = DoubleArray(stride * count)
        private set

    /** Number of vertices. */
    var count: Int = count
        private set

    fun get(vertex: Int, field: Int): Double = data[stride * vertex + field]

    fun set(vertex: Int, field: Int, value: Double) {
        data[stride * vertex + field] = value
    }

    /** Sets the world position of [vertex] to that of vertex [from] of [mesh]. */
    fun setWorld(vertex: Int, mesh: Mesh, from: Int) {
        val at = stride * vertex + WORLD
        data[at] = mesh.positions[3 * from].toDouble()
        data[at + 1] = mesh.positions[3 * from + 1].toDouble()
        data[at + 2] = mesh.positions[3 * from + 2].toDouble()
    }

    /** Sets the attributes of [vertex], except its position, to those of vertex [from] of [mesh]. */
    fun setAttributes(vertex: Int, mesh: Mesh, from: Int) {
        setNormal(vertex, mesh, from)
        setUv(vertex, mesh, from)
        setColor(vertex, mesh, from)
        setUv2(vertex, mesh, from)
        setTangent(vertex, mesh, from)
    }

    /** Sets the normal of [vertex], if the mesh has normals. */
    fun setNormal(vertex: Int, mesh: Mesh, from: Int) {
        val normals = mesh.normals ?: return
        val at = stride * vertex + NORMAL
        data[at] = normals[3 * from].toDouble()
        data[at + 1] = normals[3 * from + 1].toDouble()
        data[at + 2] = normals[3 * from + 2].toDouble()
    }

    /** Sets the texture coordinates of [vertex], if the mesh has texture coordinates. */
    fun setUv(vertex: Int, mesh: Mesh, from: Int) {
        val uvs = mesh.uvs ?: return
        val at = stride * vertex + UV
        data[at] = uvs[2 * from].toDouble()
        data[at + 1] = uvs[2 * from + 1].toDouble()
    }

    /** Sets the colour of [vertex]: white if the mesh has no colours. */
    fun setColor(vertex: Int, mesh: Mesh, from: Int) {
        val colors = mesh.colors
        val at = stride * vertex + COLOR
        if (colors == null) return data.fill(1.0, at, at + 4)
        data[at] = colors[4 * from].toDouble()
        data[at + 1] = colors[4 * from + 1].toDouble()
        data[at + 2] = colors[4 * from + 2].toDouble()
        data[at + 3] = colors[4 * from + 3].toDouble()
    }

    /** Sets the second texture coordinates of [vertex], if the mesh has them. */
    fun setUv2(vertex: Int, mesh: Mesh, from: Int) {
        val uvs = mesh.uvs2 ?: return
        val at = stride * vertex + UV2
        data[at] = uvs[2 * from].toDouble()
        data[at + 1] = uvs[2 * from + 1].toDouble()
    }

    /** Sets the tangent of [vertex], if the mesh has tangents. */
    fun setTangent(vertex: Int, mesh: Mesh, from: Int) {
        val tangents = mesh.tangents ?: return
        val at = stride * vertex + TANGENT
        for (k in 0 until 4) data[at + k] = tangents[4 * from + k].toDouble()
    }

    /** Returns the weighted sum of the [field] of the vertices [a], [b] and [c]. */
    fun mixed(field: Int, a: Int, w0: Double, b: Int, w1: Double, c: Int, w2: Double): Double =
        w0 * get(a, field) + w1 * get(b, field) + w2 * get(c, field)

    /**
     * Returns how the weighted sum of the [field] of the vertices [a], [b] and [c] changes by a step, if it is [value]
     * before the step, and the step adds [s0], [s1] and [s2] to the weights before they are divided by their sum.
     *
     * This is the derivative of a quotient of two linear forms, (N / D)' = (N' - (N / D) D') / D.
     */
    fun slope(field: Int, value: Double, a: Int, s0: Double, b: Int, s1: Double, c: Int, s2: Double): Double =
        s0 * (get(a, field) - value) + s1 * (get(b, field) - value) + s2 * (get(c, field) - value)

    /** Returns a new object with copies of the vertices in [selection], in that order. */
    fun copyOf(selection: IntArray): Vertices {
        val copy = Vertices(selection.size, stride)
        for (i in selection.indices) copy.copy(this, selection[i], i)
        return copy
    }

    /** Copies vertex [vertex] of [from] to vertex [to]. */
    fun copy(from: Vertices, vertex: Int, to: Int) {
        val start = from.stride * vertex
        from.data.copyInto(data, stride * to, start, start + minOf(stride, from.stride))
    }

    /**
     * Appends the point where the edge from [inner] to [outer] intersects a plane, and returns its number. The distance
     * from the plane must be at least 0 at the inner vertex, and negative at the outer one.
     *
     * The point is computed from the vertex that is nearer to the plane, because rounding would remove all precision if
     * a very distant vertex were the start.
     */
    fun addCut(inner: Int, outer: Int, innerDistance: Double, outerDistance: Double): Int {
        if (stride * (count + 1) > data.size) data = data.copyOf(maxOf(2 * data.size, 8 * stride))
        val isInnerNearer = innerDistance <= -outerDistance
        val near = if (isInnerNearer) inner else outer
        val far = if (isInnerNearer) outer else inner
        val t = (if (isInnerNearer) innerDistance else -outerDistance) / (innerDistance - outerDistance)
        for (field in 0 until stride) {
            val from = get(near, field)
            set(count, field, from + t * (get(far, field) - from))
        }
        return count++
    }

    /** Whether the position of [vertex] is finite. */
    fun isFinite(vertex: Int): Boolean =
        get(vertex, X).isFinite() && get(vertex, Y).isFinite() && get(vertex, Z).isFinite() && get(vertex, W).isFinite()

    companion object {
        const val X: Int = 0
        const val Y: Int = 1
        const val Z: Int = 2
        const val W: Int = 3

        /** World position, three numbers. */
        const val WORLD: Int = 4

        /** Normal in world space, three numbers. */
        const val NORMAL: Int = 7

        /** Texture coordinates, two numbers. */
        const val UV: Int = 10

        /** Colour, four numbers. */
        const val COLOR: Int = 12

        const val STRIDE: Int = 16

        /** Texture coordinates of the second set, two numbers. */
        const val UV2: Int = 16

        /** Tangent in world space, three numbers, and its handedness. */
        const val TANGENT: Int = 18

        const val LONG_STRIDE: Int = 22

        /** Returns the stride of vertices with the attributes of [mesh]. */
        fun strideOf(mesh: Mesh): Int = if (mesh.uvs2 == null && mesh.tangents == null) STRIDE else LONG_STRIDE
    }
}
