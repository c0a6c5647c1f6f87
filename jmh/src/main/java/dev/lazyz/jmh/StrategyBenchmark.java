package dev.lazyz.jmh;

import dev.lazyz.Counters;
import dev.lazyz.Frame;
import dev.lazyz.Renderer;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.openjdk.jmh.infra.BenchmarkParams;
import org.openjdk.jmh.infra.Blackhole;

/**
 * The cost of a strategy on a scene: time, shading calls, depth evaluations, fragments per second; with
 * {@code -prof gc} also allocation ({@code gc.alloc.rate.norm}).
 *
 * <p>Rows are discarded. Not every strategy is designed for every scene, and all combinations take more than an hour:
 * choose with {@code -p}.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(value = 1, jvmArgsAppend = StrategyBenchmark.VECTOR_API)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@State(Scope.Benchmark)
public class StrategyBenchmark {
    /** Gives a fork access to the Vector API, which the fastest kernels use if it is available. */
    static final String VECTOR_API = "--add-modules=jdk.incubator.vector";

    /** A renderer's id. */
    @Param({
        "tiled",
        "zbuffer",
        "hybrid",
        "lazy",
        "flow",
        "lists",
        "scanline",
        "painter",
        "warnock",
        "hierarchical",
        "raycast",
        "bsp"
    })
    public String strategy;

    /** A scene's id, see {@link Workloads}. */
    @Param({"teapot", "city", "layers", "molecule", "S1", "S2", "S3", "S4", "S5", "S6"})
    public String scene;

    /** Width and height of the raster, samples. */
    @Param({"1024"})
    public int side;

    private Renderer renderer;
    private Scene world;
    private Frame frame;

    /**
     * The counters of one rendering, and fragments per second, reported in addition to the time. JMH adds events over
     * all iterations of all forks, so each iteration reports its share, and the sum is the mean.
     */
    @State(Scope.Thread)
    @AuxCounters(AuxCounters.Type.EVENTS)
    public static class Work {
        private Counters last;
        private double share;
        private long fragments;
        private long start;

        /** Starts a measurement. */
        @Setup(Level.Iteration)
        public void setUp(BenchmarkParams benchmark) {
            share = 1.0 / (benchmark.getMeasurement().getCount() * Math.max(1, benchmark.getForks()));
            fragments = 0;
            start = System.nanoTime();
        }

        /** Shading calls of one rendering. */
        public double shadingCalls() {
            return share * last.getShadingCalls();
        }

        /** Depth evaluations of one rendering. */
        public double depthEvaluations() {
            return share * last.getDepthEvaluations();
        }

        /** Covered samples of all primitives, per second. */
        public double fragmentsPerSecond() {
            return share * fragments * 1e9 / (System.nanoTime() - start);
        }

        private void add(Counters counters) {
            last = counters;
            fragments += counters.getFragments();
        }
    }

    /** Creates the scene, and fails if the renderer's image differs from the z-buffer's. */
    @Setup(Level.Trial)
    public void setUp() throws InterruptedException, IOException {
        renderer = PictureCheck.renderer(strategy);
        world = Workloads.scene(scene);
        frame = world.frame(side, side);
        PictureCheck.verify(frame, renderer);
    }

    /** Renders a frame that is already set up. */
    @Benchmark
    public void render(Work work, Blackhole hole) throws InterruptedException, IOException {
        work.add(PictureCheck.render(frame, renderer, hole));
    }

    /** Sets up a frame and renders it: from the scene to the image. */
    @Benchmark
    public void picture(Work work, Blackhole hole) throws InterruptedException, IOException {
        work.add(PictureCheck.render(world.frame(side, side), renderer, hole));
    }
}
