package dev.lazyz.jmh.kernel;

import java.util.Arrays;
import java.util.Comparator;
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

/**
 * Ways to store the visible primitive of a sample, measured by drawing spans. The nearest wins, and among equals the
 * first.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@State(Scope.Benchmark)
public class VisibilityKeyBenchmark {
    private static final int COUNT = 4096;
    private static final int SIZE = 1 << 14;
    private static final int LONGEST = 128;

    /** The order of the spans: random, from near to far, or from far to near. */
    @Param({"random", "near", "far"})
    public String order;

    private final int[] start = new int[COUNT];
    private final int[] length = new int[COUNT];
    private final int[] depth = new int[COUNT];
    private final int[] step = new int[COUNT];
    private final long[] keys = new long[SIZE];
    private final int[] depths = new int[SIZE];
    private final int[] owners = new int[SIZE];

    /** Creates the spans, and fails if variants differ. */
    @Setup
    public void setUp() {
        Random random = new Random(1);
        int[] first = random.ints(COUNT, 1 << 28, 1 << 30).toArray();
        if (!order.equals("random")) {
            int sign = order.equals("near") ? 1 : -1;
            first = Arrays.stream(first)
                    .boxed()
                    .sorted(Comparator.comparingInt(value -> sign * value))
                    .mapToInt(value -> value)
                    .toArray();
        }
        for (int i = 0; i < COUNT; i++) {
            length[i] = 1 + random.nextInt(LONGEST);
            start[i] = random.nextInt(SIZE - length[i]);
            depth[i] = first[i];
            step[i] = random.nextInt(1 << 10) - (1 << 9);
        }
        Agreement.of(Arrays.hashCode(oneLong()), Arrays.hashCode(oneLongWithBranch()), hashOfPairs(twoInts()));
    }

    /** Depth in the upper bits, number in the lower bits: one minimum operation, no branch. */
    @Benchmark
    public long[] oneLong() {
        Arrays.fill(keys, Long.MAX_VALUE);
        for (int i = 0; i < COUNT; i++) {
            long key = (long) depth[i] << Integer.SIZE | i;
            long change = (long) step[i] << Integer.SIZE;
            for (int at = start[i]; at < start[i] + length[i]; at++) {
                keys[at] = Math.min(keys[at], key);
                key += change;
            }
        }
        return keys;
    }

    /** The same, but stores only if the key is less. */
    @Benchmark
    public long[] oneLongWithBranch() {
        Arrays.fill(keys, Long.MAX_VALUE);
        for (int i = 0; i < COUNT; i++) {
            long key = (long) depth[i] << Integer.SIZE | i;
            long change = (long) step[i] << Integer.SIZE;
            for (int at = start[i]; at < start[i] + length[i]; at++) {
                if (key < keys[at]) {
                    keys[at] = key;
                }
                key += change;
            }
        }
        return keys;
    }

    /** Depths in one array and numbers in another: half the bytes to compare, but two stores. */
    @Benchmark
    public int[] twoInts() {
        Arrays.fill(depths, Integer.MAX_VALUE);
        Arrays.fill(owners, -1);
        for (int i = 0; i < COUNT; i++) {
            int value = depth[i];
            for (int at = start[i]; at < start[i] + length[i]; at++) {
                if (value < depths[at]) {
                    depths[at] = value;
                    owners[at] = i;
                }
                value += step[i];
            }
        }
        return owners;
    }

    /** Returns the hash that the equivalent keys would have. */
    private long hashOfPairs(int[] owners) {
        int hash = 1;
        for (int at = 0; at < SIZE; at++) {
            hash = 31 * hash + Long.hashCode((long) depths[at] << Integer.SIZE | owners[at] & 0xFFFFFFFFL);
        }
        return hash;
    }
}
