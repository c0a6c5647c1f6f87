package dev.lazyz.jmh.settings;

import dev.lazyz.Raster;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.ShadingRate;
import dev.lazyz.filter.SuperSampling;
import dev.lazyz.filter.SuperSampling.PixelFilter;
import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.lighting.AmbientOcclusion;
import dev.lazyz.lighting.GroundShadow;
import dev.lazyz.scenes.Scenes;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.world.Environment;
import dev.lazyz.world.Scene;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.surface.Surface;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Measures what light costs, and writes the table of {@code docs/light.md}.
 *
 * <p>A picture is one of {@code zcli render} with the flag: shadows are computed, the scene is set up, and its frame is
 * rendered with 4 x 4 samples a pixel. Time is that of the processor, of one thread: the least of some runs, divided by
 * that of the picture without the flag. So other load on the machine has little effect.
 */
public final class LightCosts {
    private static final List<String> SCENES = List.of("teapot", "city");
    private static final int WIDTH = 640;
    private static final int HEIGHT = 480;
    private static final int WARM_UP = 3;
    private static final int RUNS = 5;
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
        String table = table();
        GeneratedPage.update(page, name -> table);
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
