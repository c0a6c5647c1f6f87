package example;

import dev.lazyz.Image;
import dev.lazyz.Renderer;
import dev.lazyz.planning.RenderPlanner.RenderPlan;
import dev.lazyz.planning.RenderPlanner;
import dev.lazyz.scenes.LoadLimits;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.SceneFormat;
import dev.lazyz.scenes.SceneFormatException;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.pictures.PictureFrame;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.strategies.tiled.TiledRenderer;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Renders an uploaded model: {@code POST /picture?format=obj} with the file as the body returns a PNG. */
public class PictureServlet extends HttpServlet {
    private static final int MOST_BYTES = 20 << 20;

    /** The formats of models. Scene files are for people who trust their content. */
    private static final Set<SceneFormat> FORMATS = EnumSet.complementOf(EnumSet.of(SceneFormat.SCENE));

    /** What a model may ask for. A small file can describe a huge model, so the size of the upload is not enough. */
    private static final LoadLimits LIMITS = new LoadLimits()
            .withDecodedBytes(64L << 20)
            .withTriangles(2_000_000)
            .withVertices(2_000_000)
            .withTexels(16_000_000)
            .withTime(Duration.ofSeconds(5));

    /** The whole model, anti-aliased. Properties choose camera, light and background. */
    private static final PictureSettings SETTINGS = new PictureSettings(512, 512);

    /** What drawing may take: many translucent layers take much, although their file is small. */
    private static final long DRAWING_BYTES = 128L << 20;

    /** Thread safe, like all renderers: one is enough for all requests. */
    private final Renderer renderer = new TiledRenderer();

    /** The number of threads limits how many models are in memory. */
    private final ExecutorService workers = Executors.newFixedThreadPool(2);

    private final int mostSeconds;

    /** For containers: five seconds a picture. */
    public PictureServlet() {
        this(5);
    }

    PictureServlet(int mostSeconds) {
        this.mostSeconds = mostSeconds;
    }

    @Override
    protected void doPost(HttpServletRequest request, HttpServletResponse response)
            throws IOException, ServletException {
        SceneFormat format = SceneFormat.ofFileName("upload." + request.getParameter("format"));
        if (!FORMATS.contains(format)) {
            String message = "format must be obj, stl, ply, off, 3mf, gltf or glb";
            response.sendError(HttpServletResponse.SC_UNSUPPORTED_MEDIA_TYPE, message);
            return;
        }
        byte[] body = request.getInputStream().readNBytes(MOST_BYTES + 1);
        if (body.length > MOST_BYTES) {
            response.sendError(HttpServletResponse.SC_REQUEST_ENTITY_TOO_LARGE, "at most 20 MiB");
            return;
        }
        Image image;
        Future<Image> task = workers.submit(() -> picture(body, format));
        try {
            image = task.get(mostSeconds, TimeUnit.SECONDS);
        } catch (TimeoutException e) {
            // Interrupts the thread: it goes on with the next request
            task.cancel(true);
            response.sendError(HttpServletResponse.SC_SERVICE_UNAVAILABLE, "the picture takes too long");
            return;
        } catch (ExecutionException e) {
            Throwable cause = e.getCause();
            if (!(cause instanceof SceneFormatException || cause instanceof IllegalArgumentException)) {
                throw new ServletException(cause);
            }
            // The message names the line or byte, what is wrong, and the limit if one was exceeded
            response.sendError(HttpServletResponse.SC_BAD_REQUEST, cause.getMessage());
            return;
        } catch (InterruptedException e) {
            // The container shuts down
            task.cancel(true);
            Thread.currentThread().interrupt();
            response.sendError(HttpServletResponse.SC_SERVICE_UNAVAILABLE);
            return;
        }
        response.setContentType("image/png");
        Images.writePng(image, response.getOutputStream());
    }

    private Image picture(byte[] body, SceneFormat format) throws IOException, InterruptedException {
        LoadedScene loaded = Scenes.load(new ByteArrayInputStream(body), format, "upload", null, LIMITS);
        long setUp = loaded.getScene().getSetUpBytes();
        requireMemory(setUp <= DRAWING_BYTES);
        PictureFrame frame = SETTINGS.frame(loaded);
        RenderPlan plan = frame.plan(
                new RenderPlanner(DRAWING_BYTES), List.of(renderer), List.of(new RenderPlan.Item("set-up", setUp)));
        requireMemory(plan.getFits());
        return frame.render(plan.getRenderer());
    }

    private static void requireMemory(boolean isEnough) {
        if (!isEnough) throw new IllegalArgumentException("too many triangles or translucent layers to draw");
    }

    @Override
    public void destroy() {
        workers.shutdownNow();
    }
}
