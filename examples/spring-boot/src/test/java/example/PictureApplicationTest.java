package example;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.scenes.SceneFormat;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.strategies.zbuffer.ZBufferRenderer;
import java.io.ByteArrayInputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.concurrent.Semaphore;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.springframework.boot.SpringApplication;
import org.springframework.context.ConfigurableApplicationContext;

class PictureApplicationTest {
    private static final byte[] MODEL = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".getBytes(StandardCharsets.US_ASCII);
    private static ConfigurableApplicationContext application;

    @BeforeAll
    static void start() {
        application = SpringApplication.run(PictureApplication.class, "--server.port=0");
    }

    @AfterAll
    static void end() {
        application.close();
    }

    private static HttpResponse<byte[]> post(String format, byte[] body) throws Exception {
        String port = application.getEnvironment().getProperty("local.server.port");
        URI address = URI.create("http://127.0.0.1:" + port + "/picture?format=" + format);
        HttpRequest request = HttpRequest.newBuilder(address)
                .POST(HttpRequest.BodyPublishers.ofByteArray(body))
                .build();
        return HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofByteArray());
    }

    @Test
    void thePictureHasTheBitsOfALocalRendering() throws Exception {
        HttpResponse<byte[]> answer = post("obj", MODEL);
        assertEquals(200, answer.statusCode());
        var picture = ImageIO.read(new ByteArrayInputStream(answer.body()));
        var frame = new PictureSettings(512, 512).frame(Scenes.load(MODEL, SceneFormat.OBJ));
        var local = frame.render(new ZBufferRenderer());
        assertArrayEquals(local.getArgb(), picture.getRGB(0, 0, 512, 512, null, 0, 512));
    }

    @Test
    void badModelsAreRefused() throws Exception {
        HttpResponse<byte[]> answer = post("stl", MODEL);
        String text = new String(answer.body(), StandardCharsets.UTF_8);
        assertEquals(422, answer.statusCode(), text);
        assertTrue(text.contains("upload"), text);
        assertEquals(415, post("doc", MODEL).statusCode());
        assertEquals(415, post("json", MODEL).statusCode());
        assertEquals(413, post("obj", new byte[(20 << 20) + 1]).statusCode());
    }

    /** Triangles that cover the picture, all in the same place. */
    private static byte[] layers(int triangles) {
        ByteBuffer data = ByteBuffer.allocate(36 + 6 * triangles).order(ByteOrder.LITTLE_ENDIAN);
        for (float value : new float[] {-9, -9, 0, 9, -9, 0, 0, 9, 0}) data.putFloat(value);
        for (int i = 0; i < 3 * triangles; i++) data.putShort((short) (i % 3));
        String json = """
                {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
                 "materials": [{"alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 0, 0.01]}}],
                 "buffers": [{"byteLength": %d, "uri": "data:application/octet-stream;base64,%s"}],
                 "bufferViews": [{"buffer": 0, "byteLength": 36},
                                 {"buffer": 0, "byteOffset": 36, "byteLength": %d}],
                 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                                "min": [-9, -9, 0], "max": [9, 9, 0]},
                               {"bufferView": 1, "componentType": 5123, "count": %d, "type": "SCALAR"}]}
                """
                .formatted(
                        data.capacity(),
                        Base64.getEncoder().encodeToString(data.array()),
                        6 * triangles,
                        3 * triangles);
        return json.getBytes(StandardCharsets.US_ASCII);
    }

    @Test
    void translucentLayersHaveLimitsOfMemoryAndTime() throws Exception {
        assertEquals(422, post("gltf", layers(50_000)).statusCode());
        assertEquals(503, post("gltf", layers(2_000)).statusCode());
        assertEquals(200, post("gltf", layers(3)).statusCode());
    }

    @Test
    void withoutAPlaceARequestIsRefused() throws Exception {
        Semaphore places = application.getBean(PictureApplication.class).places;
        int all = places.drainPermits();
        assertEquals(429, post("obj", MODEL).statusCode());
        places.release(all);
        assertEquals(200, post("obj", MODEL).statusCode());
        assertEquals(all, places.availablePermits());
    }
}
