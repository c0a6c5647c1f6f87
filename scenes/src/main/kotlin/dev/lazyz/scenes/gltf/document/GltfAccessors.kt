package dev.lazyz.scenes.gltf.document

/**
 * Reads accessors (section 3.6.2) into arrays. Each accessor is read once.
 *
 * Nothing is allocated before the numbers are known to lie within their buffer view. Sparse accessors (3.6.2.3) are
 * resolved here.
 */
internal class GltfAccessors(private val document: GltfDocument) {
    private val floats = HashMap<Pair<Int, Boolean>, FloatArray>()

    /**
     * Returns the numbers of an accessor, row by row. Normalized integers are returned as fractions (3.11).
     *
     * @param where the place in the file that refers to the accessor
     * @param types the element types that are allowed
     * @param areFractions whether integers are fractions even if the accessor does not say that they are normalized
     */
    fun floats(index: Int?, where: String, vararg types: ElementType, areFractions: Boolean = false): FloatArray {
        val accessor = document.element(document.json.accessors, index, "accessors", where)
        val type = type(accessor, index)
        if (type !in types) {
            document.fail("accessors[$index].type", "$where needs ${types.joinToString(" or ")}, not $type")
        }
        val isFraction = areFractions || accessor.normalized == true
        return floats.getOrPut(checkNotNull(index) to isFraction) { read(accessor, index, type, isFraction) }
    }

    /**
     * Returns the integers of a scalar accessor. A number that needs more than 31 bits is returned as a negative one.
     */
    fun indices(index: Int, where: String): IntArray {
        val accessor = document.element(document.json.accessors, index, "accessors", where)
        val here = "accessors[$index]"
        if (type(accessor, index) != ElementType.SCALAR) document.fail("$here.type", "$where needs SCALAR")
        if (accessor.componentType == ComponentType.FLOAT) {
            document.fail("$here.componentType", "$where needs whole numbers")
        }
        if (accessor.sparse != null) document.fail("$here.sparse", "vertex numbers must not be sparse")
        val data = dense(accessor, index, ElementType.SCALAR) ?: return IntArray(count(accessor, here))
        return data.wholes(count(accessor, here))
    }

    private fun read(accessor: AccessorJson, index: Int, type: ElementType, isNormalized: Boolean): FloatArray {
        val width = type.numComponents
        val data = dense(accessor, index, type)
        val count = count(accessor, "accessors[$index]")
        document.source.loading.decode(document.source, count.toLong() * width * Float.SIZE_BYTES)
        val result = FloatArray(count * width)
        for (start in 0 until count step BLOCK) {
            document.source.step(BLOCK)
            data?.copy(start, minOf(BLOCK, count - start), width, isNormalized, result)
        }
        accessor.sparse?.let { substitute(it, accessor, index, type, isNormalized, result) }
        return result
    }

    /** Writes the sparse values into [result], at the positions that the sparse indices give. */
    private fun substitute(
        sparse: SparseJson,
        accessor: AccessorJson,
        index: Int,
        type: ElementType,
        isNormalized: Boolean,
        result: FloatArray,
    ) {
        val here = "accessors[$index].sparse"
        val width = type.numComponents
        val count = result.size / width
        val changes = sparse.count?.takeIf { it in 0..count }
            ?: document.fail("$here.count", "it is missing or above $count")
        val places = sparse.indices ?: document.fail("$here.indices", "it is missing")
        val values = sparse.values ?: document.fail("$here.values", "it is missing")
        val placeType = places.componentType ?: document.fail("$here.indices.componentType", "it is missing")
        val componentType = componentType(accessor, index)
        val from = data(places.bufferView, places.byteOffset, placeType, changes, ElementType.SCALAR, "$here.indices")
        val to = data(values.bufferView, values.byteOffset, componentType, changes, type, "$here.values")
        for (change in 0 until changes) {
            document.source.step()
            val place = from.whole(change)
            if (place !in 0 until count) {
                document.fail("$here.indices", "element $change is $place, but there are $count elements")
            }
            for (i in 0 until width) result[place * width + i] = to.number(change, i, isNormalized)
        }
    }

    /** Returns the numbers in the buffer view, or null if there is no buffer view, in which case all numbers are 0. */
    private fun dense(accessor: AccessorJson, index: Int, type: ElementType): GltfNumbers? {
        val here = "accessors[$index]"
        val count = count(accessor, here)
        if (accessor.bufferView == null) {
            if (accessor.sparse == null && count > MAX_ZEROS) {
                document.fail("$here.count", "$count elements without a buffer view are more than $MAX_ZEROS")
            }
            return null
        }
        val stride = document.element(document.json.bufferViews, accessor.bufferView, "bufferViews", here).byteStride
        return data(accessor.bufferView, accessor.byteOffset, componentType(accessor, index), count, type, here, stride)
    }

    private fun data(
        view: Int?,
        byteOffset: Int?,
        componentType: Int,
        count: Int,
        type: ElementType,
        where: String,
        byteStride: Int? = null,
    ): GltfNumbers {
        val bytes = document.view(view, "$where.bufferView")
        val componentSize = ComponentType.sizeOf(componentType)
            ?: document.fail("$where.componentType", "$componentType is not a component type")
        val offset = byteOffset ?: 0
        val size = type.numComponents * componentSize
        val stride = byteStride?.takeIf { it != 0 } ?: size
        val end = if (count == 0) 0L else offset + (count - 1L) * stride + size
        if (offset < 0 || stride < size || end > bytes.capacity()) {
            document.fail(where, "$count elements end at byte $end of a buffer view of ${bytes.capacity()} bytes")
        }
        return GltfNumbers(bytes, componentType, componentSize, offset, stride)
    }

    private fun count(accessor: AccessorJson, here: String): Int =
        accessor.count?.takeIf { it >= 0 } ?: document.fail("$here.count", "it is missing or not allowed")

    private fun componentType(accessor: AccessorJson, index: Int): Int =
        accessor.componentType ?: document.fail("accessors[$index].componentType", "it is missing")

    private fun type(accessor: AccessorJson, index: Int?): ElementType =
        accessor.type?.let(ElementType::valueOf)
            ?: document.fail("accessors[$index].type", "${accessor.type} is not an element type")

    private companion object {
        /** Elements that are read between two looks at the clock and the interrupt. */
        const val BLOCK = 1 shl 16

        /**
         * The maximum number of elements of an accessor without a buffer view and without sparse values, whose elements
         * are all 0. Nothing needs more of them, and a few bytes of a file would request a lot of memory.
         */
        const val MAX_ZEROS = 1 shl 20
    }
}
