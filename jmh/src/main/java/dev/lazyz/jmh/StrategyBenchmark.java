package dev.lazyz.jmh;

import dev.lazyz.Counters;
import dev.lazyz.Frame;
import dev.lazyz.PixelHash;
import dev.lazyz.Renderer;
import dev.lazyz.Renderers;
import dev.lazyz.scenes.Scenes;
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
import org.openjdk.jmh.infra.Blackhole;

/**
 * What a strategy costs on a built-in scene: time, shading calls, depth evaluations; allocation with {@code -prof gc}
 * ({@code gc.alloc.rate.norm}).
 *
 * <p>The frame is set up beforehand and rows are thrown away, so that only the strategy is measured.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@State(Scope.Benchmark)
public class StrategyBenchmark {
    /** A renderer's id. */
    @Param({"zbuffer"})
    public String strategy;

    /** A built-in scene's id. */
    @Param({"teapot", "city", "layers", "molecule"})
    public String scene;

    /** Width and height of the raster, samples. */
    @Param({"512"})
    public int side;

    private Renderer renderer;
    private Frame frame;

    /** What one rendering counts; reported beside its time. */
    @State(Scope.Thread)
    @AuxCounters(AuxCounters.Type.EVENTS)
    public static class Work {
        private Counters last = new Counters();

        /** Shading calls of one rendering. */
        public long shadingCalls() {
            return last.shadingCalls;
        }

        /** Depth evaluations of one rendering. */
        public long depthEvaluations() {
            return last.depthEvaluations;
        }
    }

    /** Sets the frame up, and refuses to measure a renderer whose picture is not the z-buffer's. */
    @Setup(Level.Trial)
    public void setUp() {
        renderer = find(strategy);
        frame = Scenes.builtin(scene).frame(side, side);
        String expected = hash(find("zbuffer"));
        String actual = hash(renderer);
        if (!actual.equals(expected)) {
            throw new IllegalStateException(strategy + " renders " + actual + " instead of " + expected);
        }
    }

    /** Renders the frame once. */
    @Benchmark
    public void render(Work work, Blackhole hole) {
        work.last = renderer.render(frame, (y, argb, depth, primitive) -> {
            hole.consume(argb);
            hole.consume(depth);
            hole.consume(primitive);
        });
    }

    private Renderer find(String id) {
        Renderer found = Renderers.find(id);
        if (found == null) {
            throw new IllegalArgumentException("no such strategy: " + id);
        }
        return found;
    }

    private String hash(Renderer renderer) {
        PixelHash hash = new PixelHash();
        renderer.render(frame, (y, argb, depth, primitive) -> hash.add(argb, side));
        return hash.digest();
    }
}
