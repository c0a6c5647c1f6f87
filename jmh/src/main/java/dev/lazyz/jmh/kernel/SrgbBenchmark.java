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

/** Ways to convert a linear component to an 8-bit sRGB code, exactly. Measures 4096 conversions. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@State(Scope.Benchmark)
public class SrgbBenchmark {
    private static final int COUNT = 4096;

    /** Below this value the code is 0. */
    private static final float LEAST = 1f / 8192f;

    private static final int LEAST_BITS = Float.floatToRawIntBits(LEAST);
    private static final int BUCKET_SHIFT = 23 - 8;
    private static final int CODE_SHIFT = BUCKET_SHIFT + 1;

    /** The input: random values, or values that are each close to the previous one. */
    @Param({"random", "smooth"})
    public String values;

    private final float[] linear = new float[COUNT];
    private final float[] thresholds = new float[257];
    private final int[] buckets = new int[13 << 8];
    private final int[] summands = new int[buckets.length];

    /** Creates values and tables, and fails if variants differ. */
    @Setup
    public void setUp() {
        for (int code = 1; code < 256; code++) {
            thresholds[code] = threshold(code);
        }
        thresholds[0] = Float.NEGATIVE_INFINITY;
        thresholds[256] = Float.POSITIVE_INFINITY;
        for (int bucket = 0, code = 0; bucket < buckets.length; bucket++) {
            int least = LEAST_BITS + (bucket << BUCKET_SHIFT);
            while (Float.intBitsToFloat(least) >= thresholds[code + 1]) {
                code++;
            }
            int next = Math.min(Float.floatToRawIntBits(thresholds[code + 1]) - least, 1 << BUCKET_SHIFT);
            buckets[bucket] = code << CODE_SHIFT | next;
            summands[bucket] = (code << BUCKET_SHIFT) + (1 << BUCKET_SHIFT) - next - least;
        }
        Random random = new Random(4);
        for (int i = 0; i < COUNT; i++) {
            float smooth = (float) i / COUNT + 0.001f * random.nextFloat();
            linear[i] = values.equals("random") ? random.nextFloat() : smooth;
        }
        Agreement.of(formula(), search(), searchFromTheLast(), buckets(), carry());
    }

    /** The standard's formula, rounded. */
    @Benchmark
    public long formula() {
        long hash = 0;
        for (float value : linear) {
            double encoded = value <= 0.0031308 ? 12.92 * value : 1.055 * StrictMath.pow(value, 1 / 2.4) - 0.055;
            hash = 31 * hash + (int) (255 * Math.min(encoded, 1) + 0.5);
        }
        return hash;
    }

    /** Binary search, in eight steps, in the table of the values at which the code changes. */
    @Benchmark
    public long search() {
        long hash = 0;
        for (float value : linear) {
            int code = 0;
            for (int step = 128; step > 0; step >>= 1) {
                if (value >= thresholds[code + step]) {
                    code += step;
                }
            }
            hash = 31 * hash + code;
        }
        return hash;
    }

    /** Linear search in the same table, starting from the previous code. */
    @Benchmark
    public long searchFromTheLast() {
        long hash = 0;
        int code = 0;
        for (float value : linear) {
            while (value >= thresholds[code + 1]) {
                code++;
            }
            while (value < thresholds[code]) {
                code--;
            }
            hash = 31 * hash + code;
        }
        return hash;
    }

    /** Looks up the upper bits of the float in a table, and compares the lower bits once. */
    @Benchmark
    public long buckets() {
        long hash = 0;
        for (float value : linear) {
            hash = 31 * hash + code(value);
        }
        return hash;
    }

    /**
     * Looks up a number to add to the float's bits, so that the carry is the comparison. The library uses this
     * variant.
     */
    @Benchmark
    public long carry() {
        long hash = 0;
        for (float value : linear) {
            hash = 31 * hash + carriedCode(value);
        }
        return hash;
    }

    private int carriedCode(float value) {
        if (!(value >= LEAST)) {
            return 0;
        }
        if (value >= 1f) {
            return 255;
        }
        int bits = Float.floatToRawIntBits(value);
        return summands[bits - LEAST_BITS >>> BUCKET_SHIFT] + bits >>> BUCKET_SHIFT;
    }

    private int code(float value) {
        if (!(value >= LEAST)) {
            return 0;
        }
        if (value >= 1f) {
            return 255;
        }
        int bits = Float.floatToRawIntBits(value) - LEAST_BITS;
        int bucket = buckets[bits >>> BUCKET_SHIFT];
        int place = bits & (1 << BUCKET_SHIFT) - 1;
        return (bucket >>> CODE_SHIFT) + ((bucket & (1 << CODE_SHIFT) - 1) - 1 - place >>> Integer.SIZE - 1);
    }

    private static float threshold(int code) {
        double encoded = (code - 0.5) / 255;
        double exact = encoded <= 0.04045 ? encoded / 12.92 : StrictMath.pow((encoded + 0.055) / 1.055, 2.4);
        float nearest = (float) exact;
        return nearest < exact ? Math.nextUp(nearest) : nearest;
    }
}
