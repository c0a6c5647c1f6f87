package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.strategies.PictureMemory

/** Checks before the rendering whether a picture fits into memory. */
internal object MemoryNeed {
    private const val MAX_ARRAY = Int.MAX_VALUE - 8L

    /** More bytes than any strategy is expected to keep for a pixel. */
    private const val PLENTY = 64L

    /**
     * Throws [Mistake] if [strategy] needs more than the [available] bytes for [picture], including the [kept] bytes
     * per pixel that the caller keeps. [picture] has [aa] x [aa] samples a pixel.
     */
    fun check(
        strategy: Renderer,
        picture: Region,
        kept: Long = 0,
        available: Long = Runtime.getRuntime().maxMemory(),
        aa: Int = 1,
    ) {
        // Small pictures fit with any strategy
        if (picture.size * (PLENTY + kept) <= available && picture.size <= MAX_ARRAY) return
        val bytes = PictureMemory.bytesPerSample(strategy) + kept
        val need = bytes * picture.size
        val what = "a picture of ${picture.width}x${picture.height} with strategy '${strategy.id}'"
        if (bytes >= Int.SIZE_BYTES && picture.size > MAX_ARRAY) {
            throw Mistake("$what would have ${picture.size} pixels, and the maximum is $MAX_ARRAY; ${remedy(kept, aa)}")
        }
        if (need > available) {
            val gigabytes = need / (1L shl 30) + 2
            throw Mistake(
                "$what needs ${Bytes.readable(need)} of memory, and Java may use ${Bytes.readable(available)}; " +
                    "${remedy(kept, aa)}, or run it with 'java -Xmx${gigabytes}g -jar zcli.jar ...'",
            )
        }
    }

    private fun remedy(kept: Long, aa: Int): String {
        val fewer = if (aa > 1) "--aa 1 in place of --aa $aa, " else ""
        val smaller = "choose ${fewer}a smaller --size or a --region"
        if (kept > 0) return smaller
        val streaming = Strategies.all().filter { Capability.CONSTANT_MEMORY in it.capabilities }.map { it.id }
        return "$smaller, or a --strategy that does not keep the picture (${streaming.joinToString()})"
    }
}
