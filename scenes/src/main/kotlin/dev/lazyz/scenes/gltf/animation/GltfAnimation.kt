package dev.lazyz.scenes.gltf.animation

import dev.lazyz.scenes.gltf.document.AnimationJson
import dev.lazyz.scenes.gltf.document.ChannelJson
import dev.lazyz.scenes.gltf.document.ElementType
import dev.lazyz.scenes.gltf.document.GltfAccessors
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.KeyframesJson
import kotlin.math.abs
import kotlin.math.sqrt

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

/**
 * How values between two keyframes are interpolated (glTF 2.0, appendix C).
 *
 * @property valuesPerKey number of stored values for each key
 */
internal enum class Interpolation(val valuesPerKey: Int) {
    STEP(1),
    LINEAR(1),
    CUBICSPLINE(3),
}

/**
 * Values at given times, and the interpolation between them (glTF 2.0, section 3.11 and appendix C).
 *
 * All arithmetic uses doubles and [StrictMath], so results are bit for bit the same on every machine.
 *
 * @param times in seconds, ascending, at least one
 * @param values for each key, [width] times [Interpolation.valuesPerKey] numbers; for a spline: the tangent before the
 *   key, the value, and the tangent after it
 * @param width number of components of a value
 */
internal class Keyframes(
    private val times: FloatArray,
    private val values: FloatArray,
    private val width: Int,
    private val interpolation: Interpolation,
) {
    /**
     * Returns the value at [time], in seconds. Before the first key it is the first value, and after the last key the
     * last value.
     */
    fun at(time: Double): DoubleArray = between(time) { from, to, fraction ->
        when (interpolation) {
            Interpolation.STEP -> value(from)
            Interpolation.LINEAR -> mix(value(from), value(to), 1.0 - fraction, fraction)
            Interpolation.CUBICSPLINE -> spline(from, to, fraction)
        }
    }

    /** Returns the unit quaternion at [time], in seconds. Linear interpolation follows the shorter arc. */
    fun rotationAt(time: Double): DoubleArray = normalized(
        if (interpolation == Interpolation.LINEAR) {
            between(time) { from, to, fraction -> arc(value(from), value(to), fraction) }
        } else {
            at(time)
        },
    )

    private inline fun between(time: Double, mixed: (Int, Int, Double) -> DoubleArray): DoubleArray {
        // Find the last key that is not after the time
        var low = 0
        var high = times.size - 1
        while (low < high) {
            val middle = (low + high + 1) / 2
            if (times[middle] <= time) low = middle else high = middle - 1
        }
        if (low == times.size - 1 || !(time > times[low])) return value(low)
        val length = times[low + 1].toDouble() - times[low]
        val fraction = if (length > 0.0) (time - times[low]) / length else 0.0
        return mixed(low, low + 1, fraction)
    }

    private fun value(key: Int): DoubleArray = part(key, interpolation.valuesPerKey / 2)

    private fun part(key: Int, part: Int): DoubleArray {
        val start = (key * interpolation.valuesPerKey + part) * width
        return DoubleArray(width) { values[start + it].toDouble() }
    }

    private fun mix(a: DoubleArray, b: DoubleArray, ofA: Double, ofB: Double) =
        DoubleArray(width) { a[it] * ofA + b[it] * ofB }

    /** Interpolates with a cubic Hermite spline. Tangents are per second. */
    private fun spline(from: Int, to: Int, t: Double): DoubleArray {
        val length = times[to].toDouble() - times[from]
        val square = t * t
        val cube = square * t
        val a = mix(part(from, 1), part(to, 1), 2.0 * cube - 3.0 * square + 1.0, 3.0 * square - 2.0 * cube)
        val b = mix(part(from, 2), part(to, 0), length * (cube - 2.0 * square + t), length * (cube - square))
        return mix(a, b, 1.0, 1.0)
    }

    private fun arc(a: DoubleArray, b: DoubleArray, t: Double): DoubleArray {
        val dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
        val sign = if (dot < 0.0) -1.0 else 1.0
        if (!(abs(dot) < NEARLY_EQUAL)) return mix(a, b, 1.0 - t, sign * t)
        val angle = StrictMath.acos(abs(dot))
        val sine = StrictMath.sin(angle)
        return mix(a, b, StrictMath.sin((1.0 - t) * angle) / sine, sign * StrictMath.sin(t * angle) / sine)
    }

    private fun normalized(q: DoubleArray): DoubleArray {
        val length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
        return if (length > 0.0) DoubleArray(4) { q[it] / length } else doubleArrayOf(0.0, 0.0, 0.0, 1.0)
    }

    private companion object {
        /**
         * If the dot product of two quaternions is at least this large, they are interpolated linearly: the difference
         * is negligible, and the sine of the angle is too small to divide by.
         */
        const val NEARLY_EQUAL = 0.9999
    }
}
