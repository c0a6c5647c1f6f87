package dev.lazyz.shading

import dev.lazyz.world.Mesh

/**
 * Vertices in clip space with their attributes, [STRIDE] numbers for each.
 *
 * The first four are the homogeneous position; x, y and z are in -w..w if it is visible. The others are attributes, in
 * the order of the constants below. Attributes that a surface does not have stay 0 and are not read.
 */
internal class Vertices(count: Int) {
    /** The numbers of all vertices. */
    var data: DoubleArray = DoubleArray(STRIDE * count)
        private set

    /** Number of vertices. */
    var count: Int = count
        private set

    fun get(vertex: Int, field: Int): Double = data[STRIDE * vertex + field]

    fun set(vertex: Int, field: Int, value: Double) {
        data[STRIDE * vertex + field] = value
    }

    /** Sets the world position of [vertex] to that of vertex [from] of [mesh]. */
    fun setWorld(vertex: Int, mesh: Mesh, from: Int) {
        val at = STRIDE * vertex + WORLD
        data[at] = mesh.positions[3 * from].toDouble()
        data[at + 1] = mesh.positions[3 * from + 1].toDouble()
        data[at + 2] = mesh.positions[3 * from + 2].toDouble()
    }

    /** Sets the attributes of [vertex], except its position, to those of vertex [from] of [mesh]. */
    fun setAttributes(vertex: Int, mesh: Mesh, from: Int) {
        setNormal(vertex, mesh, from)
        setUv(vertex, mesh, from)
        setColor(vertex, mesh, from)
    }

    /** Sets the normal of [vertex], if the mesh has normals. */
    fun setNormal(vertex: Int, mesh: Mesh, from: Int) {
        val normals = mesh.normals ?: return
        val at = STRIDE * vertex + NORMAL
        data[at] = normals[3 * from].toDouble()
        data[at + 1] = normals[3 * from + 1].toDouble()
        data[at + 2] = normals[3 * from + 2].toDouble()
    }

    /** Sets the texture coordinates of [vertex], if the mesh has texture coordinates. */
    fun setUv(vertex: Int, mesh: Mesh, from: Int) {
        val uvs = mesh.uvs ?: return
        val at = STRIDE * vertex + UV
        data[at] = uvs[2 * from].toDouble()
        data[at + 1] = uvs[2 * from + 1].toDouble()
    }

    /** Sets the colour of [vertex]: white if the mesh has no colours. */
    fun setColor(vertex: Int, mesh: Mesh, from: Int) {
        val colors = mesh.colors
        val at = STRIDE * vertex + COLOR
        if (colors == null) return data.fill(1.0, at, at + 4)
        data[at] = colors[4 * from].toDouble()
        data[at + 1] = colors[4 * from + 1].toDouble()
        data[at + 2] = colors[4 * from + 2].toDouble()
        data[at + 3] = colors[4 * from + 3].toDouble()
    }

    /** Returns the weighted sum of the [field] of the vertices [a], [b] and [c]. */
    fun mixed(field: Int, a: Int, w0: Double, b: Int, w1: Double, c: Int, w2: Double): Double =
        w0 * get(a, field) + w1 * get(b, field) + w2 * get(c, field)

    /** Returns a new object with copies of the vertices in [selection], in that order. */
    fun copyOf(selection: IntArray): Vertices {
        val copy = Vertices(selection.size)
        for (i in selection.indices) copy.copy(this, selection[i], i)
        return copy
    }

    /** Copies vertex [vertex] of [from] to vertex [to]. */
    fun copy(from: Vertices, vertex: Int, to: Int) {
        from.data.copyInto(data, STRIDE * to, STRIDE * vertex, STRIDE * (vertex + 1))
    }

    /**
     * Appends the point where the edge from [inner] to [outer] intersects a plane, and returns its number. The distance
     * from the plane must be at least 0 at the inner vertex, and negative at the outer one.
     *
     * The point is computed from the vertex that is nearer to the plane, because rounding would remove all precision if
     * a very distant vertex were the start.
     */
    fun addCut(inner: Int, outer: Int, innerDistance: Double, outerDistance: Double): Int {
        if (STRIDE * (count + 1) > data.size) data = data.copyOf(maxOf(2 * data.size, 8 * STRIDE))
        val isInnerNearer = innerDistance <= -outerDistance
        val near = if (isInnerNearer) inner else outer
        val far = if (isInnerNearer) outer else inner
        val t = (if (isInnerNearer) innerDistance else -outerDistance) / (innerDistance - outerDistance)
        for (field in 0 until STRIDE) {
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
    }
}
