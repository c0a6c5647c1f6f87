package example;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import javax.imageio.ImageIO;
import org.eclipse.jetty.ee10.servlet.ServletContextHandler;
import org.eclipse.jetty.ee10.servlet.ServletHolder;
import org.eclipse.jetty.server.Server;
import org.eclipse.jetty.server.ServerConnector;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** The servlet in a real server. */
class PictureServletTest {
    private static final String TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    private static final Server SERVER = new Server();
    private static final ServerConnector CONNECTOR = new ServerConnector(SERVER);

    @BeforeAll
    static void start() throws Exception {
        ServletContextHandler context = new ServletContextHandler();
        // On a busy machine, any picture may take seconds
        context.addServlet(new ServletHolder(new PictureServlet(600)), "/picture");
        context.addServlet(new ServletHolder(new PictureServlet(1)), "/hurried");
        SERVER.addConnector(CONNECTOR);
        SERVER.setHandler(context);
        SERVER.start();
    }

    @AfterAll
    static void stop() throws Exception {
        SERVER.stop();
    }

    private static HttpResponse<byte[]> post(String format, byte[] body) throws Exception {
        return post("/picture", format, body);
    }

    private static HttpResponse<byte[]> post(String path, String format, byte[] body) throws Exception {
        URI uri = URI.create("http://localhost:" + CONNECTOR.getLocalPort() + path + "?format=" + format);
        HttpRequest request = HttpRequest.newBuilder(uri)
                .POST(HttpRequest.BodyPublishers.ofByteArray(body))
                .build();
        return HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofByteArray());
    }

    private static void assertRefused(int status, String reason, HttpResponse<byte[]> response) {
        String text = new String(response.body(), StandardCharsets.UTF_8);
        assertEquals(status, response.statusCode(), text);
        assertTrue(text.contains(reason), text);
    }

    @Test
    void aModelBecomesAPicture() throws Exception {
        HttpResponse<byte[]> response = post("obj", TRIANGLE.getBytes(StandardCharsets.US_ASCII));
        assertEquals(200, response.statusCode());
        assertEquals("image/png", response.headers().firstValue("content-type").orElseThrow());
        var image = ImageIO.read(new ByteArrayInputStream(response.body()));
        assertEquals(512, image.getWidth());
        assertTrue(image.getRGB(230, 280) != image.getRGB(0, 0), "the triangle is in the picture");
    }

    @Test
    void badInputIsTheClientsMistake() throws Exception {
        String broken = TRIANGLE.replace("f 1 2 3", "f 1 2 9");
        assertRefused(400, "line 4", post("obj", broken.getBytes(StandardCharsets.US_ASCII)));
        assertRefused(415, "format must be", post("exe", new byte[10]));
        assertRefused(415, "format must be", post("json", "{\"lazyz\": 1}".getBytes(StandardCharsets.US_ASCII)));
        assertRefused(413, "at most 20 MiB", post("stl", new byte[(20 << 20) + 1]));
    }

    @Test
    void aSmallFileThatDescribesAHugeModelIsRefused() throws Exception {
        String json = """
                {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                 "accessors": [{"componentType": 5126, "count": 300000000, "type": "VEC3",
                                "min": [0, 0, 0], "max": [0, 0, 0]}]}
                """;
        assertRefused(400, "are more than", post("gltf", json.getBytes(StandardCharsets.US_ASCII)));
    }

    @Test
    void translucentLayersHaveLimitsOfMemoryAndTime() throws Exception {
        assertRefused(400, "translucent layers", post("gltf", layers(50_000)));
        assertRefused(503, "takes too long", post("/hurried", "gltf", layers(2_000)));
        assertEquals(200, post("gltf", layers(3)).statusCode());
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
}
