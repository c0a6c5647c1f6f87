package dev.lazyz.jmh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.lazyz.Counters;
import dev.lazyz.Frame;
import dev.lazyz.Renderer;
import dev.lazyz.RowSink;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.strategies.zbuffer.ZBufferRenderer;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.openjdk.jmh.annotations.Param;

class PictureCheckTest {
    @Test
    void aPictureWithOneWrongBitIsRefused() throws InterruptedException, IOException {
        Frame frame = Workloads.scene("layers").frame(8, 8);
        PictureCheck.verify(frame, new ZBufferRenderer());
        assertThrows(IllegalStateException.class, () -> PictureCheck.verify(frame, new OneBitOff()));
    }

    @Test
    void everyBuiltInStrategyIsMeasured() throws NoSuchFieldException {
        Param param = StrategyBenchmark.class.getField("strategy").getAnnotation(Param.class);
        assertEquals(Renderers.getBuiltIn().stream().map(Renderer::getId).toList(), List.of(param.value()));
    }

    private static final class OneBitOff implements Renderer {
        @Override
        public String getId() {
            return "one-bit-off";
        }

        @Override
        public String getSummary() {
            return "the z-buffer, but for one bit";
        }

        @Override
        public Counters render(Frame frame, RowSink sink) throws InterruptedException, IOException {
            return new ZBufferRenderer().render(frame, (y, argb, depth, primitive) -> {
                argb[y % 8] ^= y == 3 ? 1 : 0;
                sink.row(y, argb, depth, primitive);
            });
        }
    }
}
