package dev.lazyz.conformance.fuzz

import dev.lazyz.Coherence
import dev.lazyz.conformance.frames.FrameKind

/** What a [Recipe] chooses, and what it may choose. The names of both are the words of the corpus on disk. */
internal enum class Ingredient(val choices: List<String>) {
    /** The kind of half of the primitives, or more. */
    KIND(FrameKind.entries.map { it.name }),

    /** The kind of the others. */
    SECOND_KIND(FrameKind.entries.map { it.name }),

    /** Most columns: on both sides of the usual sizes of blocks and tiles. */
    WIDTH(listOf("1", "7", "20", "31", "65", "130", "257")),

    /** Most rows. */
    HEIGHT(listOf("1", "7", "20", "31", "65", "130", "257")),

    /** Most primitives on the screen, or surfaces in space. */
    PRIMITIVES(listOf("3", "8", "30", "100", "400")),

    /** Polygons that cover the whole raster. */
    LAYERS(listOf("0", "0", "1", "9", "40")),

    /** Different depths of vertices; 0 is any number of them. */
    LEVELS(listOf("0", "0", "1", "2", "5")),

    /** How many frames of a hundred have translucent primitives. */
    TRANSLUCENT(listOf("0", "100")),

    /** The whole raster, or a region of it. */
    PART(listOf("WHOLE", "REGION")),

    COHERENCE(Coherence.entries.map { it.name }),

    THREADS(listOf("1", "2", "5")),

    TILE_SIZE(listOf("8", "16", "64", "256")),

    /** Bytes of working memory. */
    MEMORY_BUDGET(listOf("NONE", "0", "1000", "100000")),
}
