package dev.lazyz.conformance.frames;

import static dev.lazyz.conformance.PictureAssertions.assertSamePicture;

import dev.lazyz.conformance.cases.FrameCase;
import dev.lazyz.conformance.oracle.ReferenceRenderer;
import dev.lazyz.strategies.zbuffer.ZBufferRenderer;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;

/** A custom mix of frames from Java, as shown in docs/conformance.md. */
class HolesFromJavaProperties {
    @Property(tries = 200, seed = "1995")
    void holesBehindHoles(@ForAll("holes") FrameCase frameCase) throws InterruptedException {
        var frame = frameCase.getFrame();
        assertSamePicture(
                new ReferenceRenderer().render(frame), new ZBufferRenderer().render(frame), frameCase.getCode());
    }

    @Provide
    Arbitrary<FrameCase> holes() {
        return Frames.of(FrameMix.of(FrameKind.HOLES, FrameKind.SLIVERS)
                .with(FrameKind.HOLES, 3)
                .sized(40, 30)
                .counted(5, 20)
                .layered(2)
                .levels(4));
    }
}
