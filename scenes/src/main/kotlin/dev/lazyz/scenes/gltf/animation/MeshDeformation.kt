package dev.lazyz.scenes.gltf.animation

import dev.lazyz.world.surface.Mesh
import kotlin.math.sqrt

/**
 * The joints that move the vertices, and their weights: four of each for every vertex, as in `JOINTS_0` and
 * `WEIGHTS_0`.
 *
 * @property joints numbers of joints
 * @property weights weights, whose sum need not be 1
 */
internal class JointWeights(val joints: FloatArray, val weights: FloatArray)

/**
 * The differences that a morph target adds to a mesh (glTF 2.0, section 3.7.2.2).
 *
 * @property positions three numbers for each vertex, or null
 * @property normals three numbers for each vertex, or null
 * @property tangents three numbers for each vertex, or null: handedness does not change
 */
internal class MorphTarget(val positions: FloatArray?, val normals: FloatArray?, val tangents: FloatArray? = null)

/**
 * Deforms meshes. The given mesh is not changed; the result is a new one. All arithmetic uses doubles in a fixed order.
 */
internal object MeshDeformation {
    /** Returns [mesh] plus the sum of [targets], each multiplied by its number in [weights]. */
    fun morphed(mesh: Mesh, targets: List<MorphTarget>, weights: DoubleArray): Mesh {
        val positions = sums(mesh.positions, targets.map { it.positions }, weights)
        val normals = mesh.normals?.let { sums(it, targets.map { target -> target.normals }, weights) }
        val tangents = mesh.tangents?.let { own ->
            val axes =
                sums(
                    FloatArray(3 * mesh.vertexCount) {
                        own[it / 3 * 4 + it % 3]
                    },
                    targets.map { it.tangents }, weights
                )
            FloatArray(own.size) { if (it % 4 == 3) own[it] else axes[it / 4 * 3 + it % 4] }
        }
        return deformed(mesh, positions, normals, tangents, mesh.triangles)
    }

    private fun sums(base: FloatArray, additions: List<FloatArray?>, weights: DoubleArray): FloatArray {
        val sums = DoubleArray(base.size) { base[it].toDouble() }
        for ((addition, weight) in additions.zip(weights.asIterable())) {
            if (addition == null || weight == 0.0) continue
            for (i in sums.indices) sums[i] += weight * addition[i]
        }
        return FloatArray(sums.size) { sums[it].toFloat() }
    }

    /**
     * Returns [mesh] in the current pose of its joints (section 3.7.3.3). Weights are divided by their sum. A vertex
     * without weights follows its first joint.
     *
     * @param matrices for each joint, the transform from the mesh's space to world space
     * @param isMirror whether to reverse the winding of the triangles
     * @param look called before each vertex; throws to end the work
     * @throws IllegalArgumentException if a vertex follows a joint that does not exist
     */
    fun skinned(
        mesh: Mesh,
        sets: List<JointWeights>,
        matrices: List<DoubleArray>,
        isMirror: Boolean,
        look: () -> Unit = {},
    ): Mesh {
        val positions = FloatArray(mesh.positions.size)
        val normals = mesh.normals?.let { FloatArray(it.size) }
        val tangents = mesh.tangents?.let { FloatArray(it.size) }
        val matrix = DoubleArray(16)
        for (vertex in 0 until mesh.vertexCount) {
            look()
            blend(vertex, sets, matrices, matrix)
            move(matrix, mesh.positions, positions, 3 * vertex)
            if (normals != null) turn(matrix, checkNotNull(mesh.normals), normals, 3 * vertex)
            if (tangents != null) turnTangent(matrix, checkNotNull(mesh.tangents), tangents, 4 * vertex)
        }
        val triangles = if (isMirror) turnedRound(mesh.triangles) else mesh.triangles
        return deformed(mesh, positions, normals, tangents, triangles)
    }

    private fun blend(vertex: Int, sets: List<JointWeights>, matrices: List<DoubleArray>, matrix: DoubleArray) {
        var sum = 0.0
        for (set in sets) for (i in 4 * vertex until 4 * vertex + 4) sum += set.weights[i]
        val isBound = sum > 0.0 && sum.isFinite()
        matrix.fill(0.0)
        for (set in sets) {
            for (i in 4 * vertex until 4 * vertex + 4) {
                val first = set === sets[0] && i == 4 * vertex
                val weight = if (isBound) {
                    set.weights[i] / sum
                } else if (first) {
                    1.0
                } else {
                    0.0
                }
                if (weight == 0.0) continue
                val joint = set.joints[i].toInt()
                require(joint in matrices.indices) {
                    "vertex $vertex follows joint $joint, but there are ${matrices.size}, counted from 0"
                }
                for (k in matrix.indices) matrix[k] += weight * matrices[joint][k]
            }
        }
    }

    private fun move(m: DoubleArray, from: FloatArray, to: FloatArray, at: Int) {
        val x = from[at].toDouble()
        val y = from[at + 1].toDouble()
        val z = from[at + 2].toDouble()
        for (row in 0 until 3) to[at + row] = (m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]).toFloat()
    }

    /** Transforms a tangent like a direction. A mirror reverses its handedness. */
    private fun turnTangent(m: DoubleArray, from: FloatArray, to: FloatArray, at: Int) {
        for (row in 0 until 3) {
            to[at + row] = (m[row] * from[at] + m[4 + row] * from[at + 1] + m[8 + row] * from[at + 2]).toFloat()
        }
        val determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) +
            m[8] * (m[1] * m[6] - m[2] * m[5])
        to[at + 3] = if (determinant < 0.0) -from[at + 3] else from[at + 3]
    }

    /**
     * Transforms a normal by the cofactors of the matrix. They are the inverse transpose, except for a factor that may
     * be negative.
     */
    private fun turn(m: DoubleArray, from: FloatArray, to: FloatArray, at: Int) {
        val cofactors = DoubleArray(9) { i ->
            val c = i / 3
            val r = i % 3
            val c1 = 4 * ((c + 1) % 3)
            val c2 = 4 * ((c + 2) % 3)
            val r1 = (r + 1) % 3
            val r2 = (r + 2) % 3
            m[c1 + r1] * m[c2 + r2] - m[c1 + r2] * m[c2 + r1]
        }
        val determinant = m[0] * cofactors[0] + m[1] * cofactors[1] + m[2] * cofactors[2]
        val sign = if (determinant < 0.0) -1.0 else 1.0
        val turned = DoubleArray(3) { row ->
            sign * (cofactors[row] * from[at] + cofactors[3 + row] * from[at + 1] + cofactors[6 + row] * from[at + 2])
        }
        val length = sqrt(turned[0] * turned[0] + turned[1] * turned[1] + turned[2] * turned[2])
        val scale = if (length > 0.0 && length.isFinite()) 1.0 / length else 0.0
        for (row in 0 until 3) to[at + row] = (turned[row] * scale).toFloat()
    }

    private fun turnedRound(triangles: IntArray): IntArray = IntArray(triangles.size) {
        when (it % 3) {
            0 -> triangles[it]
            1 -> triangles[it + 1]
            else -> triangles[it - 1]
        }
    }

    private fun deformed(
        mesh: Mesh,
        positions: FloatArray,
        normals: FloatArray?,
        tangents: FloatArray?,
        triangles: IntArray,
    ): Mesh = Mesh(
        positions, triangles, mesh.material, normals, mesh.uvs, mesh.colors, uvs2 = mesh.uvs2, tangents = tangents,
        name = mesh.name,
    )
}
