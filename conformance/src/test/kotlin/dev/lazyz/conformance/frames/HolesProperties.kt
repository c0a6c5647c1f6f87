package dev.lazyz.conformance.frames

import dev.lazyz.conformance.assertSamePicture
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import net.jqwik.api.Arbitrary
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.Provide

/** A custom mix of frames, as shown in docs/conformance.md. */
class HolesProperties {
    @Property(tries = 200, seed = "1995")
    fun holesBehindHoles(@ForAll("holes") case: FrameCase) =
        assertSamePicture(ReferenceRenderer().render(case.frame), ZBufferRenderer().render(case.frame), case.code)

    @Provide
    fun holes(): Arbitrary<FrameCase> = Frames.of(
        FrameMix.of(FrameKind.HOLES, FrameKind.SLIVERS)
            .with(FrameKind.HOLES, 3) // three of four groups of primitives
            .sized(40, 30) // at most, in samples
            .counted(5, 20) // primitives, and besides
            .layered(2) // polygons that cover the whole raster
            .levels(4), // depths of vertices, so that there are ties
    )
}
