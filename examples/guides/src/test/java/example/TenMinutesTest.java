package example;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.Image;
import dev.lazyz.Rgba;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.pictures.Picture;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.swing.ModelView;
import java.awt.event.ComponentEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The steps of the guide do what it says. */
@Timeout(value = 10, unit = TimeUnit.MINUTES)
class TenMinutesTest {
    @TempDir
    Path folder;

    private Path file;
    private LoadedScene model;

    /** Two triangles beside each other, seen from the front. */
    @BeforeEach
    void write() throws IOException {
        file = folder.resolve("car.obj");
        Files.writeString(file, "v -2 -1 0\nv -0.1 -1 0\nv -1 1 0\nv 0.1 -1 0\nv 2 -1 0\nv 1 1 0\n"
                + "o car\ng door\nf 1 2 3\ng wheel\nf 4 5 6\n");
        model = Scenes.load(file);
    }

    @Test
    void aPictureIsWritten() throws IOException, InterruptedException {
        Path picture = folder.resolve("car.png");
        Image image = TenMinutes.firstPicture(file, picture);
        assertEquals(640, Picture.read(picture).getWidth());
        assertTrue(image.getVisible() > 1000);
        assertThrows(IOException.class, () -> TenMinutes.firstPicture(folder.resolve("none.obj"), picture));
    }

    @Test
    void onePartGetsAnotherColour() {
        LoadedScene painted = TenMinutes.painted(model, "wheel", Rgba.BLACK);
        assertEquals(model.getScene().getSurfaces().get(0), painted.getScene().getSurfaces().get(0));
        assertNotEquals(model.getScene().getSurfaces().get(1), painted.getScene().getSurfaces().get(1));
        assertEquals("car/wheel", painted.getScene().getSurfaces().get(1).getName());
    }

    @Test
    void lightsAndStylesGiveDifferentPictures() throws InterruptedException {
        Set<String> hashes = new HashSet<>();
        for (PictureSettings settings : TenMinutes.lights()) {
            hashes.add(settings.frame(model).render(new TiledRenderer()).pixelHash());
        }
        assertEquals(4, hashes.size());
    }

    @Test
    void thumbnailsAreTransparentAroundTheModel() throws IOException, InterruptedException {
        BufferedImage thumbnail = TenMinutes.thumbnail(file);
        assertEquals(128, thumbnail.getWidth());
        assertEquals(0, thumbnail.getRGB(0, 0));
    }

    @Test
    void thePartAtAPixelIsKnown() throws InterruptedException {
        Set<String> found = new HashSet<>();
        for (int x = 40; x < 640; x += 80) found.add(TenMinutes.pick(model, x, 240));
        assertTrue(found.containsAll(Set.of("car/door", "car/wheel")), "" + found);
        assertNull(TenMinutes.pick(model, 0, 0));
    }

    @Test
    void aTurnHasAPictureForEachStep() throws Exception {
        List<BufferedImage> pictures = TenMinutes.turn(model, 5);
        assertEquals(5, pictures.size());
        Thread.currentThread().interrupt();
        assertThrows(InterruptedException.class, () -> TenMinutes.turn(model, 5));
    }

    @Test
    void aClickTellsThePart() throws Exception {
        Set<String> clicked = new HashSet<>();
        ModelView[] view = new ModelView[1];
        BufferedImage shown = new BufferedImage(64, 48, BufferedImage.TYPE_INT_RGB);
        CountDownLatch done = new CountDownLatch(1);
        SwingUtilities.invokeAndWait(() -> {
            view[0] = ModelWindow.view(file, clicked::add);
            view[0].setOnRest(done::countDown);
            view[0].setSize(64, 48);
            view[0].dispatchEvent(new ComponentEvent(view[0], ComponentEvent.COMPONENT_RESIZED));
        });
        done.await();
        SwingUtilities.invokeAndWait(() -> {
            for (int x = 0; x < 64; x++) {
                send(view[0], MouseEvent.MOUSE_PRESSED, x);
                send(view[0], MouseEvent.MOUSE_RELEASED, x);
            }
            view[0].paint(shown.getGraphics());
        });
        assertEquals(Set.of("", "car/door", "car/wheel"), clicked);
        assertNotEquals(-1, shown.getRGB(20, 30), "the model is drawn");
    }

    private static void send(ModelView view, int id, int x) {
        view.dispatchEvent(new MouseEvent(view, id, 0, 0, x, 24, 1, false, MouseEvent.BUTTON1));
    }
}
