package dev.lazyz.scenes.gltf.meshopt

import dev.lazyz.scenes.loading.Source
import java.nio.ByteBuffer
import java.nio.ByteOrder

/**
 * The parameters that `EXT_meshopt_compression` or `KHR_meshopt_compression` gives for a buffer view (Khronos Group,
 * "KHR_meshopt_compression", release candidate; this package refers to the appendices of that document). The two
 * extensions differ in the features that an encoder may use. All features are decoded under either name.
 *
 * @property count number of elements
 * @property stride size of an element in bytes
 * @throws MeshoptException if the extension does not allow this combination of parameters
 */
internal class MeshoptData(private val mode: String, private val filter: String, val count: Int, val stride: Int) {
    init {
        val isAttributes = mode == "ATTRIBUTES"
        check(count >= 0, "count", "$count")
        check(isAttributes || mode == "TRIANGLES" || mode == "INDICES", "mode", mode)
        val strides = if (isAttributes) 4..256 step 4 else 2..4 step 2
        check(stride in strides, "byteStride", "$stride")
        check(mode != "TRIANGLES" || count % 3 == 0, "count", "$count")
        val isFilterAllowed = when (filter) {
            "NONE" -> true
            "OCTAHEDRAL", "COLOR" -> isAttributes && (stride == 4 || stride == 8)
            "QUATERNION" -> isAttributes && stride == 8
            "EXPONENTIAL" -> isAttributes
            else -> false
        }
        check(isFilterAllowed, "filter", filter)
    }

    private fun check(isGood: Boolean, name: String, value: String) {
        if (!isGood) throw MeshoptException("$name is $value, which mode $mode does not allow")
    }

    /**
     * Returns the elements decoded from [bytes].
     *
     * @param work counts steps of work, see [Source.step]
     * @throws MeshoptException if the bytes are damaged
     */
    fun decode(bytes: ByteArray, work: (Int) -> Unit = {}): ByteBuffer {
        val elements = when (mode) {
            "ATTRIBUTES" -> AttributeStream.decode(bytes, count, stride, work)
            "TRIANGLES" -> TriangleStream.decode(bytes, count, stride, work)
            else -> IndexStream.decode(bytes, count, stride, work)
        }
        val buffer = ByteBuffer.wrap(elements).order(ByteOrder.LITTLE_ENDIAN)
        when (filter) {
            "OCTAHEDRAL" -> MeshoptFilter.octahedral(SmallNumbers(buffer, stride / 4), work)
            "QUATERNION" -> MeshoptFilter.quaternion(SmallNumbers(buffer, 2), work)
            "EXPONENTIAL" -> MeshoptFilter.exponential(buffer, work)
            "COLOR" -> MeshoptFilter.color(SmallNumbers(buffer, stride / 4), work)
        }
        return buffer
    }
}
