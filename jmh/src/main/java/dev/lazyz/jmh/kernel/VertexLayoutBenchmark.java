package dev.lazyz.jmh.kernel;

import java.util.Random;
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

/** Memory layouts of vertices: computes the area and the bounding box of every triangle of a mesh of a million. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@State(Scope.Benchmark)
public class VertexLayoutBenchmark {
    private static final int SIDE = 708;
    private static final int VERTICES = SIDE * SIDE;
    private static final int STRIDE = 4;

    /** The order of the mesh's triangles: each next to the previous one, or random. */
    @Param({"strips", "random"})
    public String order;

    private final Vertex[] objects = new Vertex[VERTICES];
    private final int[] x = new int[VERTICES];
    private final int[] y = new int[VERTICES];
    private final int[] z = new int[VERTICES];
    private final int[] interleaved = new int[STRIDE * VERTICES];
    private int[] indices;

    /** Creates the mesh, and fails if variants differ. */
    @Setup
    public void setUp() {
        Random random = new Random(3);
        for (int i = 0; i < VERTICES; i++) {
            x[i] = i % SIDE * 64 + random.nextInt(64);
            y[i] = i / SIDE * 64 + random.nextInt(64);
            z[i] = random.nextInt(1 << 20);
            objects[i] = new Vertex(x[i], y[i], z[i]);
            interleaved[STRIDE * i] = x[i];
            interleaved[STRIDE * i + 1] = y[i];
            interleaved[STRIDE * i + 2] = z[i];
        }
        indices = indices();
        if (order.equals("random")) {
            shuffle(random);
        }
        Agreement.of(objects(), structureOfArrays(), interleaved());
    }

    /** One object per vertex. */
    @Benchmark
    public long objects() {
        long sum = 0;
        for (int i = 0; i < indices.length; i += 3) {
            Vertex a = objects[indices[i]];
            Vertex b = objects[indices[i + 1]];
            Vertex c = objects[indices[i + 2]];
            sum += measure(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z);
        }
        return sum;
    }

    /** One array per coordinate. */
    @Benchmark
    public long structureOfArrays() {
        long sum = 0;
        for (int i = 0; i < indices.length; i += 3) {
            int a = indices[i];
            int b = indices[i + 1];
            int c = indices[i + 2];
            sum += measure(x[a], y[a], z[a], x[b], y[b], z[b], x[c], y[c], z[c]);
        }
        return sum;
    }

    /** One array, with the coordinates of a vertex next to each other. */
    @Benchmark
    public long interleaved() {
        long sum = 0;
        int[] v = interleaved;
        for (int i = 0; i < indices.length; i += 3) {
            int a = STRIDE * indices[i];
            int b = STRIDE * indices[i + 1];
            int c = STRIDE * indices[i + 2];
            sum += measure(v[a], v[a + 1], v[a + 2], v[b], v[b + 1], v[b + 2], v[c], v[c + 1], v[c + 2]);
        }
        return sum;
    }

    private static long measure(int ax, int ay, int az, int bx, int by, int bz, int cx, int cy, int cz) {
        long area = (long) (bx - ax) * (cy - ay) - (long) (by - ay) * (cx - ax);
        int width = Math.max(ax, Math.max(bx, cx)) - Math.min(ax, Math.min(bx, cx));
        int height = Math.max(ay, Math.max(by, cy)) - Math.min(ay, Math.min(by, cy));
        return area + width + height + Math.min(az, Math.min(bz, cz));
    }

    private static int[] indices() {
        int[] indices = new int[6 * (SIDE - 1) * (SIDE - 1)];
        int at = 0;
        for (int row = 0; row < SIDE - 1; row++) {
            for (int column = 0; column < SIDE - 1; column++) {
                int first = row * SIDE + column;
                for (int corner : new int[] {0, 1, SIDE, SIDE, 1, SIDE + 1}) {
                    indices[at++] = first + corner;
                }
            }
        }
        return indices;
    }

    private void shuffle(Random random) {
        for (int i = indices.length / 3 - 1; i > 0; i--) {
            int j = random.nextInt(i + 1);
            for (int k = 0; k < 3; k++) {
                int index = indices[3 * i + k];
                indices[3 * i + k] = indices[3 * j + k];
                indices[3 * j + k] = index;
            }
        }
    }

    private record Vertex(int x, int y, int z) {}
}
