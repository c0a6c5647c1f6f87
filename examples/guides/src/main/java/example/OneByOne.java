package example;

import dev.lazyz.Counters;
import dev.lazyz.DepthTest;
import dev.lazyz.Frame;
import dev.lazyz.Primitive;
import dev.lazyz.Raster;
import dev.lazyz.RenderedRows;
import dev.lazyz.Renderer;
import dev.lazyz.RowSink;
import dev.lazyz.StreamingRenderer.Rendering;
import dev.lazyz.StreamingRenderer;
import dev.lazyz.scenes.writers.PngSink;
import dev.lazyz.strategies.hybrid.HybridRenderer;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.OutputStream;

/** Pictures that are larger than memory, and frames that are: rows and primitives one by one. */
public class OneByOne {
    /** Returns the first row in which something is visible, or -1. The rows below it are not rendered. */
    public static int firstVisibleRow(Renderer renderer, Frame frame) {
        try (RenderedRows rows = RenderedRows.of(renderer, frame)) {
            while (rows.hasNext()) {
                RenderedRows.Row row = rows.next();
                for (int primitive : row.getPrimitive()) {
                    if (primitive != DepthTest.BACKGROUND) return row.getY();
                }
            }
            return -1;
        }
    }

    /** Writes a picture while it is rendered. */
    public static Counters writePng(Renderer renderer, Frame frame, OutputStream output)
            throws IOException, InterruptedException {
        try (PngSink sink = new PngSink(output, frame.getWidth(), frame.getHeight())) {
            return renderer.render(frame, sink);
        }
    }

    /** Draws a disc for each line of a text: column, row, radius and depth. */
    public static Counters draw(BufferedReader lines, Raster raster, RowSink sink)
            throws InterruptedException, IOException {
        StreamingRenderer renderer = new HybridRenderer();
        Rendering rendering = renderer.begin(raster);
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            rendering.add(disc(raster, line.split(" ")));
        }
        return rendering.finish(sink);
    }

    private static Primitive disc(Raster raster, String[] words) {
        return new Disc(
                raster,
                Integer.parseInt(words[0]),
                Integer.parseInt(words[1]),
                Integer.parseInt(words[2]),
                Integer.parseInt(words[3]));
    }
}
