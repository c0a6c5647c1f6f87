package example;

import dev.lazyz.Image;
import dev.lazyz.Renderer;
import dev.lazyz.scenes.LoadLimits;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.PictureSettings;
import dev.lazyz.scenes.SceneFormat;
import dev.lazyz.scenes.SceneFormatException;
import dev.lazyz.scenes.Scenes;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.strategies.tiled.Tiled;
import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.time.Duration;

/** Renders an uploaded model: {@code POST /picture?format=obj} with the file as the body returns a PNG. */
public class PictureServlet extends HttpServlet {
    private static final int MOST_BYTES = 20 << 20;

    /** What a model may ask for. A small file can describe a huge model, so the size of the upload is not enough. */
    private static final LoadLimits LIMITS = new LoadLimits()
            .withDecodedBytes(256L << 20)
            .withTriangles(2_000_000)
            .withVertices(2_000_000)
            .withTexels(16_000_000)
            .withTime(Duration.ofSeconds(5));

    /** The whole model, anti-aliased. Properties choose camera, light and background. */
    private static final PictureSettings SETTINGS = new PictureSettings(512, 512);

    /** Thread safe, like all renderers: one is enough for all requests. */
    private final Renderer renderer = new Tiled();

    @Override
    protected void doPost(HttpServletRequest request, HttpServletResponse response) throws IOException {
        SceneFormat format = SceneFormat.ofFileName("upload." + request.getParameter("format"));
        if (format == null) {
            response.sendError(HttpServletResponse.SC_UNSUPPORTED_MEDIA_TYPE, "format must be obj, stl, ply or glb");
            return;
        }
        byte[] body = request.getInputStream().readNBytes(MOST_BYTES + 1);
        if (body.length > MOST_BYTES) {
            response.sendError(HttpServletResponse.SC_REQUEST_ENTITY_TOO_LARGE, "at most 20 MiB");
            return;
        }
        LoadedScene loaded;
        try {
            loaded = Scenes.load(new ByteArrayInputStream(body), format, "upload", null, LIMITS);
        } catch (SceneFormatException e) {
            // The message names the line or byte, what is wrong, and the limit if one was exceeded
            response.sendError(HttpServletResponse.SC_BAD_REQUEST, e.getMessage());
            return;
        }
        Image image;
        try {
            image = SETTINGS.frame(loaded).render(renderer);
        } catch (IllegalArgumentException e) {
            // No camera can show the model: it extends beyond the range of numbers
            response.sendError(HttpServletResponse.SC_BAD_REQUEST, e.getMessage());
            return;
        } catch (InterruptedException e) {
            // The container shuts down, or limits the time of a request
            Thread.currentThread().interrupt();
            response.sendError(HttpServletResponse.SC_SERVICE_UNAVAILABLE);
            return;
        }
        response.setContentType("image/png");
        Images.writePng(image, response.getOutputStream());
    }
}
