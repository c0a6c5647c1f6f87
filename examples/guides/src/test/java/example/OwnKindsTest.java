package example;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.DepthTest;
import dev.lazyz.Frame;
import dev.lazyz.Image;
import dev.lazyz.Raster;
import dev.lazyz.Renderer;
import dev.lazyz.filter.SampledFrame;
import dev.lazyz.filter.SuperSampling;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.strategies.zbuffer.ZBufferRenderer;
import dev.lazyz.world.camera.Camera;
import dev.lazyz.world.Scene;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.surface.Sphere;
import java.util.Arrays;
import java.util.List;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The primitive and the shader of the guides, rendered by all strategies: one picture each. */
class OwnKindsTest {
    private static Image onePicture(Frame frame) throws InterruptedException {
        Image first = Renderers.getBuiltIn().get(0).render(frame);
        for (Renderer renderer : Renderers.getBuiltIn()) {
            assertEquals(first.pixelHash(), renderer.render(frame).pixelHash(), renderer.getId());
        }
        return first;
    }

    @Test
    void discsHideEachOther() throws InterruptedException {
        Raster raster = new Raster(64, 48);
        Frame frame = new Frame(raster, List.of(new Disc(raster, 20, 20, 15, 1000), new Disc(raster, 30, 28, 10, 500)));
        Image image = onePicture(frame);
        for (int y = 0; y < 48; y++) {
            for (int x = 0; x < 64; x++) {
                boolean isInSecond = Math.hypot(x - 30, y - 28) <= 10;
                boolean isInFirst = Math.hypot(x - 20, y - 20) <= 15;
                assertEquals(isInSecond ? 1 : isInFirst ? 0 : DepthTest.BACKGROUND, image.primitive(x, y));
            }
        }
    }

    @Test
    void markersHaveTheirSizeInPixels() throws InterruptedException {
        Markers markers = new Markers(List.of(new Vector3d(-1, 0, 0), new Vector3d(1, 0, -3)), 5);
        Camera camera = Camera.perspective(
                new Vector3d(0, 0, 6), new Vector3d(), new Vector3d(0, 1, 0), 45, 1, 100);
        Scene scene = Scene.builder().add(markers).viewpoint(camera).build();
        Raster raster = new Raster(64, 48);
        long one = onePicture(scene.frame(raster)).getVisible();
        assertEquals(2 * 81, one, "samples of two discs");

        // With 16 samples a pixel, about the same pixels are covered
        SampledFrame sampled = new SuperSampling(4).frame(scene, raster);
        long fine = sampled.render(new ZBufferRenderer()).getVisible();
        assertTrue(fine >= one && fine <= one * 1.3, fine + " pixels, and " + one + " with one sample");
    }

    @Test
    void aSphereIsCheckered() throws InterruptedException {
        Material material = new Material().withShader(new Checkers(8));
        Scene scene = Scene.builder().add(new Sphere(new Vector3d(), 1, material)).build();
        Image image = onePicture(scene.frame(64, 64));
        long colors = Arrays.stream(image.getArgb()).distinct().count();
        assertTrue(colors > 100, colors + " colours");
    }
}
