package dev.lazyz.jmh.peers;

import dev.lazyz.Counters;
import dev.lazyz.DepthTest;
import dev.lazyz.Image.PixelHash;
import dev.lazyz.Raster;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.Rgba;
import dev.lazyz.RowSink;
import dev.lazyz.ShadingRate;
import dev.lazyz.filter.SuperSampling;
import dev.lazyz.filter.SuperSampling.PixelFilter;
import dev.lazyz.jmh.PictureCheck;
import dev.lazyz.jmh.report.Options;
import dev.lazyz.jmh.workload.SteadyState;
import dev.lazyz.world.Scene;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;

/**
 * Renders one scene repeatedly, like the programs of other renderers, and prints one line of JSON with the results.
 *
 * <p>A frame is the work from a scene in memory to its rows: transforming the vertices and setting up all primitives,
 * as {@code scene.frame(raster)} does, and a rendering into a sink that discards the rows. Only the renderer is kept
 * between frames. Times are wall-clock milliseconds in steady state: they are measured after a warm-up that continues
 * until Java's compilers have been idle for two seconds, but at most for eight times its length.
 */
public final class PeerRun {
    private static final Set<String> OPTIONS =
            Set.of("scene", "side", "threads", "strategy", "samples", "warm-up", "measure", "picture");

    /** Minimum number of measured frames, however long they take. */
    private static final int LEAST_FRAMES = 5;

    private final Scene scene;
    private final SuperSampling sampling;
    private final Raster raster;
    private final Renderer renderer;
    private volatile int seen;

    private PeerRun(Scene scene, SuperSampling sampling, int side, Renderer renderer) {
        this.scene = scene;
        this.sampling = sampling;
        this.raster = new Raster(side, side, Rgba.TRANSPARENT);
        this.renderer = renderer;
    }

    /** Options: see {@code jmh/README.md}. */
    public static void main(String[] args) throws InterruptedException, IOException {
        Options options = new Options(args, OPTIONS);
        Renderer found = PictureCheck.renderer(options.get("strategy", "tiled"));
        int threads = Integer.parseInt(options.get("threads", "1"));
        PeerRun run = new PeerRun(
                TriangleSource.find(options.get("scene", "S1")).scene(),
                new SuperSampling(Integer.parseInt(options.get("samples", "1")), PixelFilter.BOX, ShadingRate.AUTO),
                Integer.parseInt(options.get("side", "1024")),
                found.configured(new RenderOptions().withThreads(threads)));
        String picture = options.get("picture", "");
        if (picture.isEmpty()) {
            double warmUp = Double.parseDouble(options.get("warm-up", "3"));
            System.out.println(run.measure(warmUp, Double.parseDouble(options.get("measure", "4"))));
        } else {
            System.out.println(run.write(Path.of(picture)));
        }
    }

    /** Returns times of frames in milliseconds, the first one before the warm-up, as JSON. */
    private String measure(double warmUp, double measure) throws InterruptedException, IOException {
        double first = frame();
        SteadyState.await(warmUp, this::frame);
        double[] times = new double[1 << 16];
        int count = 0;
        long end = System.nanoTime() + (long) (1e9 * measure);
        while (count < times.length && (count < LEAST_FRAMES || System.nanoTime() < end)) {
            times[count++] = frame();
        }
        Arrays.sort(times, 0, count);
        return String.format(
                Locale.ROOT,
                "{\"median\":%.4f,\"min\":%.4f,\"max\":%.4f,\"first\":%.4f,\"frames\":%d,\"version\":\"%s\"}",
                times[count / 2],
                times[0],
                times[count - 1],
                first,
                count,
                Runtime.version());
    }

    private Counters render(RowSink sink) throws InterruptedException, IOException {
        return sampling.frame(scene, raster).render(renderer, sink);
    }

    private double frame() throws InterruptedException, IOException {
        long start = System.nanoTime();
        Counters counters = render((y, argb, depth, primitive) -> seen = argb[0]);
        if (counters.getPrimitives() == 0) {
            throw new IllegalStateException("nothing was rendered");
        }
        return (System.nanoTime() - start) / 1e6;
    }

    /**
     * Writes the image like the other renderers: red, green, blue, alpha, one byte each, sRGB, in rows from the top.
     * Returns the number of samples in which something is visible, and the picture's hash, as JSON.
     */
    private String write(Path file) throws InterruptedException, IOException {
        PixelHash hash = new PixelHash();
        long[] covered = new long[1];
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file))) {
            RowSink sink = (y, argb, depth, primitive) -> {
                byte[] row = new byte[4 * raster.getWidth()];
                for (int x = 0; x < raster.getWidth(); x++) {
                    row[4 * x] = (byte) (argb[x] >> 16);
                    row[4 * x + 1] = (byte) (argb[x] >> 8);
                    row[4 * x + 2] = (byte) argb[x];
                    row[4 * x + 3] = (byte) (argb[x] >> 24);
                    covered[0] += primitive[x] == DepthTest.BACKGROUND ? 0 : 1;
                }
                hash.add(argb, raster.getWidth());
                try {
                    out.write(row);
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            };
            render(sink);
        }
        return "{\"covered\":" + covered[0] + ",\"hash\":\"" + hash.digest() + "\"}";
    }
}
