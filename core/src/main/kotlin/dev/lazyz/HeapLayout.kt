package dev.lazyz

/** Bytes of the elements of an array, as [Counters.peakBytes] counts them. */
internal val IntArray.bytes: Long get() = Int.SIZE_BYTES * size.toLong()

/** See [IntArray.bytes]. */
internal val LongArray.bytes: Long get() = Long.SIZE_BYTES * size.toLong()

/** See [IntArray.bytes]. */
internal val DoubleArray.bytes: Long get() = Double.SIZE_BYTES * size.toLong()

/** See [IntArray.bytes]. */
internal val Array<*>.bytes: Long get() = HeapLayout.REFERENCE * size

/**
 * What objects take of a Java heap, in bytes, with all that only they refer to: with headers of 16 bytes and references
 * of 8 bytes, the largest sizes that a JVM uses. The one place that knows it.
 */
internal object HeapLayout {
    /** A reference in a heap beyond 32 gigabytes; half of this below. */
    const val REFERENCE: Long = 8

    /** The header of an object or of an array. */
    const val HEADER: Long = 16

    /** A vertex of a mesh that is set up: snapped, and copies for another up axis or another colour. */
    const val VERTEX: Long = 60

    /** The object of a triangle that is drawn alone. */
    const val TRIANGLE: Long = 400

    /** Any other primitive, and a corner of a polygon. */
    const val SHAPE: Long = 512
    const val CORNER: Long = 100

    /** A point or a stroke of a drawing: a reference and four numbers. */
    const val POINT: Long = 32

    /** A line: a reference, twelve numbers of 4 bytes and four of 8. */
    const val LINE: Long = 96

    /**
     * A triangle or polygon with the reference triangle, the corners, the depth form and, after shading, the edge
     * functions: nine objects with 40 fields. Its edges are counted in addition.
     */
    const val PLANAR: Long = 9 * HEADER + 40 * 8

    /** What a tile keeps of a triangle: two objects, one with 22 fields, without the numbers of its vertices. */
    const val FACE: Long = 2 * HEADER + 22 * 8 + HEADER

    /** A table of edges, without their array. */
    const val EDGE_TABLE: Long = 72

    /** A cursor that evaluates each row directly. The size of a custom cursor is not known. */
    const val CURSOR: Long = 24

    /** A cursor along edges: eleven fields, the headers of six arrays; and for each edge three ints and three longs. */
    const val EDGE_CURSOR: Long = 152
    const val CURSOR_EDGE: Long = 36

    /** A chain of incremental shading: two objects of five 8-byte fields, and a map entry. */
    const val SHADING_CHAIN: Long = 152

    /** A stage of a pipeline, with seven fields; and a coroutine in it. */
    const val STAGE: Long = 40
    const val COROUTINE: Long = 136

    /** A primitive on the current row of a sweep: its array of spans, and the cursor of a triangle. */
    const val ACTIVE_PRIMITIVE: Long = 320

    /** What a primitive covers of a band of rows: the headers of arrays, the box, and the cursor of a triangle. */
    const val BAND_COVERAGE: Long = 420

    /** The spans of a primitive in a band: two objects of four fields, and two arrays. */
    const val BAND_SPANS: Long = 96

    /** The corners of an outline, and its depth plane. */
    const val FACET: Long = 136

    /** A record of suspended colours, without its runs: three references, a long and four ints, rounded up. */
    const val RECORD: Long = 72

    /**
     * Vertices that records share, without their numbers: an entry of a map, 48, its counter, 24, and 208 for the map
     * and its first table. These exceed an entry's share of later tables, also while old and new table coexist.
     */
    const val SHARED_VERTICES: Long = 2 * HEADER + 48 + 24 + 208

    /** A sample of a tile: key, end of its layers, blocks, and a quarter of the sums of its pixel. */
    const val TILE_SAMPLE: Long = 26

    /** A triangle in a tile: 12 bytes as it is found, 8 in its bin, up to an eighth more; 16 while it is drawn. */
    const val TILE_TRIANGLE: Long = 38

    /** A fragment of a small triangle: 12 bytes as it is found, 12 in its bin, up to an eighth more. */
    const val TILE_FRAGMENT: Long = 26

    /** A translucent fragment in a tile: 12 bytes as it is found, 8 in order; half as much again. */
    const val TILE_LAYER: Long = 30

    /** A primitive that is in no batch, while primitives are sorted by their first band. */
    const val ARRIVAL: Long = 16

    /** Such a primitive in a band: its number, key, columns, spans, and up to 8 tiles; a quarter more. */
    const val MEMBER: Long = 84

    /** The spans of such a primitive in a band: their objects, and two columns of each, in arrays that double. */
    const val MEMBER_SPANS: Long = 144
    const val MEMBER_SPAN: Long = 16

    /** The part of [Primitive.heldBytes] of the two edges of a span. */
    const val SPAN_EDGES: Long = 64

    /** The buffers of a thread for colours. See docs/memory.md for the measurement of the whole. */
    const val THREAD: Long = 1L shl 20

    /** The regions that the garbage collector G1 aims at, and their sizes. */
    private const val REGIONS = 2048
    private const val LEAST_REGION = 1L shl 20
    private const val MOST_REGION = 32L shl 20

    /**
     * Returns what an array of [bytes] takes of a heap of [memory] bytes: G1 gives whole regions to an array of half a
     * region or more.
     */
    fun array(bytes: Long, memory: Long): Long {
        val region = java.lang.Long.highestOneBit((memory / REGIONS).coerceIn(LEAST_REGION, MOST_REGION))
        return if (bytes < region / 2) bytes else (bytes + HEADER - 1) / region * region + region
    }
}
