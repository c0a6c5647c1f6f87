package dev.lazyz.scenes.gltf.animation

import dev.lazyz.scenes.gltf.document.AnimationJson
import dev.lazyz.scenes.gltf.document.ChannelJson
import dev.lazyz.scenes.gltf.document.ElementType
import dev.lazyz.scenes.gltf.document.GltfAccessors
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.KeyframesJson

/** The first animation of the file at one moment (section 3.11). Channels that do not target nodes are ignored. */
internal class GltfAnimation(private val document: GltfDocument, private val accessors: GltfAccessors) {
    /**
     * Returns the values that the animation gives to nodes at [time] in seconds, by node number. The map is empty if
     * [time] is null.
     */
    fun poses(time: Double?): Map<Int, NodePose> {
        val animations = document.json.animations
        if (time == null) {
            if (animations.isNotEmpty()) document.warn("animations are not applied: ${animations.size}; $HINT")
            return emptyMap()
        }
        if (animations.isEmpty()) {
            document.warn("there is no animation, so the animation time has no effect")
            return emptyMap()
        }
        if (animations.size > 1) document.warn("only the first of ${animations.size} animations is applied")
        val animation = document.element(animations, 0, "animations", "animations[0]")
        val poses = HashMap<Int, NodePose>()
        for (i in animation.channels.indices) {
            val where = "animations[0].channels[$i]"
            val channel = document.element(animation.channels, i, "animations[0].channels", where)
            apply(channel, animation, where, time, poses)
        }
        return poses
    }

    private fun apply(
        channel: ChannelJson,
        animation: AnimationJson,
        where: String,
        time: Double,
        poses: MutableMap<Int, NodePose>,
    ) {
        val target = channel.target ?: document.fail("$where.target", "it is missing")
        val index = target.node ?: return document.count("channels of an animation that move no node are passed over")
        val node = document.element(document.json.nodes, index, "nodes", "$where.target.node")
        val name = "animations[0].samplers"
        val sampler = document.element(animation.samplers, channel.sampler, name, "$where.sampler")
        val here = "$name[${channel.sampler}]"
        val pose = poses.getOrPut(index) { NodePose() }
        when (target.path) {
            "translation" -> pose.translation = keyframes(sampler, here, ElementType.VEC3, 3).at(time)
            "scale" -> pose.scale = keyframes(sampler, here, ElementType.VEC3, 3).at(time)
            "rotation" -> pose.rotation = keyframes(sampler, here, ElementType.VEC4, 4).rotationAt(time)
            "weights" -> {
                val mesh = document.element(document.json.meshes, node.mesh, "meshes", "nodes[$index].mesh")
                val width = mesh.primitives.firstOrNull()?.targets.orEmpty().size
                pose.weights = keyframes(sampler, here, ElementType.SCALAR, width).at(time)
            }
            else -> document.count("channels of an animation that move no node are passed over")
        }
    }

    private fun keyframes(sampler: KeyframesJson, where: String, type: ElementType, width: Int): Keyframes {
        val times = accessors.floats(sampler.input, "$where.input", ElementType.SCALAR)
        val values = accessors.floats(sampler.output, "$where.output", type)
        val interpolation = sampler.interpolation?.let(Interpolation::valueOf) ?: Interpolation.LINEAR
        val expected = times.size.toLong() * width * interpolation.valuesPerKey
        if (times.isEmpty() || expected != values.size.toLong()) {
            document.fail(where, "there are ${values.size} numbers for ${times.size} moments, not $expected")
        }
        return Keyframes(times, values, width, interpolation)
    }

    private companion object {
        const val HINT = "the model is shown at rest, or at a moment with --animation-time (LoadOptions.animationTime)"
    }
}

/** The values that an animation gives to a node at one moment. Null means that the value from the file is unchanged. */
internal class NodePose {
    var translation: DoubleArray? = null
    var rotation: DoubleArray? = null
    var scale: DoubleArray? = null
    var weights: DoubleArray? = null

    /** Whether the animation changes the transform of the node. */
    val isMoved: Boolean get() = translation != null || rotation != null || scale != null
}
