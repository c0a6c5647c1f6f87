package dev.lazyz.scenes.gltf.document

import de.javagl.jgltf.model.GltfConstants
import java.nio.ByteBuffer

/**
 * The numbers of an accessor (section 3.6.2), whose elements have one or more components. The caller must check that
 * all of them lie within [bytes].
 *
 * @param bytes little endian
 * @param componentType type of the numbers, one of the `GL_` constants
 * @param componentSize see [sizeOf]
 * @param offset position of the first element, in bytes
 * @param stride distance from one element to the next, in bytes
 */
internal class GltfNumbers(
    private val bytes: ByteBuffer,
    private val componentType: Int,
    private val componentSize: Int,
    private val offset: Int,
    private val stride: Int,
) {
    /** Returns the integer of a scalar element, or -1 if it needs more than 31 bits. */
    fun whole(element: Int): Int {
        val at = offset + element * stride
        return when (componentType) {
            GltfConstants.GL_UNSIGNED_INT -> bytes.getInt(at).let { if (it < 0) -1 else it }
            GltfConstants.GL_FLOAT -> -1
            else -> small(at)
        }
    }

    /** Returns a number. If [isNormalized], returns the fraction that an 8-bit or 16-bit integer stands for (3.11). */
    fun number(element: Int, component: Int, isNormalized: Boolean): Float {
        val at = offset + element * stride + component * componentSize
        return when (componentType) {
            GltfConstants.GL_FLOAT -> bytes.getFloat(at)
            GltfConstants.GL_UNSIGNED_INT -> (bytes.getInt(at).toLong() and 0xFFFFFFFFL).toFloat()
            else -> if (isNormalized) maxOf(small(at) / largest(), -1f) else small(at).toFloat()
        }
    }

    /** Returns the integers of [count] scalar elements. Those that need more than 31 bits are negative. */
    fun wholes(count: Int): IntArray {
        val result = IntArray(count)
        when {
            count == 0 -> return result
            componentType == GltfConstants.GL_UNSIGNED_INT && stride == Int.SIZE_BYTES ->
                bytes.duplicate().order(bytes.order()).position(offset).asIntBuffer().get(result)
            componentType == GltfConstants.GL_UNSIGNED_SHORT ->
                for (i in 0 until count) result[i] = bytes.getShort(offset + i * stride).toInt() and 0xFFFF
            else -> for (i in 0 until count) result[i] = whole(i)
        }
        return result
    }

    /**
     * Writes the numbers of [count] elements from [first] on to their places in [to], [width] numbers for each element;
     * see [number].
     */
    fun copy(first: Int, count: Int, width: Int, isNormalized: Boolean, to: FloatArray) {
        val elements = first until first + count
        if (componentType == GltfConstants.GL_FLOAT && stride == width * Float.SIZE_BYTES) {
            val from = bytes.duplicate().order(bytes.order()).position(offset + first * stride)
            from.asFloatBuffer().get(to, first * width, count * width)
        } else if (componentType == GltfConstants.GL_FLOAT) {
            for (element in elements) {
                val at = offset + element * stride
                for (i in 0 until width) to[element * width + i] = bytes.getFloat(at + i * Float.SIZE_BYTES)
            }
        } else {
            for (element in elements) {
                for (i in 0 until width) to[element * width + i] = number(element, i, isNormalized)
            }
        }
    }

    private fun small(at: Int): Int = when (componentType) {
        GltfConstants.GL_BYTE -> bytes.get(at).toInt()
        GltfConstants.GL_UNSIGNED_BYTE -> bytes.get(at).toInt() and 0xFF
        GltfConstants.GL_SHORT -> bytes.getShort(at).toInt()
        else -> bytes.getShort(at).toInt() and 0xFFFF
    }

    /** The integer that stands for 1 when numbers are normalized. */
    private fun largest(): Float = when (componentType) {
        GltfConstants.GL_BYTE -> 127f
        GltfConstants.GL_UNSIGNED_BYTE -> 255f
        GltfConstants.GL_SHORT -> 32767f
        else -> 65535f
    }

    companion object {
        /** Returns the size of a number of this type in bytes, or null if there is no such type. */
        fun sizeOf(componentType: Int): Int? = when (componentType) {
            GltfConstants.GL_BYTE, GltfConstants.GL_UNSIGNED_BYTE -> 1
            GltfConstants.GL_SHORT, GltfConstants.GL_UNSIGNED_SHORT -> 2
            GltfConstants.GL_UNSIGNED_INT, GltfConstants.GL_FLOAT -> 4
            else -> null
        }
    }
}
