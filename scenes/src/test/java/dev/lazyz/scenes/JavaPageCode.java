package dev.lazyz.scenes;

import dev.lazyz.Frame;
import dev.lazyz.Image;
import dev.lazyz.Raster;
import dev.lazyz.RenderedRows;
import dev.lazyz.RowSink;
import dev.lazyz.filter.SampledFrame;
import dev.lazyz.filter.SuperSampling;
import dev.lazyz.planning.RenderPlanner;
import dev.lazyz.planning.RenderPlanner.RenderPlan;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.writers.PngSink;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** Code that pages of {@code docs} show: it compiles. */
final class JavaPageCode {
    private JavaPageCode() {}

    static void largeModel() throws IOException, InterruptedException {
        try (StreamedScene streamed = Scenes.stream(Path.of("scan.stl"))) {
            Frame frame = streamed.getLoaded().getScene().frame(1024, 1024);
            Image image = new TiledRenderer().render(frame);
        }
    }

    static void largePicture(Frame frame) {
        try (RenderedRows rows = RenderedRows.of(new TiledRenderer(), frame)) {
            while (rows.hasNext()) {
                consume(rows.next().getArgb());
            }
        }
    }

    private static void consume(int[] argb) {}

    static void memory(Scene scene, RowSink sink) throws InterruptedException, IOException {
        SampledFrame frame = new SuperSampling(4).frame(scene, new Raster(8000, 6000));
        RenderPlan.Item output = new RenderPlan.Item("output", PngSink.memory(8000, 6000));
        RenderPlan plan = new RenderPlanner(512L << 20).plan(frame, Renderers.getBuiltIn(), List.of(output));
        if (plan.getFits()) frame.render(plan.getRenderer(), sink);
        else System.err.println(plan.explain());
    }
}
