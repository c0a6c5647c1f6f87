package dev.lazyz;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.Frame.SeenPoint;
import dev.lazyz.StreamingRenderer.Rendering;
import dev.lazyz.setup.FrameBuilder;
import dev.lazyz.strategies.lazy.LazyRenderer;
import dev.lazyz.strategies.zbuffer.ZBufferRenderer;
import dev.lazyz.world.Scene;
import dev.lazyz.world.camera.Camera;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.material.Material.AlphaMode;
import dev.lazyz.world.surface.Mesh;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Typical Java code of a user of the library. */
class JavaSampleTest {
    @Test
    void aTranslucentPrimitiveIsMadeOpaque() throws InterruptedException {
        Material glass = new Material(Rgba.WHITE.withAlpha(0.5f)).withAlphaMode(AlphaMode.BLEND);
        Mesh mesh = new Mesh(new float[] {-1, -1, 0, 1, -1, 0, 0, 1, 0}, new int[] {0, 1, 2}, glass);
        Primitive triangle = new Scene(List.of(mesh), List.of(), Camera.fit(0, 0))
                .frame(32, 32)
                .getPrimitives()
                .get(0);
        assertTrue(triangle.isTranslucent());
        assertFalse(Primitives.asOpaque(triangle).isTranslucent());
    }

    @Test
    void rowsArePulled() {
        Frame frame = new FrameBuilder(new Raster(5, 3))
                .polygon(Rgba.BLACK, new double[9])
                .build();
        int sum = 0;
        try (RenderedRows rows = RenderedRows.of(new ZBufferRenderer(), frame)) {
            while (rows.hasNext()) {
                RenderedRows.Row row = rows.next();
                sum += row.getY() * row.getArgb().length;
            }
            assertEquals(0, rows.getCounters().getFragments());
        }
        assertEquals(15, sum);
    }

    @Test
    void whatIsSeenAtASampleIsKnown() throws InterruptedException {
        Frame frame = new FrameBuilder(new Raster(5, 3))
                .polygon(Rgba.BLACK, new double[] {1, 1, 0, 3, 1, 0, 3, 2, 0, 1, 2, 0})
                .build();
        SeenPoint point = frame.at(2, 1);
        assertEquals(0, point.getTriangle());
        assertEquals(2.5, point.getX());
        assertEquals("", point.getPart());
        assertEquals(point.getDepth(), frame.at(2, 1, new ZBufferRenderer()).getDepth());
        assertEquals(null, frame.at(4, 1));
    }

    /** It does not compile if a method does not declare what it throws. */
    @Test
    void exceptionsOfSinksAreCaught() throws InterruptedException {
        Frame frame = new FrameBuilder(new Raster(5, 3))
                .polygon(Rgba.BLACK, new double[9])
                .build();
        RowSink broken = (y, argb, depth, primitive) -> {
            throw new IOException("broken");
        };
        int caught = 0;
        try {
            new LazyRenderer().rows(frame).iterator().next().sendTo(broken);
        } catch (IOException e) {
            caught++;
        }
        try {
            new ZBufferRenderer().render(frame, broken);
        } catch (IOException e) {
            caught++;
        }
        assertEquals(2, caught);
    }

    @Test
    void primitivesArriveOneByOne() throws InterruptedException, IOException {
        Primitive square = new FrameBuilder(new Raster(5, 3))
                .polygon(Rgba.BLACK, new double[] {1, 1, 0, 3, 1, 0, 3, 2, 0, 1, 2, 0})
                .build()
                .getPrimitives()
                .get(0);
        StreamingRenderer renderer = new ZBufferRenderer();
        Rendering drawing = renderer.begin(new Raster(5, 3));
        drawing.add(square);
        drawing.add(square);
        int[] visible = {0};
        Counters counters = drawing.finish((y, argb, depth, primitive) -> {
            for (int index : primitive) {
                visible[0] += index == 0 ? 1 : 0;
            }
        });
        assertEquals(2, visible[0]);
        assertEquals(2, counters.getPrimitives());
        assertThrows(IllegalStateException.class, () -> drawing.add(square));
    }
}
