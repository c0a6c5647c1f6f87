package dev.lazyz.conformance.probes

import dev.lazyz.Capability
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Selector
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.cases.glazed
import java.util.Random

// A promise holds however a frame is rendered: with translucent primitives, in part, and with a selector.

/** Returns the frame; in one of two cases partly translucent, if [renderer] blends; and in one of two cases in part. */
internal fun FrameCase.variedFor(renderer: Renderer, random: Random): FrameCase {
    val choice = random.nextInt()
    val isBlending = Capability.TRANSPARENCY in renderer.capabilities
    val case = if (isBlending && random.nextBoolean()) glazed(choice) else this
    return if (random.nextBoolean()) case.withinAny(random) else case
}

/** Returns this renderer; in one of three cases with a selector, if it supports them. */
internal fun Renderer.varied(random: Random): Renderer =
    if (random.nextInt(3) == 0) configured(SELECTING.supportedBy(this)) else this

private val SELECTING = RenderOptions(selector = Selector.blend())
