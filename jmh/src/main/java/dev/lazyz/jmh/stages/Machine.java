package dev.lazyz.jmh.stages;

import java.util.function.LongSupplier;

/**
 * What one processor can do at most, measured by loops that C2 vectorises: copies within each level of memory, and
 * arithmetic within the first cache.
 *
 * @param jvm name of the Java runtime
 * @param l2 bytes read and written per second by a copy within the second cache
 * @param l3 the same within the third cache
 * @param memory the same in memory
 * @param operations multiplications and additions of 64-bit numbers per second
 * @param divisions divisions of 64-bit numbers per second
 */
record Machine(String jvm, double l2, double l3, double memory, double operations, double divisions) {
    /** Bytes of the two arrays of a copy that is within the second cache. */
    static final long L2_SIZE = 256L << 10;

    /** The same for the third cache. A larger set of data counts as being in memory. */
    static final long L3_SIZE = 16L << 20;

    /** The same for memory. */
    static final long MEMORY_SIZE = 512L << 20;

    private static final int SIZE = 1024;

    /** Multiplications and additions of each element in a pass. */
    private static final int STEPS = 16;

    /** Number of measurements, of which the best is taken, and the least time of each, nanoseconds. */
    private static final int REPEATS = 12;

    private static final long LEAST = 60_000_000L;

    /** Measures this processor. Takes about five seconds. */
    static Machine measure(String jvm) {
        double[] values = new double[SIZE];
        java.util.Arrays.fill(values, 1.5);
        return new Machine(
                jvm,
                copy(L2_SIZE),
                copy(L3_SIZE),
                copy(MEMORY_SIZE),
                best(() -> multiplyAdd(values, 0.999, 0.001)),
                best(() -> divide(values, 1.0001)));
    }

    /** Returns the bandwidth for a set of data of {@code size} bytes, bytes per second. */
    double bandwidth(long size) {
        return size <= L2_SIZE ? l2 : size <= L3_SIZE ? l3 : memory;
    }

    private static double copy(long size) {
        long[] from = new long[(int) (size / 2 / Long.BYTES)];
        long[] to = new long[from.length];
        return best(() -> {
            System.arraycopy(from, 0, to, 0, from.length);
            return 2L * Long.BYTES * from.length;
        });
    }

    private static long multiplyAdd(double[] values, double factor, double summand) {
        for (int i = 0; i < values.length; i++) {
            double x = values[i];
            x = x * factor + summand;
            x = x * factor + summand;
            x = x * factor + summand;
            x = x * factor + summand;
            x = x * factor + summand;
            x = x * factor + summand;
            x = x * factor + summand;
            values[i] = x * factor + summand;
        }
        return (long) STEPS * values.length;
    }

    private static long divide(double[] values, double divisor) {
        for (int i = 0; i < values.length; i++) {
            values[i] = divisor / values[i];
        }
        return values.length;
    }

    /** Returns the greatest number of units per second; {@code work} returns the number of units that it did. */
    private static double best(LongSupplier work) {
        double most = 0;
        for (int repeat = 0; repeat < REPEATS; repeat++) {
            long units = 0;
            long start = System.nanoTime();
            long time;
            do {
                units += work.getAsLong();
                time = System.nanoTime() - start;
            } while (time < LEAST);
            most = Math.max(most, units / (time / 1e9));
        }
        return most;
    }
}
