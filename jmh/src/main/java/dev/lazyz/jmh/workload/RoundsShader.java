package dev.lazyz.jmh.workload;

import dev.lazyz.spi.BatchShader;
import dev.lazyz.spi.FragmentBatch;

/**
 * An expensive shader: rounds of a polynomial in a sample's interpolated colour.
 *
 * <p>A round maps (x, y), which begins as (red, green), to
 *
 * <pre>
 * (red / 2 + s(0.5 x + 0.3 y - 0.4 blue) / 2, green / 2 + s(0.4 y - 0.5 x + 0.3 blue) / 2)
 * s(t) = t (1 - t^2 (1/6 - t^2 (1/120 - t^2 / 5040)))
 * </pre>
 *
 * <p>The slope of s is at most 1 in the range of t, so a round brings two neighbouring points at least 1/0.45 times
 * closer: rounding errors vanish, and images of programs with other rounding can be compared.
 * {@code peers/llvmpipe.c} has the same formula.
 */
public final class RoundsShader implements BatchShader {
    /** Default number of rounds per sample. */
    public static final int ROUNDS = 64;

    private final int rounds;

    /** Creates a shader of {@value #ROUNDS} rounds. */
    public RoundsShader() {
        this(ROUNDS);
    }

    /** Creates a shader of the given number of rounds. */
    public RoundsShader(int rounds) {
        this.rounds = rounds;
    }

    /**
     * Computes the colours of samples from their interpolated colours; blue stays unchanged. The outer loop runs over
     * rounds. The inner loops over samples are short, because the compiler of JDK 17 does not vectorise a loop that
     * contains a whole round.
     */
    @Override
    public void shade(FragmentBatch batch) {
        int size = batch.getSize();
        float[] x = batch.red;
        float[] y = batch.green;
        System.arraycopy(batch.vertexRed, 0, x, 0, size);
        System.arraycopy(batch.vertexGreen, 0, y, 0, size);
        for (int round = 0; round < rounds; round++) {
            linearPart(size, x, y, batch.vertexBlue);
            blendWave(size, x, batch.vertexRed);
            blendWave(size, y, batch.vertexGreen);
        }
        for (int i = 0; i < size; i++) {
            x[i] = 0.25f + 0.75f * x[i];
            y[i] = 0.25f + 0.75f * y[i];
        }
        System.arraycopy(batch.vertexBlue, 0, batch.blue, 0, size);
    }

    /** The linear part of a round: computes the arguments of s. */
    private static void linearPart(int size, float[] x, float[] y, float[] blue) {
        for (int i = 0; i < size; i++) {
            float s = 0.5f * x[i] + 0.3f * y[i] - 0.4f * blue[i];
            y[i] = 0.4f * y[i] - 0.5f * x[i] + 0.3f * blue[i];
            x[i] = s;
        }
    }

    /** The other part of a round, for x or y: applies s, and averages the result with the initial value. */
    private static void blendWave(int size, float[] values, float[] first) {
        for (int i = 0; i < size; i++) {
            values[i] = 0.5f * first[i] + 0.5f * wave(values[i]);
        }
    }

    private static float wave(float t) {
        float q = t * t;
        return t * (1f - q * (0.16666667f - q * (0.008333333f - q * 0.0001984127f)));
    }
}
