package dev.lazyz.jmh;

import dev.lazyz.Frame;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The time of set-up: from a scene in memory to a frame with transformed vertices and prepared primitives. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@State(Scope.Benchmark)
public class SetUpBenchmark {
    /** A scene's id, see {@link Workloads}. */
    @Param({"teapot", "city", "S1", "S2", "S6"})
    public String scene;

    /** Width and height of the raster, samples. */
    @Param({"1024"})
    public int side;

    private Scene world;

    /** Creates the scene, and fails if a second set-up gives a different image. */
    @Setup
    public void setUp() throws InterruptedException, IOException {
        world = Workloads.scene(scene);
        String first = PictureCheck.hash(world.frame(side, side), PictureCheck.renderer("zbuffer"));
        String second = PictureCheck.hash(Workloads.scene(scene).frame(side, side), PictureCheck.renderer("tiled"));
        PictureCheck.verify(second, first, "set-up of " + scene);
    }

    /** Sets up a frame. */
    @Benchmark
    public Frame frame() throws InterruptedException {
        return world.frame(side, side);
    }
}
