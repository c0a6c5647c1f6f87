package dev.lazyz.conformance

import dev.lazyz.Frame
import dev.lazyz.Primitive

/**
 * A primitive made translucent: everything is as in [whole], and its colours' alpha counts (contract rule 5.5).
 *
 * The colours of [Frames.tint] have any alpha from 0 to 1. Immutable and thread safe if [whole] is.
 */
public class Glass(private val whole: Primitive) : Primitive by whole {
    override val isTranslucent: Boolean get() = true

    override fun toString(): String = "Glass($whole)"
}

/** The same frame, with [Glass] for each primitive whose number, modulo 16, is that of a bit set in [choice]. */
public fun Frame.glazed(choice: Int): Frame =
    Frame(raster, primitives.mapIndexed { i, it -> if (choice shr i % 16 and 1 == 1) Glass(it) else it }, region)

/** The same frame, with [Glass] as [choice] says. */
internal fun FrameCase.glazed(choice: Int): FrameCase = FrameCase(frame.glazed(choice), "$code\n    .glazed($choice)")
