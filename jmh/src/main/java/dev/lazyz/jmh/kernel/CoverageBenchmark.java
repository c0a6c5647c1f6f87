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
 * Compares ways to find the samples that a triangle covers, and to draw them: one frame of a tile, triangles in
 * random order. Only the rejecting variants store the farthest key of a block, and skip the block if a triangle lies
 * behind it.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@State(Scope.Benchmark)
public class CoverageBenchmark {
    /** Total number of samples of all triangles. */
    private static final int WORK = 1 << 18;

    /** Average samples per triangle. */
    @Param({"10", "200", "2000"})
    public int area;

    private final long[] keys = new long[TileTriangles.SIZE];
    private final long[] farthest = new long[TileTriangles.SIZE / 16];
    private final long[] quotient = new long[3];
    private final long[] rest = new long[3];
    private TileTriangles triangles;

    /** Creates the triangles, and fails if variants differ. */
    @Setup
    public void setUp() {
        triangles = new TileTriangles(WORK / area, area, 1);
        Agreement.of(
                Arrays.hashCode(box()),
                Arrays.hashCode(spans()),
                Arrays.hashCode(blocks4()),
                Arrays.hashCode(blocks8()),
                Arrays.hashCode(blocks16()),
                Arrays.hashCode(rejecting4()),
                Arrays.hashCode(rejecting8()),
                Arrays.hashCode(rejecting16()));
    }

    /** Tests every sample of the triangle's bounding box. */
    @Benchmark
    public long[] box() {
        Arrays.fill(keys, Long.MAX_VALUE);
        TileTriangles t = triangles;
        for (int i = 0; i < t.count; i++) {
            part(i, t.minX[i], t.minY[i], t.maxX[i], t.maxY[i]);
        }
        return keys;
    }

    /** Follows the edges row by row, and fills the span between them. */
    @Benchmark
    public long[] spans() {
        Arrays.fill(keys, Long.MAX_VALUE);
        TileTriangles t = triangles;
        for (int i = 0; i < t.count; i++) {
            for (int k = 0; k < 3; k++) {
                long slope = Math.max(1, Math.abs(t.edgeDx[3 * i + k]));
                long first = t.edge[3 * i + k] + t.edgeDy[3 * i + k] * t.minY[i];
                quotient[k] = Math.floorDiv(first, slope);
                rest[k] = Math.floorMod(first, slope);
            }
            for (int y = t.minY[i]; y <= t.maxY[i]; y++) {
                // An edge that rises to the right bounds the span on the left
                long left = t.minX[i];
                long right = t.maxX[i];
                for (int k = 0; k < 3; k++) {
                    long slope = t.edgeDx[3 * i + k];
                    if (slope > 0) {
                        left = Math.max(left, -quotient[k]);
                    } else if (slope < 0) {
                        right = Math.min(right, quotient[k]);
                    } else if (quotient[k] < 0) {
                        right = -1;
                    }
                }
                if (left <= right) {
                    span(i, y, (int) left, (int) right);
                }
                for (int k = 0; k < 3; k++) {
                    step(k, Math.max(1, Math.abs(t.edgeDx[3 * i + k])), t.edgeDy[3 * i + k]);
                }
            }
        }
        return keys;
    }

    /** Tests corners of blocks of 4 x 4 samples, and tests samples only in blocks that are partly covered. */
    @Benchmark
    public long[] blocks4() {
        return blocks(4, false);
    }

    /** The same with blocks of 8 x 8. */
    @Benchmark
    public long[] blocks8() {
        return blocks(8, false);
    }

    /** The same with blocks of 16 x 16. */
    @Benchmark
    public long[] blocks16() {
        return blocks(16, false);
    }

    /** Blocks of 4 x 4, with hidden blocks rejected. */
    @Benchmark
    public long[] rejecting4() {
        return blocks(4, true);
    }

    /** The same with blocks of 8 x 8. */
    @Benchmark
    public long[] rejecting8() {
        return blocks(8, true);
    }

    /** The same with blocks of 16 x 16. */
    @Benchmark
    public long[] rejecting16() {
        return blocks(16, true);
    }

