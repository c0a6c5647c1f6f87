package dev.lazyz.conformance.strangers

import dev.lazyz.Primitive
import dev.lazyz.RowSink

/** Regions and what is handed out. */
internal val regionMistakes: List<Stranger> = listOf(
    Stranger(
        "region-column-forgotten-in-shading",
        "colours are asked for at columns of the region",
        setOf("7.4", "6.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun color(index: Int, x: Int, y: Int): Int = super.color(index, x - region.columnStart, y)
            }
        }
    },
    Stranger(
        "region-row-forgotten-without-form",
        "depth without a form is asked for at the region's rows; shows on spheres in regions that begin further down",
        setOf("7.4", "4.5"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) =
                    super.walk(primitive, if (primitive.depthForm == null) y - region.rowStart else y, start, end)
            }
        }
    },
    Stranger(
        "region-of-one-column-at-0",
        "depth of a region of one column is evaluated at column 0; shows where that is not the region's",
        setOf("7.4", "9.6"),
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
                    super.walk(primitive, y, start, end)
                    val form = primitive.depthForm ?: return
                    if (width == 1) spanDepths[0] = (form.at(0, y) shr 32).toInt() and Int.MAX_VALUE
                }
            }
        }
    },
    Stranger(
        "region-rows-from-0",
        "rows are numbered from the region's first as they are handed out",
        setOf("7.3", "7.4"),
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun handOut(y: Int, sink: RowSink) = super.handOut(y - region.rowStart, sink)
            }
        }
    },
    Stranger(
        "region-of-middle-rows",
        "the last row of a region that ends above the raster's lower border is the row before it again",
        setOf("7.4"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun finishRow(keys: LongArray, offset: Int, y: Int, sink: RowSink) {
                    val isLast = y == region.rowEnd - 1 && y > region.rowStart && region.rowEnd < raster.height
                    if (isLast) handOut(y, sink) else super.finishRow(keys, offset, y, sink)
                }
            }
        }
    },
    Stranger(
        "region-asks-all",
        "every primitive is asked for its spans, those outside the region too; the picture is right",
        setOf("7.7"),
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun draw(primitive: Primitive, index: Int) {
                    if (!reaches(primitive)) primitive.spans(region.rowStart, spans.also { all -> all.clear() })
                    super.draw(primitive, index)
                }
            }
        }
    },
    Stranger(
        "region-asks-beside",
        "primitives beside the region, on its rows, are asked for cursors; those above and below are not",
        setOf("7.7"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun reaches(primitive: Primitive): Boolean =
                    primitive.rowStart < region.rowEnd && primitive.rowEnd > region.rowStart
            }
        }
    },
    Stranger(
        "rows-out-of-order-in-bands",
        "a band's rows are handed out from the bottom; shows on bands of 2 rows",
        setOf("7.3"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun finishRow(keys: LongArray, offset: Int, y: Int, sink: RowSink) {
                    val bottom = minOf(bandTop + bandRows, region.rowEnd)
                    val row = bottom - 1 - (y - bandTop)
                    super.finishRow(keys, (row - bandTop) * width, row, sink)
                }
            }
        }
    },
    Stranger("rows-of-background-skipped", "rows that show nothing but background are not handed out", setOf("7.3")) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun handOut(y: Int, sink: RowSink) {
                    if (indices.any { it >= 0 } || y == region.rowStart) super.handOut(y, sink)
                }
            }
        }
    },
    Stranger(
        "rows-colored-after-hand-out",
        "the last column gets its colour after the row is handed out",
        setOf("7.3"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                private var last = backgroundArgb()

                override fun handOut(y: Int, sink: RowSink) {
                    val own = argb[width - 1]
                    argb[width - 1] = last
                    super.handOut(y, sink)
                    last = own
                }
            }
        }
    },
    Stranger(
        "rows-on-standard-output",
        "prints its progress, which breaks pictures that are written there",
        setOf("7.3"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun drawBand(top: Int, bottom: Int) {
                    super.drawBand(top, bottom)
                    println("rows $top..<$bottom")
                }
            }
        }
    },
)
