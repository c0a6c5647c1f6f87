package dev.lazyz.conformance.strangers4

/**
 * What is wrong with a renderer of the gallery: one thing each.
 *
 * @property where the mistake, and on which frames it shows
 * @property rules the rules of the contract that it breaks, or that would be a fair name for it
 */
internal enum class Mistake(val where: String, vararg val rules: String) {
    // Tiles on several threads, with transparency
    TILE_BINS_ABSOLUTE(
        "Bins count tiles from the raster's origin: regions that begin elsewhere lose primitives.",
        "7.4",
    ),
    TILE_LEAST_FOR_ALL_TESTS(
        "Sorts and stops by the least depth where the greatest wins: layers in a tile under the greater tests.",
        "5.3", "5.1",
    ),
    TILE_TIE_IS_HIDDEN(
        "Stops at what is as deep as the farthest sample, though it was submitted first: ties behind a sloped surface.",
        "5.1", "5.2", "5.3",
    ),
    TILE_STALE_FARTHEST(
        "The farthest key of the tile before is still there: near tiles followed by tiles with something farther.",
        "5.1", "7.1",
    ),
    TILE_VEIL_TIE_LOST(
        "A translucent fragment as deep as the opaque one behind it is dropped, though its key is less.", "5.5", "5.2",
    ),
    TILE_VEILS_BY_DEPTH(
        "Translucent fragments are sorted by depth and not by key: ties among them come in the order of their bounds.",
        "5.5", "5.2", "5.3",
    ),
    TILE_BACKGROUND_OPAQUE("Blends over the background as if it were opaque: backgrounds with alpha below 1.", "5.5"),
    TILE_ALPHA_NAN("Alpha is clamped so that NaN stays NaN: translucent shaders whose alpha is NaN.", "5.5"),
    TILE_SHADES_BEHIND("Shades the backdrop behind fragments that let nothing through.", "8.2", "5.5", "7.6"),
    TILE_ONE_COLOR(
        "Takes a primitive without a shading cursor for one of a single colour in a tile: colours of the sample alone.",
        "6.1", "8.2",
    ),
    TILE_SHARED_FRAGMENT(
        "All threads shade into one fragment: now and then a colour is another's.",
        "6.1", "7.1", "7.5",
    ),
    TILE_ONE_THREAD_MORE("Starts as many helpers as threads are allowed, and works besides them.", "7.6"),
    TILE_PEAK_BY_WORKER(
        "Suspensions are added up over a worker's tiles: the peak depends on the number of threads.", "7.6", "8.1",
    ),
    TILE_FAILURE_WRAPPED("What a shader throws reaches the caller as the cause of another exception.", "7.1"),
    TILE_ERROR_ESCAPES(
        "Helpers pass on exceptions but not errors: a shader's AssertionError ends a thread, not the rendering.",
        "7.1", "7.9",
    ),
    TILE_LEAVES_HELPERS(
        "When the caller's own tile fails the helpers are not waited for: they go on after the rendering has ended.",
        "7.1", "7.9",
    ),
    TILE_INTERRUPT_LOST("The wait for helpers swallows an interrupt: the status is gone afterwards.", "7.8"),
    TILE_NOTHING_TO_DO("A frame without primitives is given back without a row.", "9.6", "7.3"),
    TILE_BINS_KEPT(
        "Keeps the bins of the last frame by its primitives and number of tiles: another region of it gets them.",
        "7.1", "7.4",
    ),

    // Rows from event to event, with coherence
    SWEEP_LEAD_OF_DEPTHS(
        "Compares depths, not forms, at both ends of a run: surfaces within a unit of each other.", "5.1", "5.2",
    ),
    SWEEP_LEAD_IN_TIES(
        "A lead of less than a unit is taken for enough whoever wins ties: surfaces that nearly meet at an end.",
        "5.1", "5.2", "5.3",
    ),
    SWEEP_CROSSING_DIVIDED(
        "The column at which two surfaces cross is lead divided by slope: but depth is rounded, and ties count.",
        "5.1", "5.2",
    ),
    SWEEP_CURVED_BY_ENDS(
        "Decides curved surfaces by the ends of a run, too: spheres that cut through others.",
        "5.1", "4.5",
    ),
    SWEEP_NO_BACKGROUND_DEPTH(
        "The background's depth is not compared: frames whose background is not at the end.",
        "4.3",
    ),
    SWEEP_BACKGROUND_SOLID("Samples that nothing covers are opaque: backgrounds with alpha below 1.", "4.3"),
    SWEEP_BEGUN_ABOVE("Primitives that begin above the region never become active.", "7.4"),
    SWEEP_CURSOR_FROM_TOP(
        "Cursors begin at the primitive's first row, though the region begins below it.",
        "2.3", "7.4",
    ),
    SWEEP_CHAINS_KEPT("Chains of steps go on from the row before: colours under INCREMENTAL.", "7.5", "6.1"),
    SWEEP_CHAIN_SUMMED("The longest chain counts from the chain's start, not from the call before.", "8.1"),
    SWEEP_GAP_BELOW_COST("ADAPTIVE does not step over a gap that costs as much as a start.", "7.6"),
    SWEEP_DIRECT_IGNORED("Configured for DIRECT after INCREMENTAL it goes on stepping.", "7.6", "7.5"),
    SWEEP_ADMITS_EARLY("Makes the cursors of the next row before the row is handed out.", "7.6"),
    SWEEP_BACKGROUND_KEPT("Does not refill columns that it did not draw: what the sink writes there stays.", "7.8"),
    SWEEP_STOPS_SILENTLY("An interrupt ends the rows without an exception.", "7.1", "7.8", "7.3"),
    SWEEP_STATUS_KEPT("Throws InterruptedException and leaves the status set.", "7.8"),
    SWEEP_COUNTS_REACHING("Counts the primitives that reach the region, not those that were submitted.", "8.1", "9.4"),
    SWEEP_ROW_TABLE("Keeps a table with an entry for each row of the region, though memory is to be constant.", "7.6"),
    SWEEP_FRAME_KEPT("Remembers the last frame.", "7.1"),
    SWEEP_REFUSAL_VAGUE("Refuses translucent primitives without naming one, or the remedy.", "5.6"),

