package dev.lazyz.jmh.workload;

import dev.lazyz.scenes.Builtin;
import dev.lazyz.scenes.Scenes;
import dev.lazyz.world.Scene;
import java.util.ArrayList;
import java.util.List;

/**
 * The scenes that are measured: {@code S1} to {@code S6}, made to be compared with peers, and the built-in scenes. All are
 * made by code, the same bits at each call.
 *
 * <table>
 * <caption>S1 to S6; sizes of triangles at 1024 x 1024</caption>
 * <tr><td>S1</td><td>100,000 triangles of about 200 pixels at random places and depths, a colour each</td></tr>
 * <tr><td>S2</td><td>1,002,252 triangles of 1 to 2 pixels that share vertices: a bumpy sphere in smooth colours</td></tr>
 * <tr><td>S3</td><td>100 layers that fill the raster, from back to front</td></tr>
 * <tr><td>S4</td><td>the same layers from front to back</td></tr>
 * <tr><td>S5</td><td>the triangles of S1 under an expensive shader, {@link RoundsShader}</td></tr>
 * <tr><td>S6</td><td>10,000 triangles of about 20,000 pixels, in smooth colours</td></tr>
 * </table>
 */
public final class Workloads {
    /** S1 to S6. */
    public static final List<String> COMPARED = List.of("S1", "S2", "S3", "S4", "S5", "S6");

    private static final int LAYERS = 100;

    private Workloads() {}

    /** Returns the ids of all scenes: S1 to S6, then the built-in ones. */
    public static List<String> ids() {
        List<String> ids = new ArrayList<>(COMPARED);
        Scenes.getBuiltins().stream().map(Builtin::getId).forEach(ids::add);
        return ids;
    }

    /** Makes the scene called {@code id}. */
    public static Scene scene(String id) {
        if (COMPARED.contains(id)) {
            return triangles(id).scene();
        }
        Scene scene = Scenes.builtin(id);
        if (scene == null) {
            throw new IllegalArgumentException("no scene '" + id + "'; there are " + ids());
        }
        return scene;
    }

    /** Makes the triangles of one of S1 to S6. */
    public static Triangles triangles(String id) {
        return switch (id) {
            case "S1" -> Confetti.of(id, 100_000, 200, 0.02, Coloring.FLAT);
            case "S2" -> BumpySphere.of(id);
            case "S3" -> layers(id, true);
            case "S4" -> layers(id, false);
            case "S5" -> Confetti.of(id, 100_000, 200, 0.02, Coloring.ROUNDS);
            case "S6" -> Confetti.of(id, 10_000, 20_000, 0.04, Coloring.SMOOTH);
            default -> throw new IllegalArgumentException("no scene '" + id + "'; there are " + COMPARED);
        };
    }

    private static Triangles layers(String id, boolean isBackToFront) {
        ScreenTriangles triangles = new ScreenTriangles();
        for (int i = 0; i < LAYERS; i++) {
            int layer = isBackToFront ? LAYERS - 1 - i : i;
            double z = -0.9 + 1.8 * layer / (LAYERS - 1);
            int red = 40 + layer * 41 % 200;
            int green = 40 + layer * 67 % 200;
            int blue = 40 + layer * 97 % 200;
            int a = triangles.vertex(-1, -1, z, red, green, blue);
            int b = triangles.vertex(1, -1, z, red, green, blue);
            int c = triangles.vertex(1, 1, z, red, green, blue);
            int d = triangles.vertex(-1, 1, z, red, green, blue);
            triangles.triangle(a, b, c);
            triangles.triangle(a, c, d);
        }
        return triangles.toTriangles(id, Coloring.FLAT);
    }
}
