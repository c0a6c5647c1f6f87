package dev.lazyz.swing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.pictures.PictureParameters;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.world.camera.FittedViewpoint.View;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Test;

/** The same from Java. */
class JavaTest {
    @Test
    void aSceneIsShownFromASide() throws Exception {
        CountDownLatch done = new CountDownLatch(1);
        ModelView[] view = new ModelView[1];
        SwingUtilities.invokeAndWait(() -> {
            view[0] = new ModelView(Scenes.teapot(1));
            view[0].setSettings(new PictureSettings().with(PictureParameters.EDGES, true));
            view[0].setOnPick(point -> {});
            view[0].setOnRest(done::countDown);
            view[0].setSize(40, 30);
            view[0].showWhole(View.TOP);
        });
        done.await(10, TimeUnit.MINUTES);
        SwingUtilities.invokeAndWait(() -> assertEquals(40, view[0].getPicture().getWidth()));
    }
}
