package dev.lazyz;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.lazyz.strategies.zbuffer.ZBufferRenderer;
import dev.lazyz.world.Scene;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.surface.Sphere;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Compiles and runs the Java code of the README; it gives the same image as the Kotlin code. */
class JavaReadmeTest {
    @Test
    void tenLines() throws InterruptedException {
        Scene world = Scene.builder()
                .add(new Sphere(new Vector3d(0, 0, 0), 1.0, new Material(Rgba.ofRgb(0xD0452F))))
                .add(new Sphere(new Vector3d(1.2, 0.6, 0.4), 0.5, new Material(Rgba.ofRgb(0x2F7FD0))))
                .build();
        Image image = new ZBufferRenderer().render(world.frame(640, 480));
        System.out.println(image.getVisible() + " samples covered, " + image.pixelHash());
        assertEquals("937eba9c78aca01403a6fc3f149422e33a283f46f443437de74b74e2bfab3feb", image.pixelHash());
    }
}
