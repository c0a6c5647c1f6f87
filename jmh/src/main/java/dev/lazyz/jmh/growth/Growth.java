package dev.lazyz.jmh.growth;

import com.sun.management.ThreadMXBean;
import dev.lazyz.Capability;
import dev.lazyz.Counters;
import dev.lazyz.Raster;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.Rgba;
import dev.lazyz.RowSink;
import dev.lazyz.jmh.report.Measurements;
import dev.lazyz.jmh.report.Options;
import dev.lazyz.strategies.FrameNumbers;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Measures how the time and memory of every built-in strategy grow with triangles, pixels, depth complexity, shading
 * and threads. Then {@link GrowthPage} writes tables, charts and the coefficients of
 * {@link dev.lazyz.strategies.StrategyModel}.
 *
 * <p>A frame is {@code scene.frame(raster)} and a rendering into a sink that discards the rows. At each point the
 * images of all strategies are compared first, which also warms them up; then the strategies are measured in turn,
 * round by round. If a strategy's first frame takes longer than a quarter of the limit, it is the only frame. A
 * strategy that is slower than the limit, or that runs out of memory, is not measured at larger points of that axis.
 * Results of other axes in the results file are kept.
 */
public final class Growth {
    /** Wall-clock time of a frame, including set-up; the median of a round's frames. */
    static final String TIME = "frame ms";

    /** Bytes that threads which still exist afterwards have allocated in a frame, including set-up. */
    static final String ALLOCATED = "allocated bytes";

    /** Peak working memory in bytes, as the renderer reports it. */
    static final String PEAK = "peak bytes";

    /** The program of numbers that are a frame's own: see {@link FrameNumbers}. */
    static final String FRAME = "frame";

    static final String PRIMITIVES = "primitives";
    static final String ROWS = "primitive rows";
    static final String FRAGMENTS = "fragments";

    private static final Set<String> OPTIONS =
            Set.of("axes", "points", "rounds", "limit", "warm-up", "results", "page", "costs");

    /** Minimum total time of a strategy's frames in a round, nanoseconds. */
    private static final long LEAST_TIME = 50_000_000;

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private final int rounds;
    private final double limit;
    private final Measurements results;
    private volatile int seen;

    private Growth(Measurements results, int rounds, double limit) {
        this.results = results;
        this.rounds = rounds;
        this.limit = limit;
    }

    /** Options: see {@code jmh/README.md}. */
    public static void main(String[] args) throws InterruptedException, IOException {
        Options options = new Options(args, OPTIONS);
        Path file = Path.of(options.get("results", "docs/growth/results.csv"));
        List<String> axes = options.list("axes", "triangles,pixels,small,depth,shading,threads,scenes");
        Measurements results = Files.exists(file) ? Measurements.read(file) : new Measurements();
        results.removeIf(value -> axes.contains(value.subject().split(" ")[0]));
        Growth growth = new Growth(
                results, Integer.parseInt(options.get("rounds", "3")), Double.parseDouble(options.get("limit", "20")));
        results.noteMachine();
        results.note("command", ("Growth " + String.join(" ", args)).trim());
        results.note("heap MiB", Long.toString(Runtime.getRuntime().maxMemory() >> 20));
        results.note("kernel of tiled", new TiledRenderer().getKernel().toString());
        growth.warmUp(Double.parseDouble(options.get("warm-up", "2")));
        for (String axis : axes) {
            growth.measure(GrowthAxis.find(axis), Integer.parseInt(options.get("points", "9")));

            // If a long run is stopped, the results so far are kept
            results.write(file);
        }
        GrowthPage.main(new String[] {
            options.get("page", "docs/growth.md"), file.toString(), options.get("costs", GrowthPage.COSTS)
        });
    }

    /** Renders representative scenes with each strategy, for some seconds. */
    private void warmUp(double seconds) throws InterruptedException, IOException {
        List<Scene> scenes =
                List.of(GrowthAxis.TRIANGLES.scene(1_000), GrowthAxis.DEPTH.scene(10), GrowthAxis.SHADING.scene(3));
        for (Renderer renderer : Renderers.getBuiltIn()) {
            long end = System.nanoTime() + (long) (1e9 * seconds);
            do {
                for (Scene scene : scenes) {
                    frame(scene, new Raster(256, 256, Rgba.TRANSPARENT), with(renderer, 1));
                }
            } while (System.nanoTime() < end);
        }
    }

    private void measure(GrowthAxis axis, int points) throws InterruptedException, IOException {
        Set<String> skipped = new HashSet<>();
        for (long value : axis.first(points).toArray()) {
            measure(axis, value, skipped);
        }
    }

