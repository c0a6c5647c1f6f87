package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.geometry.Transforms
import dev.lazyz.scenes.gltf.document.ElementType
import dev.lazyz.scenes.gltf.document.GltfAccessors
import dev.lazyz.scenes.gltf.document.GltfDocument

/**
 * Instances of meshes, by `EXT_mesh_gpu_instancing`: a node shows its mesh once for each element of the accessors for
 * translation, rotation and scale.
 */
internal class GltfInstances(private val document: GltfDocument, private val accessors: GltfAccessors) {
    /** Returns [placed] once for each instance of its mesh, or [placed] itself if the node has no instances. */
    fun of(placed: PlacedNode): List<PlacedNode> {
        val extension = placed.node.extension(NAME) ?: return listOf(placed)
        val attributes = extension["attributes"] as? Map<*, *> ?: return listOf(placed)
        val where = "nodes[${placed.index}].extensions.$NAME.attributes"
        val used = types.filterKeys { it in attributes }.mapValues { (name, type) ->
            accessors.floats((attributes[name] as? Number)?.toInt(), "$where.$name", type)
        }
        val counts = used.map { (name, numbers) -> numbers.size / types.getValue(name).numComponents }.distinct()
        if (counts.size > 1) document.fail(where, "the accessors have different lengths: ${counts.joinToString()}")
        val count = counts.firstOrNull() ?: return listOf(placed)
        if (placed.node.skin != null) {
            document.count("instances of meshes with a skin are left out", count - 1)
            return listOf(placed)
        }
        document.source.loading.decode(document.source, count * INSTANCE_BYTES)
        val instances = (0 until count).mapNotNull { instance(placed, used, it) }
        document.count("instances whose transform is not finite are left out", count - instances.size)
        return instances
    }

    private fun instance(placed: PlacedNode, used: Map<String, FloatArray>, index: Int): PlacedNode? {
        document.source.step(INSTANCE_STEPS)
        fun element(name: String): DoubleArray? = used[name]?.let { numbers ->
            val width = types.getValue(name).numComponents
            DoubleArray(width) { numbers[width * index + it].toDouble() }
        }
        val toNode = NodeTransforms.of(element(TRANSLATION), element(ROTATION)?.let(::unit), element(SCALE))
        val toWorld = Transforms.product(placed.toWorld, toNode)
        if (!toWorld.isFinite) return null
        return PlacedNode(placed.node, placed.index, toWorld, placed.path, placed.isVisible)
    }

    /** Returns the quaternion with length 1: integers give it only nearly. */
    private fun unit(rotation: DoubleArray): DoubleArray {
        val length = StrictMath.sqrt(rotation.sumOf { it * it })
        return if (length > 0.0) DoubleArray(4) { rotation[it] / length } else rotation
    }

    companion object {
        const val NAME: String = "EXT_mesh_gpu_instancing"
        private const val TRANSLATION = "TRANSLATION"
        private const val ROTATION = "ROTATION"
        private const val SCALE = "SCALE"
        private val types =
            mapOf(TRANSLATION to ElementType.VEC3, ROTATION to ElementType.VEC4, SCALE to ElementType.VEC3)

        /** Steps of work for an instance. */
        private const val INSTANCE_STEPS = 10

        /** Memory for the objects of an instance without its surfaces. */
        private const val INSTANCE_BYTES = 256L
    }
}
