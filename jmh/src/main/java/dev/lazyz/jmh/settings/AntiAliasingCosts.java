package dev.lazyz.jmh.settings;

import dev.lazyz.Image;
import dev.lazyz.Raster;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.ShadingRate;
import dev.lazyz.filter.SampledFrame;
import dev.lazyz.filter.SuperSampling;
import dev.lazyz.filter.SuperSampling.PixelFilter;
import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Measures error and time of the settings of anti-aliasing, and writes the table of {@code docs/anti-aliasing.md}.
 *
 * <p>The truth is a picture with 64 x 64 samples a pixel and the same filter. The error is the root of the mean squared
 * difference of red, green and blue, in sRGB codes. Time is processor time of one thread for rendering a frame, without
 * set-up: the least of some runs, divided by that with one sample a pixel.
 */
public final class AntiAliasingCosts {
    private static final List<String> SCENES = List.of("teapot", "city", "plane");
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;
    private static final int TRUTH = 64;
    private static final int RUNS = 15;

    /** Least time for the runs of a setting, nanoseconds: Java's compilers must have finished before the last one. */
    private static final long LEAST_TIME = 1_500_000_000L;

    private static final Renderer RENDERER = new TiledRenderer(new RenderOptions().withThreads(1));

    private AntiAliasingCosts() {}

    /** The argument is the page. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Path page = Path.of(arguments[0]);
        String table = table(SCENES);
        GeneratedPage.update(page, name -> table);
    }

    /** Returns the table for the named built-in scenes. */
    static String table(List<String> names) throws InterruptedException {
        List<String> head = new ArrayList<>(List.of("samples", "filter", "shading"));
        names.forEach(name -> head.add(name + ": error, time"));
        List<List<String>> rows = new ArrayList<>();
        for (SuperSampling setting : settings()) {
            rows.add(new ArrayList<>(List.of(
                    setting.getFactor() + " x " + setting.getFactor(),
                    word(setting.getFilter()),
                    word(setting.getRate()))));
        }
        for (String name : names) {
            Scene scene = Scenes.builtin(name);
            time(frame(scene, SuperSampling.NONE));
            double base = time(frame(scene, SuperSampling.NONE));
            Map<PixelFilter, Image> truths = new EnumMap<>(PixelFilter.class);
            for (PixelFilter filter : PixelFilter.values()) {
                truths.put(
                        filter, frame(scene, new SuperSampling(TRUTH, filter)).render(RENDERER));
            }
            for (int i = 0; i < rows.size(); i++) {
                SuperSampling setting = settings().get(i);
                SampledFrame frame = frame(scene, setting);
                double error = error(truths.get(setting.getFilter()), frame.render(RENDERER));
                rows.get(i).add(String.format(Locale.ROOT, "%.2f, %.1f", error, time(frame) / base));
            }
        }
        return GeneratedPage.table(head, rows);
    }

    private static List<SuperSampling> settings() {
        List<SuperSampling> settings = new ArrayList<>();
        for (int factor : new int[] {1, 2, 4, 8}) {
            settings.add(new SuperSampling(factor));
        }
        settings.add(new SuperSampling(4, PixelFilter.BOX, ShadingRate.PIXEL));
        settings.add(new SuperSampling(4, PixelFilter.BOX, ShadingRate.AUTO));
        settings.add(new SuperSampling(4, PixelFilter.MITCHELL));
        settings.add(new SuperSampling(4, PixelFilter.BLACKMAN_HARRIS));
        return settings;
    }

    private static SampledFrame frame(Scene scene, SuperSampling sampling) throws InterruptedException {
        return sampling.frame(scene, new Raster(WIDTH, HEIGHT, scene.getBackground()));
    }

    private static String word(Enum<?> value) {
        return value.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Returns the least processor time of a rendering, in nanoseconds. */
    private static double time(SampledFrame frame) throws InterruptedException {
        double least = Double.MAX_VALUE;
        ThreadMXBean clock = ManagementFactory.getThreadMXBean();
        long end = clock.getCurrentThreadCpuTime() + LEAST_TIME;
        for (int run = 0; run < RUNS || clock.getCurrentThreadCpuTime() < end; run++) {
            long start = clock.getCurrentThreadCpuTime();
            frame.render(RENDERER);
            least = Math.min(least, clock.getCurrentThreadCpuTime() - start);
        }
        return least;
    }

    /** Returns the root of the mean squared difference of red, green and blue. */
    static double error(Image truth, Image image) {
        double sum = 0;
        int[] expected = truth.getArgb();
        int[] actual = image.getArgb();
        for (int i = 0; i < expected.length; i++) {
            for (int shift = 0; shift < 24; shift += 8) {
                double off = (expected[i] >> shift & 0xFF) - (actual[i] >> shift & 0xFF);
                sum += off * off;
            }
        }
        return Math.sqrt(sum / (3.0 * expected.length));
    }
}
