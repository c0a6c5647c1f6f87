package dev.lazyz.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.scenes.diff.Measure;
import dev.lazyz.scenes.diff.ModelDifference;
import dev.lazyz.scenes.pictures.PictureParameters;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.world.View;
import java.io.ByteArrayOutputStream;
import java.util.List;
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
    void settingsOfPicturesHaveTypes() {
        PictureSettings settings = new PictureSettings(64, 48)
                .with(PictureParameters.LIGHT_INTENSITY, 2.0)
                .with(PictureParameters.VIEW, View.ISO);
        assertEquals(2.0, settings.get(PictureParameters.LIGHT_INTENSITY));
        assertNull(settings.without(PictureParameters.VIEW).get(PictureParameters.VIEW));
    }

    @Test
    void modelsAreComparedWithTheUsualSettings() throws InterruptedException {
        LoadedScene teapot = new LoadedScene(Scenes.teapot(1), List.of());
        ModelDifference difference = ModelDifference.between(teapot, teapot, new PictureSettings(8, 6));
        assertTrue(difference.isEqual());
        assertEquals(48, difference.count(ModelDifference.Change.SAME));
        assertEquals(0.0, difference.getWhole().difference(Measure.AREA));
    }

    @Test
    void drawingsAreWrittenToStreams() throws Exception {
        PictureSettings settings = new PictureSettings(64, 48).with(PictureParameters.EDGES, true);
        ByteArrayOutputStream output = new ByteArrayOutputStream();
        LoadedScene teapot = new LoadedScene(Scenes.teapot(), List.of());
        assertNull(settings.drawing(teapot).writeSvg(output));
        assertTrue(output.toString().endsWith("</svg>\n"));
    }

    @Test
    void optionsOfLoadingAreChangedOneByOne() {
        LoadOptions options = new LoadOptions().withAnimationTime(2).withoutSmoothNormals();
        assertEquals(2.0, options.getAnimationTime());
    }
}
