package dev.lazyz.scenes.gltf.document

import java.nio.ByteBuffer

/** How many numbers an element of an accessor has (section 3.6.2.1). */
internal enum class ElementType(val numComponents: Int) {
    SCALAR(1),
    VEC2(2),
    VEC3(3),
    VEC4(4),
    MAT2(4),
    MAT3(9),
    MAT4(16),
    ;

    companion object {
        val names: Array<String> = Array(entries.size) { entries[it].name }
    }
}

/** The codes for types of numbers (section 3.6.2.2). */
internal object ComponentType {
    const val BYTE = 5120
    const val UNSIGNED_BYTE = 5121
    const val SHORT = 5122
    const val UNSIGNED_SHORT = 5123
    const val UNSIGNED_INT = 5125
    const val FLOAT = 5126
    val all: IntArray = intArrayOf(BYTE, UNSIGNED_BYTE, SHORT, UNSIGNED_SHORT, UNSIGNED_INT, FLOAT)

    /** Returns the size of a number of this type in bytes, or null if there is no such type. */
    fun sizeOf(code: Int): Int? = when (code) {
        BYTE, UNSIGNED_BYTE -> 1
        SHORT, UNSIGNED_SHORT -> 2
        UNSIGNED_INT, FLOAT -> 4
        else -> null
    }
}

/**
 * The numbers of an accessor (section 3.6.2), whose elements have one or more components. The caller must check that
 * all of them lie within [bytes].
 *
 * @param bytes little endian
 * @param componentType see [ComponentType]
 * @param componentSize see [ComponentType.sizeOf]
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
            ComponentType.UNSIGNED_INT -> bytes.getInt(at).let { if (it < 0) -1 else it }
            ComponentType.FLOAT -> -1
            else -> small(at)
        }
    }

    /** Returns a number. If [isNormalized], returns the fraction that an 8-bit or 16-bit integer stands for (3.11). */
    fun number(element: Int, component: Int, isNormalized: Boolean): Float {
        val at = offset + element * stride + component * componentSize
        return when (componentType) {
            ComponentType.FLOAT -> bytes.getFloat(at)
            ComponentType.UNSIGNED_INT -> (bytes.getInt(at).toLong() and 0xFFFFFFFFL).toFloat()
            else -> if (isNormalized) maxOf(small(at) / largest(), -1f) else small(at).toFloat()
        }
    }

    /** Returns the integers of [count] scalar elements. Those that need more than 31 bits are negative. */
    fun wholes(count: Int): IntArray {
        val result = IntArray(count)
        when {
            count == 0 -> return result
            componentType == ComponentType.UNSIGNED_INT && stride == Int.SIZE_BYTES ->
                bytes.duplicate().order(bytes.order()).position(offset).asIntBuffer().get(result)
            componentType == ComponentType.UNSIGNED_SHORT ->
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
        if (componentType == ComponentType.FLOAT && stride == width * Float.SIZE_BYTES) {
            val from = bytes.duplicate().order(bytes.order()).position(offset + first * stride)
            from.asFloatBuffer().get(to, first * width, count * width)
        } else if (componentType == ComponentType.FLOAT) {
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
        ComponentType.BYTE -> bytes.get(at).toInt()
        ComponentType.UNSIGNED_BYTE -> bytes.get(at).toInt() and 0xFF
        ComponentType.SHORT -> bytes.getShort(at).toInt()
        else -> bytes.getShort(at).toInt() and 0xFFFF
    }

    /** The integer that stands for 1 when numbers are normalized. */
    private fun largest(): Float = when (componentType) {
        ComponentType.BYTE -> 127f
        ComponentType.UNSIGNED_BYTE -> 255f
        ComponentType.SHORT -> 32767f
        else -> 65535f
    }
}
