package dev.lazyz.cli

import dev.lazyz.Raster
import dev.lazyz.Renderer

/** Finds out before the work begins that a picture cannot fit. */
internal object MemoryNeed {
    private const val MAX_ARRAY = Int.MAX_VALUE - 8L

    /**
     * Bytes that a strategy keeps for every sample of the raster; 0 if its memory does not grow with the raster, or is
     * not known, as for a third party's.
     */
    private fun bytesPerSample(id: String): Long = when (id) {
        "zbuffer" -> 12
        else -> 0
    }

    /** Throws [Mistake] if [renderer] needs more for [raster] than the [available] bytes. */
    fun check(renderer: Renderer, raster: Raster, available: Long = Runtime.getRuntime().maxMemory()) {
        val need = bytesPerSample(renderer.id) * raster.size
        if (need == 0L) return
        val what = "a picture of ${raster.width}x${raster.height} with strategy '${renderer.id}'"
        if (raster.size > MAX_ARRAY) {
            throw Mistake("$what would have ${raster.size} pixels, and it can hold $MAX_ARRAY; choose a smaller --size")
        }
        if (need > available) {
            val gigabytes = need / (1L shl 30) + 2
            throw Mistake(
                "$what needs ${Bytes.readable(need)} of memory, and Java may use ${Bytes.readable(available)}; " +
                    "choose a smaller --size, or run it with 'java -Xmx${gigabytes}g -jar zcli.jar ...'",
            )
        }
    }
}
