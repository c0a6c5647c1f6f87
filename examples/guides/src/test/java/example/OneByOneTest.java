package example;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.lazyz.Counters;
import dev.lazyz.Frame;
import dev.lazyz.Image;
import dev.lazyz.Raster;
import dev.lazyz.Renderer;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.strategies.zbuffer.ZBufferRenderer;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.StringReader;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** Rows that are pulled and primitives that are pushed give the picture of the whole frame. */
class OneByOneTest {
    private final Raster raster = new Raster(64, 48);
    private final Frame frame =
            new Frame(raster, List.of(new Disc(raster, 20, 20, 15, 1000), new Disc(raster, 30, 28, 10, 500)));

    @Test
    void theFirstVisibleRowIsFound() {
        Frame empty = new Frame(raster, List.of());
        for (Renderer renderer : Renderers.getBuiltIn()) {
            assertEquals(5, OneByOne.firstVisibleRow(renderer, frame), renderer.getId());
            assertEquals(-1, OneByOne.firstVisibleRow(renderer, empty), renderer.getId());
        }
    }

    @Test
    void aFileIsWrittenWhileItsPictureIsRendered() throws IOException, InterruptedException {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        OneByOne.writePng(new TiledRenderer(), frame, file);
        BufferedImage read = ImageIO.read(new ByteArrayInputStream(file.toByteArray()));
        assertArrayEquals(new TiledRenderer().render(frame).getArgb(), read.getRGB(0, 0, 64, 48, null, 0, 64));
    }

    @Test
    void discsArriveOneByOne() throws IOException, InterruptedException {
        Image expected = new ZBufferRenderer().render(frame);
        Image.Collector rows = new Image.Collector(raster.getRegion());
        BufferedReader lines = new BufferedReader(new StringReader("20 20 15 1000\n30 28 10 500\n"));
        Counters counters = OneByOne.draw(lines, raster, rows);
        assertEquals(expected.pixelHash(), rows.toImage(counters).pixelHash());
    }
}
