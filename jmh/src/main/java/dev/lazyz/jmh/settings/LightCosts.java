package dev.lazyz.jmh.settings;

import dev.lazyz.Frame;
import dev.lazyz.Raster;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.Rgba;
import dev.lazyz.ShadingRate;
import dev.lazyz.filter.SuperSampling;
import dev.lazyz.filter.SuperSampling.PixelFilter;
import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.lighting.AmbientOcclusion;
import dev.lazyz.lighting.GroundShadow;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.world.Scene;
import dev.lazyz.world.camera.Camera;
import dev.lazyz.world.light.Environment;
import dev.lazyz.world.light.Light;
import dev.lazyz.world.material.Lobes;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.material.Material.AlphaMode;
import dev.lazyz.world.material.Material.Shading;
import dev.lazyz.world.material.MetallicRoughness;
import dev.lazyz.world.surface.Mesh;
import dev.lazyz.world.surface.Surface;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Measures what light costs, and writes the tables of {@code docs/light.md}.
 *
 * <p>A picture is one of {@code zcli render} with the flag: shadows are computed, the scene is set up, and its frame is
 * rendered with 4 x 4 samples a pixel. Time is that of the processor, of one thread: the least of some runs, divided by
 * that of the picture without the flag. So other load on the machine has little effect.
 *
 * <p>What a lobe of a material costs is the time for a frame of a dome that fills the picture, less that of the frame
 * without light, divided by the samples of the dome. The materials take turns.
 */
public final class LightCosts {
    private static final List<String> SCENES = List.of("teapot", "city");
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    private static final int WARM_UP = 3;
    private static final int RUNS = 5;
    private static final int SIDE = 512;
    private static final int GRID = 33;
    private static final int LOBE_RUNS = 20;
    private static final RenderOptions OPTIONS = new RenderOptions().withThreads(1);
    private static final Renderer RENDERER = new TiledRenderer().configured(OPTIONS);
    private static final SuperSampling BY_SAMPLE = new SuperSampling(4);
    private static final SuperSampling BY_PIXEL = new SuperSampling(4, PixelFilter.BOX, ShadingRate.PIXEL);

    private LightCosts() {}

    /** Adds to a scene what has to be computed for it. */
    private interface Shadows {
        Scene of(Scene scene) throws InterruptedException;
    }

    private record Setting(SuperSampling sampling, Shadows shadows) {}

