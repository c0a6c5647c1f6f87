package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.geometry.Transforms
import dev.lazyz.scenes.gltf.document.ElementType
import dev.lazyz.scenes.gltf.document.GltfAccessors
import dev.lazyz.scenes.gltf.document.GltfDocument
import org.joml.Matrix4d

/** Skins (section 3.7.3): the current transforms of joints. */
internal class GltfSkins(
    private val document: GltfDocument,
    private val accessors: GltfAccessors,
    private val nodes: GltfNodes,
) {
    private val skins = HashMap<Int, List<DoubleArray>>()

    /**
     * Returns a matrix for each joint of the skin with number [index], from the mesh's space to world space. [where] is
     * the place that refers to the skin.
     */
    fun matrices(index: Int, where: String): List<DoubleArray> {
        val skin = document.element(document.json.skins, index, "skins", where)
        val here = "skins[$index]"
        return skins.getOrPut(index) {
            val joints = skin.joints
            val inverses = skin.inverseBindMatrices?.let {
                accessors.floats(it, "$here.inverseBindMatrices", ElementType.MAT4)
            }
            if (inverses != null && inverses.size < 16 * joints.size) {
                val count = inverses.size / 16
                document.fail("$here.inverseBindMatrices", "there are $count matrices for ${joints.size} joints")
            }
            document.source.loading.decode(document.source, joints.size * MATRIX_BYTES)
            joints.mapIndexed { i, joint ->
                val toWorld = nodes.toWorld(joint ?: -1, "$here.joints[$i]")
                if (inverses == null) elements(toWorld) else elements(Transforms.product(toWorld, matrix(inverses, i)))
            }
        }
    }

    private fun matrix(numbers: FloatArray, index: Int): Matrix4d =
        Matrix4d().set(DoubleArray(16) { numbers[16 * index + it].toDouble() })

    private fun elements(matrix: Matrix4d): DoubleArray = matrix.get(DoubleArray(16))

    private companion object {
        const val MATRIX_BYTES = 144L
    }
}
