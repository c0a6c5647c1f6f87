package dev.lazyz.cli.report

import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.Viridis
import dev.lazyz.cli.trace.ShadingOrder
import dev.lazyz.scenes.aov.AovPicture
import dev.lazyz.scenes.pictures.Canvas

/** When each of [pixels] got its colour, from the first call of [order] to the last. Memory: 4 bytes a pixel. */
internal class OrderMap(order: ShadingOrder, pixels: Region) {
    private val canvas = Canvas(pixels.width, pixels.height, AovPicture.NOTHING)

    /** See [ShadingOrder.discarded]. */
    val discarded: Int = order.discarded

    init {
        // With several layers, the first counts
        val last = maxOf(order.size - 1, 1).toDouble()
        for (call in order.size - 1 downTo 0) {
            if (order.isDiscarded(call)) continue
            val place = order.place(call)
            canvas.set(place % pixels.width, place / pixels.width, Viridis.argb(call / last))
        }
    }

    fun toImage(): Image = canvas.toImage()
}
