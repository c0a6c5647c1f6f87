package dev.lazyz.jmh.workload;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.spi.Fragment;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RoundsShaderTest {
    @Test
    void roundingDoesNotGrow() {
        SplittableRandom random = new SplittableRandom(1);
        Fragment fragment = new Fragment();
        for (int i = 0; i < 10_000; i++) {
            fragment.moveTo(0, 0);
            fragment.vertexRed = (float) random.nextDouble();
            fragment.vertexGreen = (float) random.nextDouble();
            fragment.vertexBlue = (float) random.nextDouble();
            new RoundsShader().shade(fragment);
            double[] exact = exact(fragment.vertexRed, fragment.vertexGreen, fragment.vertexBlue);
            assertEquals(exact[0], fragment.getRed(), 1e-6);
            assertEquals(exact[1], fragment.getGreen(), 1e-6);
            assertTrue(fragment.getRed() > 0 && fragment.getRed() < 1, "nothing to clamp: " + fragment);
            assertTrue(fragment.getGreen() > 0 && fragment.getGreen() < 1, "nothing to clamp: " + fragment);
        }
    }

    private static double[] exact(double red, double green, double blue) {
        double x = red;
        double y = green;
        for (int round = 0; round < RoundsShader.ROUNDS; round++) {
            double s = 0.5 * x + 0.3 * y - 0.4 * blue;
            double t = 0.4 * y - 0.5 * x + 0.3 * blue;
            x = red / 2 + wave(s) / 2;
            y = green / 2 + wave(t) / 2;
        }
        return new double[] {0.25 + 0.75 * x, 0.25 + 0.75 * y};
    }

    private static double wave(double t) {
        double q = t * t;
        return t * (1 - q * (1 / 6.0 - q * (1 / 120.0 - q / 5040)));
    }
}