    /** Measures all strategies at a point but those that are skipped; strategies that fail are added to them. */
    private void measure(GrowthAxis axis, long value, Set<String> skipped) throws InterruptedException, IOException {
        String subject = axis.subject(value);
        Scene scene = axis.scene(value);
        Raster raster = new Raster(axis.side(value), axis.side(value), Rgba.TRANSPARENT);
        FrameNumbers numbers = FrameNumbers.of(scene.frame(raster));
        results.add(PRIMITIVES, subject, FRAME, 0, numbers.getPrimitives());
        results.add(ROWS, subject, FRAME, 0, numbers.getPrimitiveRows());
        results.add(FRAGMENTS, subject, FRAME, 0, numbers.getFragments());
        long[] expected = new long[1];
        List<Renderer> repeated = new ArrayList<>();
        for (Renderer builtIn : Renderers.getBuiltIn()) {
            boolean canShare =
                    axis != GrowthAxis.THREADS || builtIn.getCapabilities().contains(Capability.PARALLEL);
            if (!canShare || skipped.contains(builtIn.getId())) {
                continue;
            }
            Renderer renderer = with(builtIn, axis.threads(value));
            try {
                Cost first = first(renderer, scene, raster, expected);
                if (first.millis > 1e3 * limit && axis != GrowthAxis.SCENES) {
                    skipped.add(renderer.getId());
                }
                if (first.millis > 250 * limit) {
                    add(subject, renderer, 1, first);
                } else {
                    repeated.add(renderer);
                }
            } catch (OutOfMemoryError full) {
                skipped.add(renderer.getId());
                System.out.println(subject + ": " + renderer.getId() + " does not fit");
            }
        }
        for (int round = 1; round <= rounds; round++) {
            for (Renderer renderer : repeated) {
                add(subject, renderer, round, cost(scene, raster, renderer));
            }
        }
    }

    /** What a rendering cost. */
    private record Cost(double millis, long allocated, Counters counters) {}

    private void add(String subject, Renderer renderer, int round, Cost cost) {
        results.add(TIME, subject, renderer.getId(), round, cost.millis);
        results.add(ALLOCATED, subject, renderer.getId(), round, cost.allocated);
        results.add(PEAK, subject, renderer.getId(), round, cost.counters.getPeakBytes());
    }

    private static Renderer with(Renderer renderer, int threads) {
        return renderer.configured(new RenderOptions().withThreads(threads));
    }

    /** Renders a first frame, and compares its image with the first strategy's. */
    private static Cost first(Renderer renderer, Scene scene, Raster raster, long[] expected)
            throws InterruptedException, IOException {
        long[] hash = {1};
        RowSink sink = (y, argb, depth, primitive) -> {
            long h = hash[0];
            for (int x = 0; x < raster.getWidth(); x++) {
                h = (h ^ argb[x] ^ (long) primitive[x] << 32) * 0x9E3779B97F4A7C15L;
            }
            hash[0] = h ^ h >>> 29;
        };
        long before = allocatedBytes();
        long start = System.nanoTime();
        Counters counters = renderer.render(scene.frame(raster), sink);
        Cost cost = new Cost((System.nanoTime() - start) / 1e6, allocatedBytes() - before, counters);
        if (expected[0] == 0) {
            expected[0] = hash[0];
        }
        if (hash[0] != expected[0]) {
            throw new IllegalStateException(renderer.getId() + " gives another picture");
        }
        return cost;
    }

    /** Renders frames for a while; returns the median of their times, and the memory of the last. */
    private Cost cost(Scene scene, Raster raster, Renderer renderer) throws InterruptedException, IOException {
        List<Double> times = new ArrayList<>();
        long allocated;
        Counters counters;
        long begin = System.nanoTime();
        do {
            long before = allocatedBytes();
            long start = System.nanoTime();
            counters = frame(scene, raster, renderer);
            times.add((System.nanoTime() - start) / 1e6);
            allocated = allocatedBytes() - before;
        } while (System.nanoTime() - begin < LEAST_TIME);
        double[] millis = times.stream().mapToDouble(Double::doubleValue).toArray();
        return new Cost(Measurements.median(millis).orElseThrow(), allocated, counters);
    }

    private Counters frame(Scene scene, Raster raster, Renderer renderer) throws InterruptedException, IOException {
        return renderer.render(scene.frame(raster), (y, argb, depth, primitive) -> seen = argb[0]);
    }

    private static long allocatedBytes() {
        long sum = 0;
        for (long bytes : THREADS.getThreadAllocatedBytes(THREADS.getAllThreadIds())) {
            sum += Math.max(0, bytes);
        }
        return sum;
    }
}
