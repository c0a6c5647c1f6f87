package dev.lazyz.jmh.workload;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.DepthTest;
import dev.lazyz.Image;
import dev.lazyz.Rgba;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.world.Scene;
import dev.lazyz.world.material.Material;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

class WorkloadsTest {
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    void everythingLiesWithinTheRaster() {
        for (String id : Workloads.COMPARED) {
            for (float coordinate : Workloads.triangles(id).positions()) {
                assertTrue(Math.abs(coordinate) <= 1.0001f, id + " reaches " + coordinate);
            }
        }
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    void largerRasterIsTheSameSceneLarger() throws InterruptedException {
        double small = (double) new TiledRenderer()
                        .render(Workloads.scene("S2").frame(64, 64))
                        .getVisible()
                / (64 * 64);
        double large = (double) new TiledRenderer()
                        .render(Workloads.scene("S2").frame(256, 256))
                        .getVisible()
                / (256 * 256);
        assertEquals(small, large, 0.02);
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    void builtInScenesAreTrianglesToo() throws InterruptedException {
        for (String id : new String[] {"city", "molecule", "cycle", "teapot"}) {
            Triangles baked = Baked.of(id, Workloads.scene(id));
            Image ours = new TiledRenderer().render(Workloads.scene(id).frame(128, 128));
            Image theirs = new TiledRenderer().render(baked.scene().frame(128, 128));
            int different = 0;
            for (int i = 0; i < 128 * 128; i++) {
                boolean isOurs = ours.getPrimitive()[i] != DepthTest.BACKGROUND;
                different += isOurs == (theirs.getPrimitive()[i] != DepthTest.BACKGROUND) ? 0 : 1;
            }
            assertTrue(different < 128 * 128 / 100, id + " covers " + different + " other samples");
        }
    }

    @Test
    void everyIdMakesAScene() {
        for (String id : Workloads.ids()) {
            assertNotNull(Workloads.scene(id));
        }
    }

    @Test
    void fileHoldsWhatItSays(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("S3.triangles");
        Workloads.triangles("S3").write(file);
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        assertEquals(8 + 16 + 64 + 16 * 400 + 4 * 600, bytes.capacity());
        assertEquals(Coloring.FLAT.ordinal(), bytes.getInt(8));
        assertEquals(0, bytes.getInt(12), "no perspective");
        assertEquals(400, bytes.getInt(16));
        assertEquals(600, bytes.getInt(20));
        float[] matrix = new float[16];
        for (int i = 0; i < 16; i++) {
            matrix[i] = bytes.getFloat(24 + 4 * i);
        }
        assertArrayEquals(new float[] {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1}, matrix);
    }

    @Test
    void fileOfLitTrianglesEndsWithNormalsAndLight(@TempDir Path folder) throws Exception {
        Triangles lit = Baked.lit("teapot", Workloads.scene("teapot"));
        Path file = folder.resolve("lit.triangles");
        lit.write(file);
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        assertEquals(Coloring.LIT.ordinal(), bytes.getInt(8));
        int normals = 8 + 16 + 64 + 16 * lit.vertexCount() + 4 * lit.indices().length;
        assertEquals(normals + 12 * lit.vertexCount() + 4 * 19, bytes.capacity());
        assertEquals(lit.normals()[4], bytes.getFloat(normals + 16));
        int light = normals + 12 * lit.vertexCount();
        assertEquals(1, bytes.getFloat(light + 12), "the eye is a point");
        assertEquals(0.062f, bytes.getFloat(light + 20), "green of the ambient light");
        assertEquals(0.59f, bytes.getFloat(light + 48), "blue of the first light");
    }

    @Test
    void litTrianglesHaveTheLightOfTheirScene() throws InterruptedException {
        Scene scene =
                Workloads.scene("crossing").withLights(List.of()).withMaterials(material -> new Material(Rgba.WHITE));
        Image expected = new TiledRenderer()
                .render(scene.withBackground(Rgba.TRANSPARENT).frame(64, 64));
        Image actual =
                new TiledRenderer().render(Baked.lit("crossing", scene).scene().frame(64, 64));
        int different = 0;
        for (int i = 0; i < 64 * 64; i++) {
            for (int shift = 0; shift < 32; shift += 8) {
                int off = (expected.getArgb()[i] >> shift & 0xFF) - (actual.getArgb()[i] >> shift & 0xFF);
                different += Math.abs(off) > 1 ? 1 : 0;
            }
        }
        assertEquals(0, different);
    }
}
