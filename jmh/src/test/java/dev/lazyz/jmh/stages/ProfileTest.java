package dev.lazyz.jmh.stages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.Raster;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.Rgba;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.world.Scene;
import java.util.Arrays;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ProfileTest {
    @Test
    void theStagesOfAFrameAddUpToItsTime() throws Exception {
        Scene scene = Workloads.scene("S6");
        Renderer renderer = Renderers.find("tiled").configured(new RenderOptions().withThreads(1));
        DroppedRows rows = new DroppedRows();
        Profile profile = Profile.of(() -> {
            long end = System.nanoTime() + 500_000_000L;
            while (System.nanoTime() < end) {
                renderer.render(scene.frame(new Raster(64, 64, Rgba.TRANSPARENT)), rows);
            }
        });
        assertTrue(profile.samples() > 0);
        assertEquals(Set.of(), profile.unknown());
        double sum = Arrays.stream(Stage.values())
                .mapToDouble(stage -> profile.time(stage, 1, 2))
                .sum();
        assertEquals(3, sum, 1e-9);
        assertEquals(1, profile.methods(1).size());
    }
}
