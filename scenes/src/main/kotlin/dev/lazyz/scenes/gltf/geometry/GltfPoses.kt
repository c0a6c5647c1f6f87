package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.geometry.Transforms
import dev.lazyz.scenes.gltf.animation.JointWeights
import dev.lazyz.scenes.gltf.animation.MeshDeformation
import dev.lazyz.scenes.gltf.animation.MorphTarget
import dev.lazyz.scenes.gltf.animation.NodePose
import dev.lazyz.scenes.gltf.document.ElementType
import dev.lazyz.scenes.gltf.document.GltfAccessors
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.MeshJson
import dev.lazyz.scenes.gltf.document.PrimitiveJson
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
import org.joml.Matrix4d

/**
 * A primitive as stored in the file.
 *
 * @property surface a mesh, points or lines, in its own space
 * @property vertices gives access to the other attributes
 * @property where the place of the primitive in the file
 */
internal class GltfPart(
    val surface: Surface,
    val primitive: PrimitiveJson,
    val vertices: GltfVertices,
    val where: String,
) {
    /** The surface, which must be a mesh. */
    val mesh: Mesh get() = surface as Mesh
}

/**
 * Converts meshes from their stored form to the form that a node shows: applies morph targets, then the skin or the
 * node's transform.
 */
internal class GltfPoses(
    private val document: GltfDocument,
    private val accessors: GltfAccessors,
    private val skins: GltfSkins,
    private val poses: Map<Int, NodePose>,
) {
    /** Returns [part] of the mesh [json] as shown by the node [placed], in world space. */
    fun posed(part: GltfPart, json: MeshJson, placed: PlacedNode): Surface {
        if (part.surface !is Mesh) return moved(part, placed)
        val morphed = morphed(part, json, placed)
        val skin = placed.node.skin
        val sets = if (skin == null) emptyList() else jointWeights(part)
        if (skin != null && sets.isNotEmpty()) {
            val matrices = skins.matrices(skin, "nodes[${placed.index}].skin")
            try {
                copied(part)
                return MeshDeformation.skinned(morphed, sets, matrices, NodeTransforms.isMirror(placed.toWorld)) {
                    document.source.step(VERTEX_STEPS)
                }
            } catch (e: IllegalArgumentException) {
                document.source.fail("${part.where}.attributes", "${e.message}", "export the model again", e)
            }
        }
        if (NodeTransforms.isIdentity(placed.toWorld)) return morphed
        copied(part)
        return morphed.transformed(placed.toWorld)
    }

    /** Returns points or lines moved by the node's transform. Skins and morph targets are not applied to them. */
    private fun moved(part: GltfPart, placed: PlacedNode): Surface {
        if (placed.node.skin != null || part.primitive.targets.isNotEmpty()) {
            document.count("skins and morph targets of points and lines are not applied")
        }
        val surface = part.surface
        if (NodeTransforms.isIdentity(placed.toWorld)) return surface
        val source = document.source
        return when (surface) {
            is Points -> surface.also { source.loading.vertices(source, it.pointCount.toLong()) }
                .transformed(placed.toWorld)
            is Lines -> surface.also { source.loading.vertices(source, it.vertexCount.toLong()) }
                .transformed(placed.toWorld)
            else -> error("no reader makes a $surface")
        }
    }

    /** Counts the memory of one more copy of the mesh: each node that shows it needs its own. */
    private fun copied(part: GltfPart) =
        document.source.loading.vertices(document.source, part.mesh.vertexCount.toLong())

    private fun morphed(part: GltfPart, json: MeshJson, placed: PlacedNode): Mesh {
        val targets = part.primitive.targets
        val animated = poses[placed.index]?.weights
        val stored = placed.node.weights ?: json.weights
        val weights = DoubleArray(targets.size) { animated?.getOrNull(it) ?: stored?.getOrNull(it)?.toDouble() ?: 0.0 }
        if (weights.all { it == 0.0 }) return part.mesh
        copied(part)
        val morphs = targets.mapIndexed { i, target ->
            if (weights[i] == 0.0) {
                MorphTarget(null, null)
            } else {
                target(part, target.orEmpty(), "${part.where}.targets[$i]")
            }
        }
        return MeshDeformation.morphed(part.mesh, morphs, weights)
    }

    private fun target(part: GltfPart, target: Map<String, Int?>, where: String): MorphTarget {
        val count = part.mesh.vertexCount

        fun additions(name: String): FloatArray? {
            val index = target[name] ?: return null
            document.source.loading.decode(document.source, count * VECTOR_BYTES)
            val numbers = accessors.floats(index, "$where.$name", ElementType.VEC3)
            part.vertices.checkCount(numbers, 3, count, "$where.$name")
            return numbers
        }
        return MorphTarget(
            additions("POSITION"),
            additions("NORMAL"),
            if (part.mesh.tangents == null) null else additions("TANGENT"),
        )
    }

    /** Returns the sets of joints and weights, in the order of their numbers. */
    private fun jointWeights(part: GltfPart): List<JointWeights> {
        val vertices = part.vertices
        val count = part.mesh.vertexCount
        return generateSequence(0) { it + 1 }.map { set ->
            val joints = vertices.floats("JOINTS_$set", ElementType.VEC4)
            val weights = vertices.floats("WEIGHTS_$set", ElementType.VEC4)
            if (joints == null || weights == null) return@map null
            vertices.checkCount(joints, 4, count, "${part.where}.attributes.JOINTS_$set")
            vertices.checkCount(weights, 4, count, "${part.where}.attributes.WEIGHTS_$set")
            JointWeights(joints, weights)
        }.takeWhile { it != null }.filterNotNull().toList()
    }

    private companion object {
        /** Steps of work for a vertex that follows joints. */
        const val VERTEX_STEPS = 10
        const val VECTOR_BYTES = 12L
    }
}

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
