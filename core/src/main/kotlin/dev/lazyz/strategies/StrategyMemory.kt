package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer

/**
 * What strategies need of memory, in bytes for each sample, primitive and row: the one table that plans are made of.
 *
 * [expected] is the mean, from coefficients that are fitted to measurements (`docs/growth.md`); a plan reserves
 * [MARGIN] times as much. The constants are what comes in addition; what `tiled` keeps at most is in [HeapLayout].
 * Thread safe.
 */
internal object StrategyMemory {
    /** A plan reserves so many times the [expected] need. */
    const val MARGIN: Double = 2.0

    /** A sample of an image, which a budget does not count: colour, depth and primitive; or key and colour. */
    const val SAMPLE: Long = 12

    /** The object of a triangle, see [Primitive.heldBytes], and a primitive in strategies that were never measured. */
    const val PRIMITIVE: Long = 256
    const val UNKNOWN_PRIMITIVE: Long = 512

    /** A vertex of such objects: clip space, place in the world, and attributes. */
    const val VERTEX: Long = 144

    /**
     * Three groups of triangles of a streamed model, with bins, or with an object for each, see docs/large-models.md.
     */
    const val STREAM: Long = 48L shl 20
    const val STREAM_OF_OBJECTS: Long = 160L shl 20

    /** Strategies that do not create an object for each triangle of a mesh. */
    private val fromArrays = setOf("tiled", "raycast")

    /** The names of the [terms]. */
    @JvmStatic
    val termNames: List<String> =
        listOf("frame", "columns", "samples", "primitives", "primitives a row", "fragments a row")

    /** Returns the terms of the memory: what the coefficients of [StrategyCosts.bytes] are multiplied by. */
    @JvmStatic
    fun terms(numbers: FrameNumbers): DoubleArray = doubleArrayOf(
        1.0,
        numbers.columns.toDouble(),
        numbers.samples,
        numbers.primitives.toDouble(),
        numbers.primitiveRows / numbers.rows,
        numbers.fragments / numbers.rows,
    )

    /**
     * Returns the peak number of bytes that the strategy [id] holds while it renders a frame with these [numbers], or
     * NaN if it was never measured. This is the working memory and, unless the strategy draws meshes directly from
     * their arrays, the primitives created for their triangles. It does not include the scene or the picture.
     *
     * @param budget a [RenderOptions.memoryBudget] that the strategy observes, or null
     */
    fun expected(id: String, numbers: FrameNumbers, budget: Long? = null): Double {
        val coefficients = StrategyCosts.bytes[id] ?: return Double.NaN
        val primitives = if (id in fromArrays) 0.0 else PRIMITIVE.toDouble() * numbers.primitives
        val working = StrategyModel.sum(coefficients, terms(numbers))
        val most = if (budget == null) working else minOf(working, budget + SAMPLE * numbers.samples)
        return most + primitives
    }

    /** Returns what a plan reserves for [renderer]. If it was never measured, it is tried with empty pictures. */
    fun reserved(renderer: Renderer, numbers: FrameNumbers, budget: Long?): Long {
        val model = expected(renderer.id, numbers, budget)
        if (!model.isNaN()) return (MARGIN * model).toLong()
        return bytesPerSample(renderer) * numbers.columns * numbers.rows + UNKNOWN_PRIMITIVE * numbers.primitives
    }

    /** See `RenderPlanner.bytesPerSample`. */
    fun bytesPerSample(renderer: Renderer): Long {
        if (Capability.CONSTANT_MEMORY in renderer.capabilities) return 0
        return try {
            (peakBytes(renderer, 2) - peakBytes(renderer, 1)) / (PROBE_SIDE * PROBE_SIDE)
        } catch (_: RuntimeException) {
            0
        }
    }

    private fun peakBytes(renderer: Renderer, heights: Int): Long {
        val empty = Frame(Raster(PROBE_SIDE, heights * PROBE_SIDE), emptyList())
        return renderer.render(empty) { _, _, _, _ -> }.peakBytes
    }

    /** Side of the empty pictures with which a renderer is measured. It is the width of the largest tile. */
    private const val PROBE_SIDE = 512
}
