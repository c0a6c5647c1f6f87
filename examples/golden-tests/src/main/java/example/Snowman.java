package example;

import dev.lazyz.Rgba;
import dev.lazyz.world.Scene;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.surface.Sphere;
import org.joml.Vector3d;

/** The product of this small company. */
final class Snowman {
    private static final Material SNOW = new Material(Rgba.ofRgb(0xEEF4FA));
    private static final Material COAL = new Material(Rgba.ofRgb(0x202428));
    private static final Material CARROT = new Material(Rgba.ofRgb(0xE07A1F));

    private Snowman() {}

    /** Returns a snowman with this number of buttons, 0 or more. */
    static Scene withButtons(int buttons) {
        Scene.Builder snowman = Scene.builder()
                .add(new Sphere(new Vector3d(0, 0, 0), 1.0, SNOW))
                .add(new Sphere(new Vector3d(0, 1.35, 0), 0.7, SNOW))
                .add(new Sphere(new Vector3d(-0.22, 1.55, 0.62), 0.09, COAL))
                .add(new Sphere(new Vector3d(0.22, 1.55, 0.62), 0.09, COAL))
                .add(new Sphere(new Vector3d(0, 1.35, 0.72), 0.13, CARROT));
        for (int i = 0; i < buttons; i++) {
            double angle = Math.toRadians(45 - 30 * i);
            snowman.add(new Sphere(new Vector3d(0, Math.sin(angle), Math.cos(angle)), 0.1, COAL));
        }
        return snowman.background(Rgba.ofRgb(0xBFD4E6)).build();
    }
}
