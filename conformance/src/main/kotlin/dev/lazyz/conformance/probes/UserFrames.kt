package dev.lazyz.conformance.probes

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.asOpaque
import dev.lazyz.conformance.cases.changed.within
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.strategies.lists.ListsRenderer

/** Fails unless [renderer] renders [own] and its inner part correctly, both row by row and into memory. */
internal fun framesAreRight(renderer: Renderer, own: FrameCase) {
    val case = if (Capability.TRANSPARENCY in renderer.capabilities) own else own.opaque()
    for (part in listOf(case, case.within(inner(case.frame)))) {
        Judgement(renderer, part).equalsPictureOf(oracle(part.frame)).equalsItsImage().rowsInOrder()
    }
}

private fun FrameCase.opaque(): FrameCase = if (frame.hasTranslucency) asOpaque() else this

/** Returns the region without a quarter on each side, but at least one sample. */
private fun inner(frame: Frame): Region = with(frame.region) {
    val column = columnStart + width / 4
    val row = rowStart + height / 4
    Region(column, row, column + (width + 1) / 2, row + (height + 1) / 2)
}

/** Returns the reference renderer or, if that would take minutes, a renderer that is tested against it. */
private fun oracle(frame: Frame): Renderer =
    if (frame.region.size * frame.primitives.size <= MOST_FRAGMENTS) ReferenceRenderer() else ListsRenderer()

private const val MOST_FRAGMENTS = 20_000_000L
