package example;

import static dev.lazyz.testing.GoldenAssertions.assertThat;

import dev.lazyz.filter.SuperSampling;
import dev.lazyz.strategies.scanline.ScanlineRenderer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How a snowman looks. */
class SnowmanTest {
    @Test
    void portrait() {
        assertThat(Snowman.withButtons(3))
                .at(240, 320)
                .withAntiAliasing(new SuperSampling(4))
                .matches("golden/snowman.png");
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2})
    void buttons(int buttons) {
        assertThat(Snowman.withButtons(buttons)).at(90, 120).matches("golden/snowman-" + buttons + ".png");
    }

    /** An image that was rendered elsewhere, here with another strategy: the bits are the same. */
    @Test
    void image() throws InterruptedException {
        var image = new ScanlineRenderer().render(Snowman.withButtons(2).frame(90, 120));
        assertThat(image).matches("golden/snowman-2.png");
    }
}
