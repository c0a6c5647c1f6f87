package dev.lazyz.strategies.bsp

import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.world.surface.Mesh
import java.lang.ref.SoftReference
import java.lang.ref.WeakReference
import java.util.WeakHashMap
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * The triangles of meshes in a binary tree of planes: at each node the triangles that a plane cuts or contains, below
 * it those on either side. It depends on the meshes alone, so one tree serves all cameras. Immutable and thread safe.
 *
 * Nodes are numbered from [ROOT] on, each before those below it. Triangles have the numbers of the meshes, one after
 * the other. Sides are those of rounded positions: what follows from them must be proved on the screen.
 *
 * Memory: 4 bytes a triangle, and 44 a node; 36 bytes a triangle more while it is made. Time: O(n log n) where planes
 * cut few triangles.
 */
internal class PlaneTree private constructor(
    private val faces: IntArray,
    private val starts: IntArray,
    private val planes: DoubleArray,
    private val below: IntArray,
) {
    /** Number of nodes. */
    val size: Int get() = starts.size - 1

    /** Bytes held. */
    val bytes: Long get() = faces.bytes + starts.bytes + planes.bytes + below.bytes

    /** Returns the place of the first triangle of [node]; its last one is before the first of node + 1. */
    fun start(node: Int): Int = starts[node]

    /** Returns the triangle at a place. */
    fun face(place: Int): Int = faces[place]

    /** Whether there are nodes below [node], always two. If not, it has no plane. */
    fun isInner(node: Int): Boolean = below[node] != NONE

    /** Returns the node with what is on the negative side of the plane of [node], or the positive one. */
    fun below(node: Int, isPositive: Boolean): Int = if (isPositive) below[node] else node + 1

    /** Returns coefficient [k] of the plane a x + b y + c z + d = 0. */
    fun plane(node: Int, k: Int): Double = planes[4 * node + k]

    /** Divides triangles, see [PlaneTree]. */
    private class Division(meshes: List<Mesh>) {
        private val count = meshes.sumOf { it.triangleCount }

        /** Positions of the corners, nine numbers a triangle. */
        private val corners = FloatArray(9 * count)
        private val faces = IntArray(count) { it }
        private var starts = IntArray(INITIAL)
        private var planes = DoubleArray(4 * INITIAL)
        private var below = IntArray(INITIAL)
        private var nodes = 0

        /** Up to this distance, a corner is in a plane: positions have 24 bits. */
        private val tolerance: Double

        private val candidate = DoubleArray(4)
        private val chosen = DoubleArray(4)
        private val middles = FloatArray(SAMPLE)

        init {
            var used = 0
            var most = 0f
            for (mesh in meshes) {
                for (vertex in mesh.triangles) {
                    if (used % CHECKED == 0) endIfInterrupted()
                    for (k in 0 until 3) {
                        val x = mesh.positions[3 * vertex + k]
                        if (abs(x) > most && x.isFinite()) most = abs(x)
                        corners[used++] = x
                    }
                }
            }
            tolerance = most * ROUNDING
        }

        fun tree(): PlaneTree {
            divide(0, count, 0)
            return PlaneTree(faces, starts.copyOf(nodes) + count, planes.copyOf(4 * nodes), below.copyOf(nodes))
        }

        /** Makes a node of the triangles at the places [from] until [until], and those below it. */
        private fun divide(from: Int, until: Int, level: Int) {
            endIfInterrupted()
            val node = nodes++
            if (nodes > starts.size) {
                starts = starts.copyOf(2 * nodes)
                planes = planes.copyOf(8 * nodes)
                below = below.copyOf(2 * nodes)
            }
            starts[node] = from
            below[node] = NONE
            if (until - from <= FEW || level == MOST_LEVELS - 1 || !choose(from, until)) return
            chosen.copyInto(planes, 4 * node)

            // First those of the node, then the negative side, then the positive
            var own = from
            var positive = until
            var place = from
            while (place < positive) {
                if (place % CHECKED == 0) endIfInterrupted()
                when (side(faces[place], chosen)) {
                    0 -> swap(place++, own++)
                    1 -> swap(place, --positive)
                    else -> place++
                }
            }
            divide(own, positive, level + 1)
            below[node] = nodes
            divide(positive, until, level + 1)
        }

        private fun swap(a: Int, b: Int) {
            val face = faces[a]
            faces[a] = faces[b]
            faces[b] = face
        }

        /**
         * Chooses the plane that decides the order of most pairs: planes of triangles, and those halfway along the
         * axes. Judges by a sample of the triangles. Returns false if no plane has triangles on both sides.
         */
        private fun choose(from: Int, until: Int): Boolean {
            var best = Long.MIN_VALUE
            for (number in 0 until AXES + TRIANGLES) {
                if (number < AXES) halve(from, until, number) else triangle(from, until, number - AXES)
                val counts = IntArray(3)
                sample(from, until) { face -> counts[side(face, candidate) + 1]++ }
                val score = 2L * counts[0] * counts[2] - counts[1].toLong() * (counts[0] + counts[1] + counts[2])
                if (score > best && counts[0] > 0 && counts[2] > 0) {
                    best = score
                    candidate.copyInto(chosen)
                }
            }
            return best > Long.MIN_VALUE
        }

        private inline fun sample(from: Int, until: Int, action: (face: Int) -> Unit) {
            val size = minOf(SAMPLE, until - from)
            for (i in 0 until size) action(faces[from + ((until - from).toLong() * i / size).toInt()])
        }

        private fun halve(from: Int, until: Int, axis: Int) {
            var count = 0
            sample(from, until) { face -> middles[count++] = corners[9 * face + axis] }
            middles.sort(0, count)
            candidate.fill(0.0)
            candidate[axis] = 1.0
            candidate[3] = -middles[count / 2].toDouble()
        }

        /** The plane of one of [TRIANGLES] triangles; no plane if it has no area. */
        private fun triangle(from: Int, until: Int, number: Int) {
            val at = 9 * faces[from + ((until - from).toLong() * number / TRIANGLES).toInt()]
            val ux = corners[at + 3].toDouble() - corners[at]
            val uy = corners[at + 4].toDouble() - corners[at + 1]
            val uz = corners[at + 5].toDouble() - corners[at + 2]
            val vx = corners[at + 6].toDouble() - corners[at]
            val vy = corners[at + 7].toDouble() - corners[at + 1]
            val vz = corners[at + 8].toDouble() - corners[at + 2]
            val nx = uy * vz - uz * vy
            val ny = uz * vx - ux * vz
            val nz = ux * vy - uy * vx
            val length = sqrt(nx * nx + ny * ny + nz * nz)
            candidate[0] = nx / length
            candidate[1] = ny / length
            candidate[2] = nz / length
            candidate[3] =
                -(candidate[0] * corners[at] + candidate[1] * corners[at + 1] + candidate[2] * corners[at + 2])
        }

        /** Returns the side of [plane] on which a triangle is, -1 or 1; 0 if it is in the plane, cut, or not finite. */
        private fun side(face: Int, plane: DoubleArray): Int {
            var isNegative = true
            var isPositive = true
            for (at in 9 * face until 9 * face + 9 step 3) {
                val height = plane[0] * corners[at] + plane[1] * corners[at + 1] + plane[2] * corners[at + 2] + plane[3]
                isNegative = isNegative && height <= tolerance
                isPositive = isPositive && height >= -tolerance
            }
            return when {
                isNegative == isPositive -> 0
                isPositive -> 1
                else -> -1
            }
        }
    }

    /** The tree of the arrays of some meshes, which it does not keep in memory. */
    private class Known(meshes: List<Mesh>, tree: PlaneTree) {
        private val positions = meshes.map { WeakReference(it.positions) }
        private val triangles = meshes.map { WeakReference(it.triangles) }
        private val tree = SoftReference(tree)

        fun treeOf(meshes: List<Mesh>): PlaneTree? = tree.get().takeIf {
            meshes.size == positions.size && meshes.indices.all { i ->
                positions[i].get() === meshes[i].positions && triangles[i].get() === meshes[i].triangles
            }
        }
    }

    companion object {
        const val ROOT: Int = 0

        /** Most nodes from the root down. */
        const val MOST_LEVELS: Int = 48

        /** So many triangles are not divided. */
        private const val FEW = 2

        /** Triangles by which a plane is judged, and planes to judge. */
        private const val SAMPLE = 64
        private const val AXES = 3
        private const val TRIANGLES = 5

        private const val NONE = -1
        private const val INITIAL = 16
        private const val CHECKED = 3 shl 12
        private const val ROUNDING = 1.0 / (1 shl 20)

        /** The latest tree of each first mesh, by its positions. */
        private val known = WeakHashMap<FloatArray, Known>()

        /** Returns the tree of [meshes], at least one. Makes it once, as long as the meshes and it are in memory. */
        fun of(meshes: List<Mesh>): PlaneTree {
            val key = meshes[0].positions
            synchronized(known) { known[key] }?.treeOf(meshes)?.let { return it }
            val tree = Division(meshes).tree()
            synchronized(known) { known[key] = Known(meshes, tree) }
            return tree
        }
    }
}
