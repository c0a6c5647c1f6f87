package example;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.Frame;
import dev.lazyz.scenes.SceneFormat;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.strategies.Renderers;
import java.io.ByteArrayInputStream;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;

/** Surefire runs these tests on the module path, with the modules that the application requires. */
class PicturesTest {
    @Test
    void theApplicationAndTheLibrariesAreModules() {
        assertEquals("example", Pictures.class.getModule().getName());
        for (Class<?> type : List.of(Frame.class, Scenes.class)) {
            assertFalse(type.getModule().getDescriptor().isAutomatic(), type.getModule().toString());
        }
        assertTrue(Frame.class.getModule().isExported("dev.lazyz.strategies"));
        assertFalse(Frame.class.getModule().isExported("dev.lazyz.raster"));
    }

    @Test
    void aPictureIsAPngFile() throws Exception {
        assertEquals(64, ImageIO.read(new ByteArrayInputStream(Pictures.sphere())).getWidth());
    }

    @Test
    void modelsAreReadByLibrariesInOtherModules() throws Exception {
        String obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        String scene = "{\"lazyz\": 1, \"surfaces\": [{\"sphere\": {\"center\": [0, 0, 0], \"radius\": 1}}]}";
        String triangle = "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
        String gltf = "{\"asset\": {\"version\": \"2.0\"}, \"scene\": 0, \"scenes\": [{\"nodes\": [0]}],"
                + "\"nodes\": [{\"mesh\": 0}], \"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}],"
                + "\"accessors\": [{\"bufferView\": 0, \"componentType\": 5126, \"count\": 3, \"type\": \"VEC3\","
                + "\"min\": [0, 0, 0], \"max\": [1, 1, 0]}], \"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}],"
                + "\"buffers\": [{\"byteLength\": 36, \"uri\": \"" + triangle + "\"}]}";
        assertTrue(Pictures.ofModel(obj, SceneFormat.OBJ).getVisible() > 100);
        assertTrue(Pictures.ofModel(scene, SceneFormat.SCENE).getVisible() > 100);
        assertTrue(Pictures.ofModel(gltf, SceneFormat.GLTF).getVisible() > 100);
        assertThrows(Exception.class, () -> Pictures.ofModel("{", SceneFormat.SCENE));
    }

    @Test
    void allRenderersAreThere() {
        assertEquals(Renderers.getBuiltIn().size(), Renderers.all().size());
    }
}
