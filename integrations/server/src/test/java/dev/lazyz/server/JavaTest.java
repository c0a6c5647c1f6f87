package dev.lazyz.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.scenes.LoadLimits;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.time.Duration;
import org.junit.jupiter.api.Test;

class JavaTest {
    @Test
    void aServerInAnApplication() throws Exception {
        ServerConfig config = new ServerConfig()
                .withPort(0)
                .withQueue(8)
                .withLimits(new LoadLimits().withTriangles(1_000_000))
                .withRenderTime(Duration.ofMinutes(10))
                .withLog(line -> {});
        try (RenderServer server = new RenderServer(config).start()) {
            String model = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
            URI address = URI.create("http://127.0.0.1:" + server.getPort() + "/render?size=64&format=obj");
            HttpRequest request = HttpRequest.newBuilder(address)
                    .POST(HttpRequest.BodyPublishers.ofString(model))
                    .build();
            HttpResponse<byte[]> answer =
                    HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofByteArray());
            assertEquals(200, answer.statusCode());
            assertTrue(server.metrics().contains("lazyz_render_seconds_count 1\n"));

            RenderServer second = new RenderServer(config.withPort(server.getPort()));
            IOException inUse = assertThrows(IOException.class, second::start);
            assertTrue(inUse.getMessage().startsWith("cannot listen at 127.0.0.1:"));
        }
        RenderServer closed = new RenderServer(config);
        closed.close();
        assertThrows(IllegalStateException.class, closed::start);
        assertThrows(IllegalArgumentException.class, () -> config.withPort(-1));
    }

    @Test
    void codeOfThePage() throws Exception {
        ServerConfig config = new ServerConfig().withPort(0).withQueue(16);
        try (RenderServer server = new RenderServer(config).start()) {
            System.out.println("http://127.0.0.1:" + server.getPort() + "/");
        }
    }
}
