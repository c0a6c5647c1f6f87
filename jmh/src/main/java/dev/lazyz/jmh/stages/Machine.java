package dev.lazyz.jmh.stages;

import java.util.Arrays;
import java.util.List;
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

    /** Elements of the array of a loop of arithmetic. */
    private static final int SIZE = 2048;

    /** Multiplications and additions of each element in a pass: enough to be slower than load and store. */
    private static final int STEPS = 8;

    /**
     * Time for which each figure is measured, and least time of a measurement, nanoseconds. The best measurement
     * counts; it is short so that some are not interrupted by other programs.
     */
    private static final long WHOLE = 1_000_000_000L;

    private static final long LEAST = 3_000_000L;

    /** Measures this processor. Takes about five seconds. */
    static Machine measure(String jvm) {
        double[] values = new double[SIZE];
        Arrays.fill(values, 1.5);
        return new Machine(
                jvm,
                copy(L2_SIZE),
                copy(L3_SIZE),
                copy(MEMORY_SIZE),
                best(() -> multiplyAdd(values, 0.999, 0.001)),
                best(() -> divide(values, 1.0001)));
    }

    /** Returns the better of each figure of all {@code machines}: what one of them reached is possible. */
    static Machine best(List<Machine> machines) {
        return new Machine(
                "best of all",
                machines.stream().mapToDouble(Machine::l2).max().orElseThrow(),
                machines.stream().mapToDouble(Machine::l3).max().orElseThrow(),
                machines.stream().mapToDouble(Machine::memory).max().orElseThrow(),
                machines.stream().mapToDouble(Machine::operations).max().orElseThrow(),
                machines.stream().mapToDouble(Machine::divisions).max().orElseThrow());
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
            double x = values[i] * factor + summand;
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
        long begin = System.nanoTime();
        long start = begin;
        while (start - begin < WHOLE) {
            long units = 0;
            long time;
            do {
                units += work.getAsLong();
                time = System.nanoTime() - start;
            } while (time < LEAST);
            most = Math.max(most, units / (time / 1e9));
            start = System.nanoTime();
        }
        return most;
    }
}