    /** The argument is the page. */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Path page = Path.of(arguments[0]);
        Map<String, String> tables = Map.of("costs", table(), "lobes", lobes());
        GeneratedPage.update(page, tables::get);
    }

    private static String lobes() throws InterruptedException {
        Map<String, Material> materials = materials();
        List<Frame> frames = new ArrayList<>();
        for (Material material : materials.values()) {
            frames.add(dome(material).frame(SIDE, SIDE));
        }
        double[] least = new double[frames.size()];
        Arrays.fill(least, Double.MAX_VALUE);
        for (int run = 0; run < LOBE_RUNS; run++) {
            for (int i = 0; i < least.length; i++) {
                long start = cpu();
                RENDERER.render(frames.get(i));
                least[i] = Math.min(least[i], cpu() - start);
            }
        }
        long samples = RENDERER.render(frames.get(0)).getVisible();
        List<String> names = new ArrayList<>(materials.keySet());
        List<String> times = new ArrayList<>();
        for (int i = 2; i < least.length; i++) {
            double unlit = least[materials.get(names.get(i)).isTranslucent() ? 1 : 0];
            times.add(String.format(Locale.ROOT, "%.0f", (least[i] - unlit) / samples));
        }
        return GeneratedPage.table(names.subList(2, names.size()), List.of(times));
    }

    /** By name; the first two are not lit: an opaque and a translucent one. */
    private static Map<String, Material> materials() {
        Material opaque = new Material(new Rgba(0.8f, 0.6f, 0.4f));
        Material blended = opaque.withAlphaMode(AlphaMode.BLEND);
        Map<String, Lobes> lobes = new LinkedHashMap<>();
        lobes.put("metallic-roughness", null);
        lobes.put("specular", new Lobes(new Lobes.Specular(0.5f)));
        lobes.put("sheen", new Lobes(null, new Lobes.Sheen(Rgba.WHITE, 0.5f)));
        lobes.put("clear coat", new Lobes(null, null, new Lobes.Clearcoat(1f, 0.25f)));
        lobes.put("anisotropy", new Lobes(null, null, null, null, null, new Lobes.Anisotropy(0.5f)));
        lobes.put("glass", new Lobes(null, null, null, new Lobes.Transmission(0.5f)));
        lobes.put("iridescence", new Lobes(null, null, null, null, new Lobes.Iridescence()));
        Map<String, Material> materials = new LinkedHashMap<>();
        materials.put("without light", opaque.withShading(Shading.CONSTANT));
        materials.put(
                "translucent",
                blended.withBaseColor(new Rgba(0.8f, 0.6f, 0.4f, 0.5f)).withShading(Shading.CONSTANT));
        lobes.forEach((name, lobe) -> materials.put(
                name,
                (name.equals("glass") ? blended : opaque)
                        .withMetallicRoughness(new MetallicRoughness(0.5f, 0.4f, null, lobe))));
        return materials;
    }

    /** Returns a dome with three lights in the studio, as seen from above its top. */
    private static Scene dome(Material material) {
        float[] positions = new float[3 * GRID * GRID];
        float[] normals = new float[positions.length];
        float[] uvs = new float[2 * GRID * GRID];
        int[] triangles = new int[6 * (GRID - 1) * (GRID - 1)];
        int to = 0;
        for (int i = 0; i < GRID * GRID; i++) {
            float u = (float) (i % GRID) / (GRID - 1);
            float v = (float) (i / GRID) / (GRID - 1);
            float x = 2 * u - 1;
            float y = 2 * v - 1;
            System.arraycopy(new float[] {x, y, 1 - (x * x + y * y) / 2}, 0, positions, 3 * i, 3);
            System.arraycopy(new float[] {x, y, 1}, 0, normals, 3 * i, 3);
            System.arraycopy(new float[] {u, 1 - v}, 0, uvs, 2 * i, 2);
            if (i % GRID < GRID - 1 && i / GRID < GRID - 1) {
                int[] square = {i, i + 1, i + GRID, i + 1, i + GRID + 1, i + GRID};
                System.arraycopy(square, 0, triangles, to, 6);
                to += 6;
            }
        }
        Mesh mesh = new Mesh(positions, triangles, material, normals, uvs).withTangents();
        Scene scene = Scene.builder().add(mesh).build().withViewpoint(Camera.fit(0, 0));
        return scene.withLights(Light.studio(scene.camera(SIDE, SIDE))).withEnvironment(Environment.USUAL);
    }

    private static String table() throws InterruptedException {
        List<String> head = new ArrayList<>(List.of("picture"));
        SCENES.forEach(name -> head.add(name + ": shadows + rest"));
        List<List<String>> rows = new ArrayList<>();
        settings().keySet().forEach(name -> rows.add(new ArrayList<>(List.of(name))));
        for (String name : SCENES) {
            Scene scene = Scenes.builtin(name);
            scene = scene.withViewpoint(scene.camera(WIDTH, HEIGHT));
            double base = 0;
            int row = 0;
            for (Setting setting : settings().values()) {
                double[] times = times(scene, setting);
                if (base == 0) {
                    base = times[1];
                }
                rows.get(row++).add(String.format(Locale.ROOT, "%.1f + %.1f", times[0] / base, times[1] / base));
            }
        }
        return GeneratedPage.table(head, rows);
    }

    /** By name; the first is the picture that the others are compared with. */
    private static Map<String, Setting> settings() {
        Map<String, Setting> settings = new LinkedHashMap<>();
        settings.put("the scene as it is", new Setting(BY_SAMPLE, scene -> scene));
        settings.put(
                "metallic-roughness materials, without environment",
                new Setting(BY_SAMPLE, scene -> physical(scene).withEnvironment(Environment.NONE)));
        settings.put(
                "metallic-roughness materials in the studio",
                new Setting(BY_SAMPLE, scene -> physical(scene).withEnvironment(Environment.USUAL)));
        settings.put("`--ambient-occlusion`", new Setting(BY_PIXEL, LightCosts::occluded));
        settings.put("`--ground-shadow`", new Setting(BY_SAMPLE, LightCosts::shadowed));
        settings.put("`--style product`", new Setting(BY_PIXEL, scene -> shadowed(occluded(scene))));
        return settings;
    }

    private static Scene physical(Scene scene) {
        return scene.withMaterials(Material::asMetallicRoughness);
    }

    private static Scene occluded(Scene scene) throws InterruptedException {
        return physical(scene)
                .withAmbientVisibility(AmbientOcclusion.of(
                        scene, AmbientOcclusion.DEFAULT_DIRECTIONS, AmbientOcclusion.DEFAULT_SIZE, OPTIONS));
    }

    private static Scene shadowed(Scene scene) throws InterruptedException {
        GroundShadow shadow = GroundShadow.of(scene, GroundShadow.DEFAULT_STRENGTH, OPTIONS);
        List<Surface> surfaces = new ArrayList<>(scene.getSurfaces());
        surfaces.add(shadow);
        return scene.withSurfaces(surfaces).withViewpoint(shadow.camera(scene.camera(WIDTH, HEIGHT)));
    }

    /** Returns the least time for shadows, and that for set-up and rendering, in nanoseconds. */
    private static double[] times(Scene scene, Setting setting) throws InterruptedException {
        double[] least = {Double.MAX_VALUE, Double.MAX_VALUE};
        for (int run = 0; run < WARM_UP + RUNS; run++) {
            long start = cpu();
            Scene lit = setting.shadows.of(scene);
            long middle = cpu();
            setting.sampling
                    .frame(lit, new Raster(WIDTH, HEIGHT, lit.getBackground()), OPTIONS)
                    .render(RENDERER);
            least[0] = Math.min(least[0], middle - start);
            least[1] = Math.min(least[1], cpu() - middle);
        }
        return least;
    }

    /** Returns the time of the processor that this thread has used, in nanoseconds. */
    private static long cpu() {
        return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
    }
}
