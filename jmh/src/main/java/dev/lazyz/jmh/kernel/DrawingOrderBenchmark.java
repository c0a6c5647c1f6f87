package dev.lazyz.jmh.kernel;

import java.util.Arrays;
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

/**
 * Whether to sort before drawing if blocks of 8 x 8 samples reject what lies behind them. The time includes sorting.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@State(Scope.Benchmark)
public class DrawingOrderBenchmark {
    private static final int AREA = 200;
    private static final int BLOCK = 8;
    private static final int COLUMNS = TileTriangles.SIDE / BLOCK;
    private static final int PLACES = 256;

    /** Fragments per sample. */
    @Param({"4", "32", "256"})
    public int depth;

    private final long[] keys = new long[TileTriangles.SIZE];
    private final long[] farthest = new long[COLUMNS * COLUMNS];
    private final int[] ends = new int[PLACES + 1];
    private TileTriangles triangles;
    private long[] nearest;
    private long[] sorted;
    private int[] order;

    /** Creates the triangles, and fails if variants differ. */
    @Setup
    public void setUp() {
        int count = depth * TileTriangles.SIZE / AREA;
        triangles = new TileTriangles(count, AREA, 2);
        nearest = new long[count];
        for (int i = 0; i < count; i++) {
            nearest[i] =
                    triangles.nearest(i, triangles.minX[i], triangles.minY[i], triangles.maxX[i], triangles.maxY[i]);
        }
        sorted = new long[count];
        order = new int[count];
        Agreement.of(Arrays.hashCode(asSubmitted()), Arrays.hashCode(sorted()), Arrays.hashCode(roughlySorted()));
    }

    /** Draws in the order of submission. */
    @Benchmark
    public long[] asSubmitted() {
        clear();
        for (int i = 0; i < triangles.count; i++) {
            draw(i);
        }
        return keys;
    }

    /** Draws from near to far, sorted by the nearest depth. */
    @Benchmark
    public long[] sorted() {
        clear();
        for (int i = 0; i < triangles.count; i++) {
            sorted[i] = TileTriangles.key(nearest[i], i);
        }
        Arrays.sort(sorted);
        for (long key : sorted) {
            draw((int) key);
        }
        return keys;
    }

    /** Draws from near to far by eight bits of the nearest depth, with a counting sort. */
    @Benchmark
    public long[] roughlySorted() {
        clear();
        long least = Long.MAX_VALUE;
        long most = Long.MIN_VALUE;
        for (long value : nearest) {
            least = Math.min(least, value);
            most = Math.max(most, value);
        }
        int shift = Math.max(0, Long.SIZE - Long.numberOfLeadingZeros(most - least) - 8);
        Arrays.fill(ends, 0);
        for (long value : nearest) {
            ends[(int) (value - least >> shift) + 1]++;
        }
        for (int place = 0; place < PLACES; place++) {
            ends[place + 1] += ends[place];
        }
        for (int i = 0; i < triangles.count; i++) {
            order[ends[(int) (nearest[i] - least >> shift)]++] = i;
        }
        for (int i : order) {
            draw(i);
        }
        return keys;
    }

    private void clear() {
        Arrays.fill(keys, Long.MAX_VALUE);
        Arrays.fill(farthest, Long.MAX_VALUE);
    }

    private void draw(int i) {
        TileTriangles t = triangles;
        for (int y = t.minY[i] & -BLOCK; y <= t.maxY[i]; y += BLOCK) {
            for (int x = t.minX[i] & -BLOCK; x <= t.maxX[i]; x += BLOCK) {
                int block = y / BLOCK * COLUMNS + x / BLOCK;
                long best = t.nearest(i, x, y, x + BLOCK - 1, y + BLOCK - 1);
                if (TileTriangles.key(best, i) < farthest[block]) {
                    farthest[block] = draw(i, x, y);
                }
            }
        }
    }

    /** Draws a block, and returns the greatest remaining key in it. */
    private long draw(int i, int fromX, int fromY) {
        TileTriangles t = triangles;
        long most = Long.MIN_VALUE;
        for (int y = fromY; y < fromY + BLOCK; y++) {
            long e0 = t.edge[3 * i] + t.edgeDx[3 * i] * fromX + t.edgeDy[3 * i] * y;
            long e1 = t.edge[3 * i + 1] + t.edgeDx[3 * i + 1] * fromX + t.edgeDy[3 * i + 1] * y;
            long e2 = t.edge[3 * i + 2] + t.edgeDx[3 * i + 2] * fromX + t.edgeDy[3 * i + 2] * y;
            long depth = t.z[i] + t.zdx[i] * fromX + t.zdy[i] * y;
            for (int at = y * TileTriangles.SIDE + fromX; at < y * TileTriangles.SIDE + fromX + BLOCK; at++) {
                long key = (e0 | e1 | e2) >= 0 ? TileTriangles.key(depth, i) : Long.MAX_VALUE;
                long left = Math.min(keys[at], key);
                keys[at] = left;
                most = Math.max(most, left);
                e0 += t.edgeDx[3 * i];
                e1 += t.edgeDx[3 * i + 1];
                e2 += t.edgeDx[3 * i + 2];
                depth += t.zdx[i];
            }
        }
        return most;
    }
}
