package dev.lazyz

import dev.lazyz.spi.Spans

/**
 * A rectangle of samples: columns [columnStart] until [columnEnd], rows [rowStart] until [rowEnd]. Immutable.
 *
 * @throws IllegalArgumentException if it contains no sample or starts at a negative column or row
 */
public class Region(
    public val columnStart: Int,
    public val rowStart: Int,
    public val columnEnd: Int,
    public val rowEnd: Int,
) {
    init {
        require(columnStart >= 0) { "columnStart must not be negative: $columnStart" }
        require(rowStart >= 0) { "rowStart must not be negative: $rowStart" }
        require(columnEnd > columnStart) { "columnEnd must be greater than columnStart, $columnStart: $columnEnd" }
        require(rowEnd > rowStart) { "rowEnd must be greater than rowStart, $rowStart: $rowEnd" }
    }

    /** Number of columns. */
    public val width: Int get() = columnEnd - columnStart

    /** Number of rows. */
    public val height: Int get() = rowEnd - rowStart

    /** Number of samples. */
    public val size: Long get() = width.toLong() * height

    /** Whether the sample at column [x] and row [y] is in the region. */
    public fun contains(x: Int, y: Int): Boolean = x in columnStart until columnEnd && y in rowStart until rowEnd

    /** Whether all samples of [other] are in the region. */
    public fun contains(other: Region): Boolean =
        columnStart <= other.columnStart && other.columnEnd <= columnEnd && rowStart <= other.rowStart &&
            other.rowEnd <= rowEnd

    /** Returns the samples that are in both regions; null if there are none. */
    public fun intersect(other: Region): Region? = if (contains(other)) {
        other
    } else {
        intersect(other.columnStart, other.rowStart, other.columnEnd, other.rowEnd)
    }

    /**
     * Returns the samples of this region in the columns [left] until [right] and the rows [top] until [bottom], which
     * may be outside of any raster; null if there are none.
     */
    internal fun intersect(left: Int, top: Int, right: Int, bottom: Int): Region? {
        val columnStart = maxOf(left, columnStart)
        val rowStart = maxOf(top, rowStart)
        val columnEnd = minOf(right, columnEnd)
        val rowEnd = minOf(bottom, rowEnd)
        return if (columnStart < columnEnd && rowStart < rowEnd) {
            Region(columnStart, rowStart, columnEnd, rowEnd)
        } else {
            null
        }
    }

    /**
     * Returns the samples of this region in the rows [start] until [end].
     *
     * @throws IllegalArgumentException if there are none
     */
    public fun rows(start: Int, end: Int): Region =
        Region(columnStart, maxOf(start, rowStart), columnEnd, minOf(end, rowEnd))

    /** Returns the smallest region that contains both. */
    public fun union(other: Region): Region = Region(
        minOf(columnStart, other.columnStart),
        minOf(rowStart, other.rowStart),
        maxOf(columnEnd, other.columnEnd),
        maxOf(rowEnd, other.rowEnd),
    )

    /** Returns an empty list of spans that keeps only the columns of this region. */
    public fun spans(): Spans = Spans(columnStart, columnEnd)

    override fun equals(other: Any?): Boolean = other is Region && columnStart == other.columnStart &&
        rowStart == other.rowStart && columnEnd == other.columnEnd && rowEnd == other.rowEnd

    override fun hashCode(): Int = ((columnStart * 31 + rowStart) * 31 + columnEnd) * 31 + rowEnd

    override fun toString(): String = "Region(columns $columnStart..<$columnEnd, rows $rowStart..<$rowEnd)"
}
