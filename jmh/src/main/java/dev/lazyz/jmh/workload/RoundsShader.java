package dev.lazyz.jmh.workload;

import dev.lazyz.BatchShader;
import dev.lazyz.FragmentBatch;

/**
 * A dear shader: rounds of a polynomial in a sample's interpolated colour.
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

    /** Colours of samples with the given interpolated colours; blue stays as it is. Rounds outside, samples inside. */
    @Override
    public void shade(FragmentBatch batch) {
        int size = batch.getSize();
        float[] x = batch.red;
        float[] y = batch.green;
        System.arraycopy(batch.vertexRed, 0, x, 0, size);
        System.arraycopy(batch.vertexGreen, 0, y, 0, size);
        for (int round = 0; round < rounds; round++) {
            round(size, x, y, batch.vertexRed, batch.vertexGreen, batch.vertexBlue);
        }
        for (int i = 0; i < size; i++) {
            x[i] = 0.25f + 0.75f * x[i];
            y[i] = 0.25f + 0.75f * y[i];
        }
        System.arraycopy(batch.vertexBlue, 0, batch.blue, 0, size);
    }

    private static void round(int size, float[] x, float[] y, float[] red, float[] green, float[] blue) {
        for (int i = 0; i < size; i++) {
            float s = 0.5f * x[i] + 0.3f * y[i] - 0.4f * blue[i];
            float t = 0.4f * y[i] - 0.5f * x[i] + 0.3f * blue[i];
            x[i] = 0.5f * red[i] + 0.5f * wave(s);
            y[i] = 0.5f * green[i] + 0.5f * wave(t);
        }
    }

    private static float wave(float t) {
        float q = t * t;
        return t * (1f - q * (0.16666667f - q * (0.008333333f - q * 0.0001984127f)));
    }
}
