package dev.lazyz.jmh;

import dev.lazyz.Primitive;
import dev.lazyz.Rgba;
import dev.lazyz.spi.Fragment;
import dev.lazyz.spi.ShadingCursor;
import dev.lazyz.world.Scene;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.material.Material.Shading;
import dev.lazyz.world.surface.Mesh;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * The time of one shading call for each way to reach a sample. Used to calibrate {@code Coherence.ADAPTIVE}.
 *
 * <p>Times are per visible sample. The time of a step is the difference between {@code stepped} with two gaps,
 * divided by the difference of the gaps. The time of a start is {@code restarted} minus {@code stepped} with a gap of
 * 1, plus a step.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@State(Scope.Benchmark)
public class ShadingBenchmark {
    private static final int SIDE = 4096;
    private static final int SAMPLES = 64;
    private static final int FIRST = 16;
    private static final int ROW = SIDE / 2;

    /** The shading mode, which determines where light is evaluated. */
    @Param({"GOURAUD", "PHONG"})
    public Shading shading;

    /** Distance between visible samples, columns. */
    @Param({"1", "4", "16", "64"})
    public int gap;

    private final Fragment fragment = new Fragment();
    private Primitive primitive;

    /** Sets up a triangle that covers the raster, and fails if a cursor gives other colours than the primitive. */
    @Setup
    public void setUp() throws InterruptedException {
        float[] positions = {-9f, -9f, 0f, 9f, -9f, 1f, 0f, 9f, -1f};
        float[] normals = {0.3f, 0f, 1f, 0f, 0.4f, 1f, -0.2f, -0.3f, 1f};
        Material material = new Material(new Rgba(0.8f, 0.5f, 0.2f)).withShading(shading);
        Mesh mesh = new Mesh(positions, new int[] {0, 1, 2}, material, normals);
        primitive = Scene.builder()
                .add(mesh)
                .build()
                .frame(SIDE, SIDE)
                .getPrimitives()
                .get(0);
        float expected = direct();
        if (expected != stepped() || expected != restarted()) {
            throw new IllegalStateException("a cursor gives other colours than the primitive");
        }
    }

    /** Evaluates every sample independently. */
    @Benchmark
    @OperationsPerInvocation(SAMPLES)
    public float direct() {
        float sum = 0f;
        for (int i = 0; i < SAMPLES; i++) {
            fragment.moveTo(FIRST + i * gap, ROW);
            primitive.shade(fragment);
            sum += fragment.getRed();
        }
        return sum;
    }

    /** Reaches every sample by steps from the previous one. */
    @Benchmark
    @OperationsPerInvocation(SAMPLES)
    public float stepped() {
        float sum = 0f;
        ShadingCursor cursor = primitive.shadingCursor(FIRST, ROW);
        for (int i = 0; i < SAMPLES; i++) {
            fragment.moveTo(FIRST + i * gap, ROW);
            cursor.shade(fragment);
            sum += fragment.getRed();
            for (int step = 0; step < gap; step++) {
                cursor.step();
            }
        }
        return sum;
    }

    /** Creates a new cursor for every sample. */
    @Benchmark
    @OperationsPerInvocation(SAMPLES)
    public float restarted() {
        float sum = 0f;
        for (int i = 0; i < SAMPLES; i++) {
            fragment.moveTo(FIRST + i * gap, ROW);
            primitive.shadingCursor(FIRST + i * gap, ROW).shade(fragment);
            sum += fragment.getRed();
        }
        return sum;
    }
}
