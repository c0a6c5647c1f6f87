package dev.lazyz.jmh;

import dev.lazyz.Image;
import dev.lazyz.jmh.workload.Workloads;
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
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The time of the first image of a process, from a scene's name to an image, including class loading and interpreted
 * code.
 */
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(value = 5, jvmArgsAppend = StrategyBenchmark.VECTOR_API)
@Warmup(iterations = 0)
@Measurement(iterations = 1)
@State(Scope.Benchmark)
public class ColdStartBenchmark {
    /** A renderer's id. */
    @Param({"tiled", "scanline", "zbuffer"})
    public String strategy;

    /** A scene's id, see {@link Workloads}. */
    @Param({"teapot"})
    public String scene;

    /** Width and height of the raster, samples. */
    @Param({"256"})
    public int side;

    private Image image;

    /** Renders the first image. */
    @Benchmark
    public Image firstPicture() throws InterruptedException {
        image = PictureCheck.renderer(strategy).render(Workloads.scene(scene).frame(side, side));
        return image;
    }

    /**
     * Fails the benchmark if the image differs from the z-buffer's. Checks afterwards, because a check before would
     * warm up.
     */
    @TearDown
    public void tearDown() throws InterruptedException, IOException {
        String expected = PictureCheck.hash(Workloads.scene(scene).frame(side, side), PictureCheck.renderer("zbuffer"));
        PictureCheck.verify(image.pixelHash(), expected, strategy);
    }
}
