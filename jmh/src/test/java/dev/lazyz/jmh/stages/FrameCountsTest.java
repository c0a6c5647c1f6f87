package dev.lazyz.jmh.stages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.jmh.peers.TriangleSource;
import dev.lazyz.strategies.Renderers;
import org.junit.jupiter.api.Test;

class FrameCountsTest {
    private static final Renderer TILED = Renderers.find("tiled").configured(new RenderOptions().withThreads(1));

    /** Layers of two triangles each; both reach three of four tiles. */
    @Test
    void layersThatFillFourTiles() throws Exception {
        FrameCounts counts = FrameCounts.of("S3", TriangleSource.find("S3"), 128, TILED);
        assertEquals(400, counts.vertices());
        assertEquals(200, counts.triangles());
        assertEquals(0, counts.perspective());
        assertEquals(0, counts.small());
        assertEquals(200 * 3, counts.entries());
        assertEquals(128 * 128, counts.drawn());
        assertEquals(128 * 128, counts.visible());
        assertEquals(2 * 3, counts.faces());
        assertEquals(0, counts.mixed());
        // In two tiles two triangles share all rows, but a row that one of them has alone; the others have one run
        assertTrue(counts.runs() >= 2 * 128 + 2 * 63 && counts.runs() <= 2 * 128 + 2 * 64, counts.toString());
    }

    @Test
    void smallTrianglesOfAMeshAreCountedByTheirFragments() throws Exception {
        FrameCounts counts = FrameCounts.of("teapot", TriangleSource.find("teapot"), 64, TILED);
        assertEquals(1, counts.perspective());
        assertTrue(counts.small() > 100, counts.toString());
        assertTrue(counts.smallFragments() >= counts.small(), counts.toString());
        assertTrue(counts.visible() > 64 && counts.visible() < counts.drawn(), counts.toString());
        assertTrue(counts.mixed() > 0 && counts.mixed() <= counts.visible(), counts.toString());
        assertTrue(counts.compared() >= counts.visible(), counts.toString());
    }
}
