package dev.lazyz.pipeline

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RowSink

/**
 * Primitives that arrive one by one, for a renderer that needs them all at once. Whenever there are many, they are
 * rendered without colours, and the opaque ones that are hidden are dropped: they cannot be visible later, because more
 * primitives only hide more.
 *
 * Memory: the visible opaque primitives, all translucent ones, and as many again. Used by one thread.
 *
 * @param render renders a frame
 */
internal class GroupedPrimitives(
    private val raster: Raster,
    private val region: Region,
    private val render: (frame: Frame, sink: RowSink) -> Counters,
) {
    private val counters = Counters.Builder()
    private var opaque = ArrayList<Numbered>()
    private val translucent = ArrayList<Numbered>()
    private var count = 0
    private var full = GROUP

    init {
        require(raster.region.contains(region)) { "$region must be within $raster" }
    }

    private class Numbered(val index: Int, val primitive: Primitive)

    /** Takes the next primitive. */
    fun draw(primitive: Primitive) {
        val numbered = Numbered(count++, primitive)
        if (primitive.isTranslucent) translucent += numbered else opaque += numbered
        if (opaque.size >= full) dropHidden()
    }

    private fun dropHidden() {
        val isVisible = BooleanArray(opaque.size)
        val frame = Frame(raster, opaque.map { it.primitive }, region).unshaded()
        val work = render(frame) { _, _, _, primitive ->
            for (index in primitive) if (index in isVisible.indices) isVisible[index] = true
        }.toBuilder()

        // Only the last pass draws them; a fragment counts once (contract rule 8.1)
        work.fragments = 0
        work.depthPasses = 0
        counters.add(work.build())
        opaque = opaque.filterIndexedTo(ArrayList()) { number, _ -> isVisible[number] }
        full = maxOf(GROUP, 2 * opaque.size)
    }

    /** Passes every row to [sink]. */
    fun finish(sink: RowSink): Counters {
        val all = (opaque + translucent).sortedBy { it.index }
        val indices = IntArray(region.width)
        counters.add(
            render(Frame(raster, all.map { it.primitive }, region)) { y, argb, depth, primitive ->
                for (x in indices.indices) {
                    val number = primitive[x]
                    indices[x] = if (number in all.indices) all[number].index else number
                }
                sink.row(y, argb, depth, indices)
            },
        )
        counters.primitives = count.toLong()
        return counters.build()
    }

    private companion object {
        /** Opaque primitives that are rendered at a time, or more if many are visible. */
        const val GROUP = 1 shl 14
    }
}
