package dev.lazyz.jmh.growth;

import com.sun.management.ThreadMXBean;
import dev.lazyz.Capability;
import dev.lazyz.Counters;
import dev.lazyz.Raster;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.Rgba;
import dev.lazyz.RowSink;
import dev.lazyz.jmh.report.Options;
import dev.lazyz.strategies.FrameNumbers;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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
    private static final Set<String> OPTIONS =
            Set.of("axes", "points", "rounds", "limit", "warm-up", "results", "page", "costs");

    /** Minimum total time of a strategy's frames in a round, nanoseconds. */
    private static final long LEAST_TIME = 50_000_000;

    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    private final int rounds;
    private final double limit;
    private final GrowthResults results;
    private volatile int seen;

    private Growth(GrowthResults results, int rounds, double limit) {
        this.results = results;
        this.rounds = rounds;
        this.limit = limit;
    }

    /** Options: see {@code jmh/README.md}. */
    public static void main(String[] args) throws InterruptedException, IOException {
        Options options = new Options(args, OPTIONS);
        Path file = Path.of(options.get("results", "docs/growth/results.json"));
        List<String> axes = options.list("axes", "triangles,pixels,small,depth,shading,threads,scenes");
        GrowthResults others = Files.exists(file) ? GrowthResults.read(file).without(axes) : GrowthResults.empty();
        Growth growth = new Growth(
                others, Integer.parseInt(options.get("rounds", "3")), Double.parseDouble(options.get("limit", "20")));
        growth.recordFacts(String.join(" ", args));
        growth.warmUp(Double.parseDouble(options.get("warm-up", "2")));
        for (String axis : axes) {
            growth.measure(Axis.find(axis), Integer.parseInt(options.get("points", "9")));

            // If a long run is stopped, the results so far are kept
            growth.results.write(file);
        }
        GrowthPage.main(new String[] {
            options.get("page", "docs/growth.md"), file.toString(), options.get("costs", GrowthPage.COSTS)
        });
    }

    /** Records the facts that are needed to judge the figures. */
    private void recordFacts(String arguments) throws IOException {
        Map<String, String> facts = results.facts();
        facts.put("last command", ("Growth " + arguments).trim());
        facts.put("date", LocalDate.now().toString());
        facts.put("heap, MiB", Long.toString(Runtime.getRuntime().maxMemory() >> 20));
        facts.put("limit, s", Double.toString(limit));
        facts.put("rounds", Integer.toString(rounds));
        facts.put("processors", Integer.toString(Runtime.getRuntime().availableProcessors()));
        facts.put(
                "Java", Runtime.version() + ", kernel of tiled: " + new dev.lazyz.strategies.tiled.Tiled().getKernel());
        facts.put("system", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
        Path processors = Path.of("/proc/cpuinfo");
        if (Files.exists(processors)) {
            Files.readString(processors)
                    .lines()
                    .filter(line -> line.startsWith("model name"))
                    .findFirst()
                    .ifPresent(line -> facts.put("processor", line.substring(line.indexOf(':') + 2)));
        }
    }

    /** Renders representative scenes with each strategy, for some seconds. */
    private void warmUp(double seconds) throws InterruptedException, IOException {
        List<Scene> scenes = List.of(Axis.TRIANGLES.scene(1_000), Axis.DEPTH.scene(10), Axis.SHADING.scene(3));
        for (Renderer renderer : Renderers.getBuiltIn()) {
            long end = System.nanoTime() + (long) (1e9 * seconds);
            do {
                for (Scene scene : scenes) {
                    frame(scene, new Raster(256, 256, Rgba.TRANSPARENT), with(renderer, 1));
                }
            } while (System.nanoTime() < end);
        }
    }

    private void measure(Axis axis, int points) throws InterruptedException, IOException {
        Map<String, String> skipped = new HashMap<>();
        for (long value : axis.first(points).toArray()) {
            measure(axis, value, skipped);
        }
    }

    /**
     * Measures all strategies at a point. {@code skipped} maps skipped strategies to the reason; strategies that fail
     * are added.
     */
    private void measure(Axis axis, long value, Map<String, String> skipped) throws InterruptedException, IOException {
        Scene scene = axis.scene(value);
        int side = axis.side(value);
        Raster raster = new Raster(side, side, Rgba.TRANSPARENT);
        FrameNumbers numbers = FrameNumbers.of(scene.frame(raster));
        results.points()
                .add(new GrowthResults.Point(
                        axis.id(),
                        value,
                        side,
                        axis.threads(value),
                        axis.rounds(value),
                        numbers.getPrimitives(),
                        numbers.getPrimitiveRows(),
                        numbers.getFragments()));
        long[] expected = new long[1];
        List<Renderer> repeated = new ArrayList<>();
        for (Renderer builtIn : Renderers.getBuiltIn()) {
            String id = builtIn.getId();
            if (axis == Axis.THREADS && !builtIn.getCapabilities().contains(Capability.PARALLEL)) {
                continue;
            }
            if (skipped.containsKey(id)) {
                results.missing().add(new GrowthResults.Missing(axis.id(), value, id, skipped.get(id)));
                continue;
            }
            Renderer renderer = with(builtIn, axis.threads(value));
            try {
                GrowthResults.Cost first = first(axis, value, renderer, scene, raster, expected);
                if (first.millis() > 1e3 * limit && axis != Axis.SCENES) {
                    skipped.put(id, GrowthResults.SLOW);
                }
                if (first.millis() > 250 * limit) {
                    add(first);
                } else {
                    repeated.add(renderer);
                }
            } catch (OutOfMemoryError full) {
                skipped.put(id, GrowthResults.MEMORY);
                results.missing().add(new GrowthResults.Missing(axis.id(), value, id, GrowthResults.MEMORY));
                System.out.printf("%-16s %,12d  %-12s does not fit%n", axis.title, value, id);
            }
        }
        for (int round = 1; round <= rounds; round++) {
            for (Renderer renderer : repeated) {
                add(axis, value, renderer, round, scene, raster);
            }
        }
    }

    private static Renderer with(Renderer renderer, int threads) {
        return renderer.configured(new RenderOptions().withThreads(threads));
    }

    /** Renders a first frame, and compares its image with the first strategy's. */
    private static GrowthResults.Cost first(
            Axis axis, long value, Renderer renderer, Scene scene, Raster raster, long[] expected)
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
        double millis = (System.nanoTime() - start) / 1e6;
        long allocated = allocatedBytes() - before;
        if (expected[0] == 0) {
            expected[0] = hash[0];
        }
        if (hash[0] != expected[0]) {
            throw new IllegalStateException(renderer.getId() + " gives another picture");
        }
        return cost(axis, value, renderer, 1, millis, 1, allocated, counters);
    }

    private void add(Axis axis, long value, Renderer renderer, int round, Scene scene, Raster raster)
            throws InterruptedException, IOException {
        List<Double> times = new ArrayList<>();
        long allocated = 0;
        Counters counters;
        long begin = System.nanoTime();
        do {
            long before = allocatedBytes();
            long start = System.nanoTime();
            counters = frame(scene, raster, renderer);
            times.add((System.nanoTime() - start) / 1e6);
            allocated = allocatedBytes() - before;
        } while (System.nanoTime() - begin < LEAST_TIME);
        double millis = GrowthResults.median(
                times.stream().mapToDouble(Double::doubleValue).toArray());
        add(cost(axis, value, renderer, round, millis, times.size(), allocated, counters));
    }

    private static GrowthResults.Cost cost(
            Axis axis,
            long value,
            Renderer renderer,
            int round,
            double millis,
            int frames,
            long allocated,
            Counters counters) {
        double rounded = Math.round(millis * 1e4) / 1e4;
        return new GrowthResults.Cost(
                axis.id(), value, renderer.getId(), round, rounded, frames, allocated, counters.getPeakBytes());
    }

    private void add(GrowthResults.Cost cost) {
        results.costs().add(cost);
        System.out.printf(
                Locale.ROOT,
                "%-16s %,12d  %-12s %d %10.2f ms%n",
                cost.axis(),
                cost.value(),
                cost.strategy(),
                cost.round(),
                cost.millis());
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
