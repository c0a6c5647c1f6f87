package example;

import dev.lazyz.Image;
import dev.lazyz.scenes.SceneFormat;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.strategies.flow.FlowRenderer;
import dev.lazyz.world.Scene;
import dev.lazyz.world.surface.Sphere;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.joml.Vector3d;

/** Pictures of spheres and models, as PNG files. */
class Pictures {
    private Pictures() {}

    static byte[] sphere() throws InterruptedException {
        Scene scene = Scene.builder().add(new Sphere(new Vector3d(), 1)).build();
        return Images.toPng(new FlowRenderer().render(scene.frame(64, 48)));
    }

    /** Returns the picture of a model that is text, such as OBJ, glTF and scene files. */
    static Image ofModel(String text, SceneFormat format) throws IOException, InterruptedException {
        var bytes = new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8));
        var frame = Scenes.load(bytes, format).getScene().frame(64, 48);
        return Renderers.auto(frame).render(frame);
    }
}
