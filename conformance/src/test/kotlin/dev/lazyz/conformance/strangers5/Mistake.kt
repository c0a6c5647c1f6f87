package dev.lazyz.conformance.strangers5

/**
 * What can be wrong with the renderers of the fifth gallery; the prefix names the architecture.
 *
 * @property id short name
 * @property where what is wrong
 * @property rules numbers of the contract's rules, any of which points to the mistake
 */
internal enum class Mistake(val id: String, val where: String, vararg val rules: String) {
    CASTER_EARLY_OUT_TIE(
        "caster-early-out-tie",
        "the walk through a node's list stops at a bound of the best depth so far, though an equal depth may " +
            "win the tie",
        "5.1", "5.2", "5.3",
    ),
    CASTER_SHORT_COLUMNS(
        "caster-short-columns",
        "both columns of a span are packed into one number, with sixteen bits each",
        "1.1", "2.1", "2.3",
    ),
    CASTER_CURSOR_BY_OBJECT(
        "caster-cursor-by-object",
        "a primitive that is in the frame twice has one cursor, which is stepped twice a row",
        "2.3", "5.1", "5.2",
    ),
    CASTER_ONE_COLUMN(
        "caster-one-column",
        "a region of a single column has a tree without a leaf, and shows the background",
        "9.6", "7.4",
    ),
    CASTER_FOUR_SPANS(
        "caster-four-spans",
        "there is room for four spans a row; the fourth of more reaches to the end of the last",
        "2.3", "2.4", "2.7", "2.8",
    ),
    CASTER_LEVEL_CACHE(
        "caster-level-cache",
        "depth that does not change along a row is taken for constant, and kept from the first row",
        "3.1", "4.4", "5.1",
    ),
    CASTER_CHAIN_OVER_ROWS(
        "caster-chain-over-rows",
        "stepping shading goes on with the cursor of the row above where that is not yet past the column",
        "6.1", "7.5", "7.6",
    ),
    CASTER_CELL_BEHIND(
        "caster-cell-behind-background",
        "the cell given to a selector holds fragments that fail against the background's depth",
        "7.6", "4.3",
    ),
    CASTER_CELL_TIES(
        "caster-cell-ties",
        "fragments of equal depth are in order of submission in the cell, also where the last one wins",
        "7.6", "5.3", "5.5",
    ),
    CASTER_SOLID_BACKDROP(
        "caster-solid-backdrop",
        "the backdrop is blended as if its alpha were 1, the background's included",
        "5.5",
    ),
    CASTER_STALE_SHOW(
        "caster-stale-show",
        "where a selector calls no show, what it showed at the last sample is shown",
        "7.6",
    ),
    CASTER_BRIGHT_ALPHA(
        "caster-bright-alpha",
        "an alpha above 1 is not clamped before blending",
        "5.5",
    ),
    CASTER_ADAPTIVE_STEPS(
        "caster-adaptive-steps",
        "adaptive shading steps over gaps of any width where a start costs anything at all",
        "7.6", "7.5", "8.1",
    ),
    CASTER_CHAIN_SUM(
        "caster-chain-sum",
        "the longest chain is counted from the chain's start, not from the call before",
        "8.1", "7.6",
    ),
    DEFERRED_BANDS_OF_RASTER(
        "deferred-bands-of-raster",
        "primitives are put into bands that are aligned to the raster, while bands begin with the region",
        "7.4",
    ),
    DEFERRED_FLOAT_ORDER(
        "deferred-float-order",
        "translucent fragments are sorted by depth in single precision, then by submission",
        "5.5", "5.1",
    ),
    DEFERRED_NO_RETEST(
        "deferred-no-retest",
        "a translucent fragment is compared with the opaque ones before it in submission order, but not with " +
            "later ones",
        "5.5", "5.4", "5.1",
    ),
    DEFERRED_CLEAR_GLASS(
        "deferred-clear-glass",
        "fragments of alpha 0 are passed over for the sample's depth and primitive, too",
        "5.5",
    ),
    DEFERRED_SIXTEEN(
        "deferred-sixteen",
        "a sample keeps sixteen translucent fragments, those that come later are lost",
        "5.5",
    ),
    DEFERRED_EQUAL_ENDS(
        "deferred-equal-ends",
        "a run of one primitive in a column whose ends have one colour is filled with it",
        "6.1", "8.2",
    ),
    DEFERRED_CACHED_BANDS(
        "deferred-cached-bands",
        "the assignment of primitives to bands is kept for the same primitives, whatever the region",
        "7.1", "7.4",
    ),
    DEFERRED_COARSE_STEP(
        "deferred-coarse-step",
        "depth is stepped along a span with sixteen bits of fraction",
        "3.1", "3.2", "3.3", "4.4",
    ),
    DEFERRED_OCCLUDER(
        "deferred-occluder",
        "a primitive counts as hiding a band if it fills the band's first and last row",
        "5.1", "5.4", "2.4",
    ),
    DEFERRED_SHORT_INDEX(
        "deferred-short-index",
        "ties of translucent fragments are decided by the lower sixteen bits of the submission index",
        "5.5", "5.1", "5.2",
    ),
    DEFERRED_OCCLUDER_GREATEST(
        "deferred-occluder-greatest",
        "the farthest of a primitive that hides a band is its greatest depth, also where the greatest wins",
        "5.3", "5.1", "4.1",
    ),
    DEFERRED_OCCLUDER_TIE(
        "deferred-occluder-tie",
        "a primitive as deep as one that hides the band is rejected, though it may win the tie",
        "5.3", "5.1", "5.2",
    ),
    DEFERRED_SUSPENSIONS(
        "deferred-suspensions",
        "peak suspensions are those of a band times the number of threads",
        "7.6", "8.1",
    ),
    DEFERRED_LOST_COUNTS(
        "deferred-lost-counts",
        "all threads add to the same counters without a lock",
        "7.6", "8.1", "8.2",
    ),
    DEFERRED_WRAPPED(
        "deferred-wrapped",
        "what is thrown on another thread reaches the caller as the cause of an IllegalStateException",
        "7.1",
    ),
    DEFERRED_LEAVES_EARLY(
        "deferred-leaves-early",
        "after a failure the caller is answered while other threads are still at work",
        "7.1", "7.9",
    ),
    DEFERRED_DEAF(
        "deferred-deaf",
        "an interrupt while waiting for other threads is caught and forgotten",
        "7.8", "7.1",
    ),
    DEFERRED_EMPTY_ROW(
        "deferred-empty-row",
        "the arrays of an empty row are handed out again for the next empty row, with what the sink wrote",
        "7.8",
    ),
    PEELER_STRICT_DEPTH(
        "peeler-strict-depth",
        "a layer begins strictly behind the depth of the last one, so that of equal depths one is lost",
        "5.5", "5.1", "5.2", "5.3",
    ),
    PEELER_PIECE_END(
        "peeler-piece-end",
        "in a piece of several rows, all rows end at the column at which the last one ends",
        "7.5", "5.5", "7.6",
    ),
    PEELER_DIM(
        "peeler-dim",
        "peeling ends where less than 1/256 of the light gets through",
        "5.5", "8.2",
    ),
    PEELER_SINGLE_SAMPLE(
        "peeler-single-sample",
        "a primitive whose bounds hold a single sample has its least depth there",
        "4.4", "3.1", "3.2", "5.1",
    ),
    PEELER_BOX(
        "peeler-box",
        "a primitive that fills its bounds on its first and last row is drawn as a box",
        "2.3", "2.4", "2.7", "2.8",
    ),
    PEELER_MIXED_BACKDROP(
        "peeler-mixed-backdrop",
        "a backdrop with nothing but clear glass before it is weighted and divided, and lost if its alpha is 0",
        "5.5",
    ),
    PEELER_NAN_ALPHA(
        "peeler-nan-alpha",
        "an alpha that is not a number is taken for 1",
        "5.5",
    ),
    PEELER_DIRTY_POOL(
        "peeler-dirty-pool",
        "arrays are cleared at the end of a rendering for the next one; if it fails they stay as they are",
        "7.1",
    ),
    PEELER_FRAGMENTS(
        "peeler-fragments",
        "the fragments of translucent primitives are counted again with each layer",
        "8.1",
    ),
    PEELER_LEAST_PIECE(
        "peeler-least-piece",
        "a piece has 4096 samples at least, whatever the budget",
        "7.6", "7.5",
    ),
    PEELER_HIDDEN_BACKDROP(
        "peeler-hidden-backdrop",
        "the backdrop is shaded also where no light reaches it",
        "8.2", "5.5",
    ),
    SPANS_CROSSING(
        "spans-crossing",
        "where two segments cross, the column is computed in floating point and not looked at again",
        "5.1", "5.2", "3.2", "4.4",
    ),
    SPANS_STALE_POOL(
        "spans-stale-pool",
        "the link to a segment is written into the old array if the pool grows for that segment",
        "5.1", "2.3", "2.4",
    ),
    SPANS_CURVED_ENDS(
        "spans-curved-ends",
        "primitives without a depth form are compared at the ends of a segment and in its middle only",
        "5.1", "4.5", "4.6",
    ),
    SPANS_SAME_SPANS(
        "spans-same-spans",
        "visibility is taken over from the row above where all spans are the same",
        "5.1", "3.1",
    ),
    SPANS_SHARED_ROWS(
        "spans-shared-rows",
        "all renderings by one renderer share the arrays of its rows, also at the same time",
        "7.1",
    ),
    SPANS_NO_CURSOR(
        "spans-no-cursor",
        "a primitive without a shading cursor gets one colour for a whole segment",
        "6.1", "8.2",
    ),
    SPANS_BACKGROUND_TIE(
        "spans-background-tie",
        "what is exactly as deep as the background is visible",
        "4.3", "5.2",
    ),
    SPANS_UNCHECKED(
        "spans-unchecked",
        "an IOException of the sink reaches the caller in an UncheckedIOException",
        "7.3",
    ),
    SPANS_THREAD_LOCAL(
        "spans-thread-local",
        "the state of the last rendering, its frame included, stays in a thread-local variable",
        "7.1",
    ),
    SPANS_REFUSES_SEEN(
        "spans-refuses-seen",
        "a translucent primitive is refused only if it reaches the region",
        "5.6",
    ),
    SPANS_LOOKS_AHEAD(
        "spans-looks-ahead",
        "the spans of the next row are asked for before a row is handed out",
        "7.6",
    ),
    SPANS_POOL_GROWS(
        "spans-pool-grows",
        "segments are not given back to the pool at the end of a row",
        "7.6",
    ),
}
