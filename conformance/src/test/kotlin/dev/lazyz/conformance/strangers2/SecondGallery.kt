package dev.lazyz.conformance.strangers2

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.conformance.strangers.Stranger

/** Renderers with one mistake each, by someone who has not seen the suite; and their right bases. */
internal object SecondGallery {
    /** The bases without a mistake. */
    val correct: List<() -> Renderer> = listOf(
        { RowByRow(RowSteps(), RenderOptions()) },
        { Buffered(BufferSteps()) },
        { Layers(LayerSteps(), RenderOptions()) },
        { Tiles(TileSteps(), RenderOptions()) },
    )

    /** The wrong ones. */
    val all: List<Stranger> =
        rowMistakes() + rowColorMistakes() + rowFlowMistakes() + bufferMistakes() + layerMistakes() +
            selectionMistakes() +
            tileMistakes()
}

/** Refuses what the bases that do not blend cannot draw. */
internal fun refuseTranslucent(frame: Frame, name: String) {
    if (!frame.hasTranslucency) return
    val index = frame.primitives.indexOfFirst { it.isTranslucent }
    refuse(index, name)
}

internal fun refuse(index: Int, name: String): Nothing =
    throw IllegalArgumentException("primitive $index is translucent; '$name' does not blend: use Frame.asOpaque()")

/** Whether the bounds of [primitive] reach into a rectangle of samples. */
internal fun overlaps(primitive: Primitive, columns: IntRange, rows: IntRange): Boolean =
    maxOf(primitive.rowStart, rows.first) < minOf(primitive.rowEnd, rows.last + 1) &&
        maxOf(primitive.columnStart, columns.first) < minOf(primitive.columnEnd, columns.last + 1)