    private void step(int k, long slope, long change) {
        quotient[k] += Math.floorDiv(change, slope);
        rest[k] += Math.floorMod(change, slope);
        if (rest[k] >= slope) {
            rest[k] -= slope;
            quotient[k]++;
        }
    }

    private long[] blocks(int size, boolean rejects) {
        Arrays.fill(keys, Long.MAX_VALUE);
        Arrays.fill(farthest, Long.MAX_VALUE);
        TileTriangles t = triangles;
        for (int i = 0; i < t.count; i++) {
            for (int y = t.minY[i] & -size; y <= t.maxY[i]; y += size) {
                for (int x = t.minX[i] & -size; x <= t.maxX[i]; x += size) {
                    int block = (y * TileTriangles.SIDE / size + x) / size;
                    if (!rejects) {
                        block(i, x, y, size);
                    } else if (TileTriangles.key(t.nearest(i, x, y, x + size - 1, y + size - 1), i) < farthest[block]) {
                        block(i, x, y, size);
                        farthest[block] = farthest(x, y, size);
                    }
                }
            }
        }
        return keys;
    }

    private long farthest(int x, int y, int size) {
        long most = Long.MIN_VALUE;
        for (int row = y; row < y + size; row++) {
            for (int at = row * TileTriangles.SIDE + x; at < row * TileTriangles.SIDE + x + size; at++) {
                most = Math.max(most, keys[at]);
            }
        }
        return most;
    }

    private void block(int i, int x, int y, int size) {
        TileTriangles t = triangles;
        boolean isWhole = true;
        for (int k = 3 * i; k < 3 * i + 3; k++) {
            long dx = t.edgeDx[k] * (size - 1);
            long dy = t.edgeDy[k] * (size - 1);
            long first = t.edge[k] + t.edgeDx[k] * x + t.edgeDy[k] * y;
            if (first + Math.max(dx, 0) + Math.max(dy, 0) < 0) {
                return;
            }
            isWhole &= first + Math.min(dx, 0) + Math.min(dy, 0) >= 0;
        }
        if (isWhole) {
            for (int row = y; row < y + size; row++) {
                span(i, row, x, x + size - 1);
            }
        } else {
            part(
                    i,
                    Math.max(x, t.minX[i]),
                    Math.max(y, t.minY[i]),
                    Math.min(x + size - 1, t.maxX[i]),
                    Math.min(y + size - 1, t.maxY[i]));
        }
    }

    /** Draws the covered samples of a rectangle, testing each sample. */
    private void part(int i, int fromX, int fromY, int toX, int toY) {
        TileTriangles t = triangles;
        for (int y = fromY; y <= toY; y++) {
            long e0 = t.edge[3 * i] + t.edgeDx[3 * i] * fromX + t.edgeDy[3 * i] * y;
            long e1 = t.edge[3 * i + 1] + t.edgeDx[3 * i + 1] * fromX + t.edgeDy[3 * i + 1] * y;
            long e2 = t.edge[3 * i + 2] + t.edgeDx[3 * i + 2] * fromX + t.edgeDy[3 * i + 2] * y;
            long depth = t.z[i] + t.zdx[i] * fromX + t.zdy[i] * y;
            for (int x = fromX; x <= toX; x++) {
                if ((e0 | e1 | e2) >= 0) {
                    int at = y * TileTriangles.SIDE + x;
                    keys[at] = Math.min(keys[at], TileTriangles.key(depth, i));
                }
                e0 += t.edgeDx[3 * i];
                e1 += t.edgeDx[3 * i + 1];
                e2 += t.edgeDx[3 * i + 2];
                depth += t.zdx[i];
            }
        }
    }

    /** Draws a span whose samples are all covered. */
    private void span(int i, int y, int left, int right) {
        long step = triangles.zdx[i];
        long depth = triangles.z[i] + step * left + triangles.zdy[i] * y;
        for (int at = y * TileTriangles.SIDE + left; at <= y * TileTriangles.SIDE + right; at++) {
            keys[at] = Math.min(keys[at], TileTriangles.key(depth, i));
            depth += step;
        }
    }
}
