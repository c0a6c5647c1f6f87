package dev.lazyz.testing;

import static dev.lazyz.testing.GoldenAssertions.assertThat;

import dev.lazyz.RenderOptions;
import dev.lazyz.filter.SuperSampling;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.strategies.tiled.TiledRenderer;
import org.junit.jupiter.api.Test;

/** The same from Java. */
class JavaTest {
    @Test
    void scene() {
        assertThat(Scenes.teapot())
                .at(120, 90)
                .withAntiAliasing(new SuperSampling(2))
                .withRenderer(new TiledRenderer())
                .withOptions(new RenderOptions().withThreads(2))
                .withThreshold(0)
                .matches("golden/teapot.png");
    }

    @Test
    void image() throws InterruptedException {
        var image = new TiledRenderer().render(Scenes.city(2).frame(96, 72));
        assertThat(image).matches("golden/city.png");
        assertThat(Images.toPng(image)).withThreshold(0.5).matches("golden/city.png");
    }
}
