package dev.lazyz.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;

import org.junit.jupiter.api.Test;

/** Options take numbers as Java writes them: this class does not compile if one takes an object of a number. */
class JavaOptionsTest {
    @Test
    void limitsAreLiterals() {
        LoadLimits limits = new LoadLimits()
                .withDecodedBytes(64_000_000)
                .withTriangles(64_000_000)
                .withMemory(1000)
                .withSpoolBytes(2000);
        assertEquals(64_000_000, limits.getDecodedBytes());
        assertEquals(1000, limits.getMemory());
        assertEquals(2000, limits.getSpoolBytes());
        LoadLimits usual = limits.withDefaultDecodedBytes().withDefaultMemory().withoutSpoolLimit();
        assertNull(usual.getDecodedBytes());
        assertNull(usual.getMemory());
        assertNull(usual.getSpoolBytes());
    }

    @Test
    void intensityOfLightIsALiteral() {
        PictureSettings settings = new PictureSettings(64, 48).withLightIntensity(2);
        assertEquals(2f, settings.getLightIntensity());
        assertNull(settings.withDefaultLightIntensity().getLightIntensity());
    }

    @Test
    void optionsOfLoadingAreChangedOneByOne() {
        LoadOptions options = new LoadOptions().withAnimationTime(2).withoutSmoothNormals();
        assertEquals(2.0, options.getAnimationTime());
    }
}
