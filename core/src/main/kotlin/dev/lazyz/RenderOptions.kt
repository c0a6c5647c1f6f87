package dev.lazyz

/**
 * Choices that change what a rendering costs and, but for [selector], never its picture. Immutable.
 *
 * A renderer heeds those that go with its [Capability]s, see [Renderer.configured].
 *
 * @property coherence how late shading moves from sample to sample
 * @property memoryBudget most bytes of working memory besides the image, or null for no limit
 * @property threads number of threads, at least 1
 * @property tileSize width and height of tiles, for renderers that have tiles; samples, a power of two in 8..512
 * @property selector what a sample shows of its fragments, for renderers with [Capability.SELECTION]; null for the usual:
 *   the visible one, or all blended where the frame has translucent primitives
 * @throws IllegalArgumentException if a number is out of range
 */
public class RenderOptions @JvmOverloads constructor(
    public val coherence: Coherence = Coherence.DIRECT,
    public val memoryBudget: Long? = null,
    public val threads: Int = Runtime.getRuntime().availableProcessors(),
    public val tileSize: Int = 64,
    public val selector: Selector? = null,
) {
    init {
        require(memoryBudget == null || memoryBudget >= 0) { "memoryBudget must not be negative: $memoryBudget" }
        require(threads >= 1) { "threads must be at least 1: $threads" }
        require(tileSize in 8..512 && tileSize.countOneBits() == 1) {
            "tileSize must be a power of two in 8..512: $tileSize"
        }
    }

    override fun toString(): String =
        "RenderOptions($coherence, memoryBudget=$memoryBudget, threads=$threads, tileSize=$tileSize, " +
            "selector=$selector)"
}
