package dev.lazyz.jmh;

import dev.lazyz.Counters;
import dev.lazyz.Frame;
import dev.lazyz.Renderer;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.world.Scene;
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
 * What a strategy costs on a scene: time, shading calls, depth evaluations, fragments a second; allocation with
 * {@code -prof gc} ({@code gc.alloc.rate.norm}).
 *
 * <p>Rows are thrown away. Not every strategy is made for every scene, and all on all take more than an hour: choose
 * with {@code -p}.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(value = 1, jvmArgsAppend = StrategyBenchmark.VECTOR_API)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@State(Scope.Benchmark)
public class StrategyBenchmark {
    /** Lets a fork find the Vector API, which the fastest kernels use when they can. */
    static final String VECTOR_API = "--add-modules=jdk.incubator.vector";

    /** A renderer's id. */
    @Param({"tiled", "zbuffer", "lazy", "flow", "hybrid", "lists", "scanline", "painter", "warnock", "hierarchical"})
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
     * What one rendering counts, and fragments by time; reported beside its time. Events are added up over all iterations
     * of all forks, so each reports its share: the sum is the mean.
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
            return share * last.shadingCalls;
        }

        /** Depth evaluations of one rendering. */
        public double depthEvaluations() {
            return share * last.depthEvaluations;
        }

        /** Covered samples of all primitives, decided in a second. */
        public double fragmentsPerSecond() {
            return share * fragments * 1e9 / (System.nanoTime() - start);
        }

        private void add(Counters counters) {
            last = counters;
            fragments += counters.fragments;
        }
    }

    /** Makes the scene, and refuses to measure a renderer whose picture is not the z-buffer's. */
    @Setup(Level.Trial)
    public void setUp() {
        renderer = PictureCheck.renderer(strategy);
        world = Workloads.scene(scene);
        frame = world.frame(side, side);
        PictureCheck.verify(frame, renderer);
    }

    /** Renders a frame that has been set up. */
    @Benchmark
    public void render(Work work, Blackhole hole) {
        work.add(PictureCheck.render(frame, renderer, hole));
    }

    /** Sets a frame up and renders it: from the scene to the picture. */
    @Benchmark
    public void picture(Work work, Blackhole hole) {
        work.add(PictureCheck.render(world.frame(side, side), renderer, hole));
    }
}
