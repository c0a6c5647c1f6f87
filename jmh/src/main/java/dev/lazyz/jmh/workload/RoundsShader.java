package dev.lazyz.jmh.workload;

import dev.lazyz.BatchShader;
import dev.lazyz.FragmentBatch;

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
 * <p>s is nowhere steeper than 1 in the range of t, so a round brings two neighbouring points at least 1/0.45 times closer:
 * rounding errors die out, and pictures of programs that round otherwise can be compared. {@code peers/llvmpipe.c} has
 * the same formula.
 */
public final class RoundsShader implements BatchShader {
    /** Rounds a sample where nothing else is said. */
    public static final int ROUNDS = 64;

    private final int rounds;

    /** A shader of {@value #ROUNDS} rounds. */
    public RoundsShader() {
        this(ROUNDS);
    }

    /** A shader of the given number of rounds. */
    public RoundsShader(int rounds) {
        this.rounds = rounds;
    }

    /**
     * Colours of samples with the given interpolated colours; blue stays as it is. Rounds outside, samples inside, in loops
     * that are short: the compiler of JDK 17 gives up vectorising one that does all of a round.
     */
    @Override
    public void shade(FragmentBatch batch) {
        int size = batch.getSize();
        float[] x = batch.red;
        float[] y = batch.green;
        System.arraycopy(batch.vertexRed, 0, x, 0, size);
        System.arraycopy(batch.vertexGreen, 0, y, 0, size);
        for (int round = 0; round < rounds; round++) {
            turn(size, x, y, batch.vertexBlue);
            bend(size, x, batch.vertexRed);
            bend(size, y, batch.vertexGreen);
        }
        for (int i = 0; i < size; i++) {
            x[i] = 0.25f + 0.75f * x[i];
            y[i] = 0.25f + 0.75f * y[i];
        }
        System.arraycopy(batch.vertexBlue, 0, batch.blue, 0, size);
    }

    /** The linear part of a round: what is put through s. */
    private static void turn(int size, float[] x, float[] y, float[] blue) {
        for (int i = 0; i < size; i++) {
            float s = 0.5f * x[i] + 0.3f * y[i] - 0.4f * blue[i];
            y[i] = 0.4f * y[i] - 0.5f * x[i] + 0.3f * blue[i];
            x[i] = s;
        }
    }

    /** The other part of a round, for one of x and y: s, and the mean with what it began as. */
    private static void bend(int size, float[] values, float[] first) {
        for (int i = 0; i < size; i++) {
            values[i] = 0.5f * first[i] + 0.5f * wave(values[i]);
        }
    }

    private static float wave(float t) {
        float q = t * t;
        return t * (1f - q * (0.16666667f - q * (0.008333333f - q * 0.0001984127f)));
    }
}
