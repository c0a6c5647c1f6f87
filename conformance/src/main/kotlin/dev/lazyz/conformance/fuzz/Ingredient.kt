package dev.lazyz.conformance.fuzz

import dev.lazyz.Coherence
import dev.lazyz.conformance.frames.FrameKind

/** The parameters of a [Recipe] and their possible values. The names of both are stored in the corpus on disk. */
internal enum class Ingredient(val choices: List<String>) {
    /** The kind of at least half of the primitives. */
    KIND(FrameKind.entries.map { it.name }),

    /** The kind of the other primitives. */
    SECOND_KIND(FrameKind.entries.map { it.name }),

    /** Most columns: below and above the usual sizes of blocks and tiles. */
    WIDTH(listOf("1", "7", "20", "31", "65", "130", "257")),

    /** Most rows. */
    HEIGHT(listOf("1", "7", "20", "31", "65", "130", "257")),

    /** Most primitives in screen space, or surfaces in world space. */
    PRIMITIVES(listOf("3", "8", "30", "100", "400")),

    /** Number of polygons that cover the whole raster. */
    LAYERS(listOf("0", "0", "1", "9", "40")),

    /** Number of different depths of vertices; 0 for no limit. */
    LEVELS(listOf("0", "0", "1", "2", "5")),

    /** Percentage of frames with translucent primitives. */
    TRANSLUCENT(listOf("0", "100")),

    /** The whole raster, or a region of it. */
    PART(listOf("WHOLE", "REGION")),

    COHERENCE(Coherence.entries.map { it.name }),

    THREADS(listOf("1", "2", "5")),

    TILE_SIZE(listOf("8", "16", "64", "256")),

    /** Working memory in bytes. */
    MEMORY_BUDGET(listOf("NONE", "0", "1000", "100000")),
}
