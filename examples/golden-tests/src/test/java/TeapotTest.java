import static dev.lazyz.testing.GoldenAssertions.assertThat;

import dev.lazyz.scenes.formats.Scenes;
import org.junit.jupiter.api.Test;

class TeapotTest {
    @Test
    void looksAsBefore() {
        assertThat(Scenes.teapot()).at(512, 512).matches("golden/teapot.png");
    }
}