    // Lists of fragments, with selection and transparency
    LIST_TIES_AS_DRAWN(
        "Fragments of equal depth are in the order of submission under every test.",
        "5.3", "5.5", "7.6",
    ),
    LIST_WHOLE_STEPS("Depth is stepped by the integer part of the slope: all sloped surfaces.", "3.1", "4.4"),
    LIST_BACKGROUND_TIE(
        "What is as deep as the background is behind it under every test.", "4.3", "5.2", "5.3",
    ),
    LIST_BACKGROUND_LATE(
        "Only the nearest fragment is compared with the background: selectors and veils see those behind it.",
        "7.6", "4.3", "5.5",
    ),
    LIST_FIRST_SHOW("The first call of show decides, not the last.", "7.6"),
    LIST_SHOWN_KEPT("A selector that shows nothing shows what the sample before it did.", "7.6", "6.2"),
    LIST_SELECTOR_KEPT("Configured without a selector it keeps the one it had.", "7.5"),
    LIST_SHOWN_OPAQUE("A colour that a selector gives loses its alpha.", "7.6"),
    LIST_LAYERS_CAPPED("A sample has 16 fragments at most: the ones before are not looked at.", "5.1", "5.5", "7.6"),
    LIST_PREMULTIPLIED("Sums are not divided by the weights: backgrounds or backdrops with alpha below 1.", "5.5"),
    LIST_EARLY_OUT("Stops blending below a transmittance of 1/256.", "5.5", "8.2"),
    LIST_CLEAR_IS_NOTHING(
        "A fragment with alpha 0 gives depth and primitive to the one behind it.", "5.5",
    ),
    LIST_BACKDROP_OPAQUE("Takes the opaque backdrop's alpha for 1: opaque primitives whose shader says less.", "5.5"),
    LIST_SHORT_INDEX("Keeps 16 bits of the submission index: frames with more than 65,536 primitives.", "5.1", "7.1"),
    LIST_POOL_LEAKS("Fragments of earlier bands stay in the pool: memory grows with the rows.", "7.6"),
    LIST_IO_WRAPPED("A sink's IOException reaches the caller in another exception.", "7.3"),

    // A pyramid of bounds within a budget
    PYRAMID_NUMBERS_DRAWN(
        "Counts as it draws: behind a primitive outside the region, or an empty one, indices are too small.",
        "9.4", "5.1", "7.4",
    ),
    PYRAMID_ODD_EDGE("Where a level has an odd side its last nodes stand for the first child only.", "5.1"),
    PYRAMID_ONE_NODE("A primitive that reaches several nodes is compared with the first.", "5.1"),
    PYRAMID_FLOAT("Bounds are rounded to single precision, to either side.", "5.1"),
    PYRAMID_TIE_HIDDEN("What is as deep as a bound is hidden, though the last submitted wins ties.", "5.3", "5.2"),
    PYRAMID_BOUND_AT_START("The bound of a run is its first depth: surfaces that come nearer to the right.", "5.1"),
    PYRAMID_STEP_SKIPPED("Depth is not stepped over a run that is skipped.", "3.1", "4.4", "5.1"),
    PYRAMID_BUDGET_OF_BASE("Compares the lowest level alone with the budget.", "7.6"),
    PYRAMID_ROW_ARRAYS("Hands rows out in arrays on top of image and budget.", "7.6"),
    PYRAMID_SORTS_FIRST("Sorts all primitives first, hidden ones included, on top of the budget.", "7.6"),
    PYRAMID_SHARED_SPANS("Keeps one list of spans, which callers at the same time share.", "7.1"),
    PYRAMID_DIRTY_ON_FAILURE("Uses the last image again, which is clean only if the rendering did not fail.", "7.1"),
    PYRAMID_PASSES_ALL("Counts fragments that were compared as passes.", "8.1"),
    PYRAMID_REFUSES_IN_REGION("Takes translucent primitives that lie outside the region.", "5.6"),
    PYRAMID_WARNS("Says on standard error that the budget has no room for bounds.", "7.9"),
    ;

    /** Name of the renderer that makes it. */
    val id: String get() = "fourth-" + name.lowercase().replace('_', '-')
}
