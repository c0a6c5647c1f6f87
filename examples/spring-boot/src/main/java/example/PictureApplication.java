package example;

import dev.lazyz.Renderer;
import dev.lazyz.planning.RenderPlanner.RenderPlan;
import dev.lazyz.planning.RenderPlanner;
import dev.lazyz.scenes.LoadLimits;
import dev.lazyz.scenes.LoadOptions;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.SceneFormat;
import dev.lazyz.scenes.SceneFormatException;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.pictures.PictureFrame;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.strategies.tiled.TiledRenderer;
import jakarta.annotation.PreDestroy;
import java.io.IOException;
import java.io.InputStream;
import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.springframework.boot.SpringApplication;
import org.springframework.boot.autoconfigure.SpringBootApplication;
import org.springframework.http.HttpStatus;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;
import org.springframework.web.server.ResponseStatusException;

/** Renders an uploaded model: {@code POST /picture?format=obj} with the file as the body returns a PNG. */
@SpringBootApplication
@RestController
public class PictureApplication {
    private static final int MOST_BYTES = 20 << 20;

    /** What a model may ask for: all places together must fit into the heap. */
    private static final LoadOptions OPTIONS = new LoadOptions(new LoadLimits()
            .withDecodedBytes(64L << 20)
            .withTriangles(2_000_000)
            .withTime(Duration.ofSeconds(5)));

    /** The whole model, anti-aliased. Properties choose camera, light and background. */
    private static final PictureSettings SETTINGS = new PictureSettings(512, 512);

    /** The formats of models. Scene files are for people who trust their content. */
    private static final Set<SceneFormat> FORMATS = EnumSet.complementOf(EnumSet.of(SceneFormat.SCENE));

    /** What drawing may take: many translucent layers take much, although their file is small. */
    private static final long DRAWING_BYTES = 64L << 20;

    private static final int MOST_SECONDS = 10;

    /** Thread safe, like all renderers: one is enough for all requests. */
    private final Renderer renderer = new TiledRenderer();

    /** A server has many more threads than a rendering should compete with. */
    final Semaphore places = new Semaphore(2 * Runtime.getRuntime().availableProcessors());

    private final ExecutorService workers = Executors.newCachedThreadPool();

    public static void main(String[] args) {
        SpringApplication.run(PictureApplication.class, args);
    }

    @PostMapping("/picture")
    ResponseEntity<byte[]> picture(@RequestParam String format, InputStream body) throws IOException {
        SceneFormat known = SceneFormat.ofFileName("upload." + format);
        if (!FORMATS.contains(known)) {
            String message = "format must be obj, stl, ply, off, 3mf, gltf or glb";
            throw problem(HttpStatus.UNSUPPORTED_MEDIA_TYPE, message);
        }
        if (!places.tryAcquire()) throw problem(HttpStatus.TOO_MANY_REQUESTS, "too many requests; try again later");
        try {
            byte[] model = body.readNBytes(MOST_BYTES + 1);
            if (model.length > MOST_BYTES) throw problem(HttpStatus.CONTENT_TOO_LARGE, "at most 20 MiB");
            byte[] picture = timed(workers.submit(() -> png(model, known)));
            return ResponseEntity.ok().contentType(MediaType.IMAGE_PNG).body(picture);
        } catch (ExecutionException failed) {
            Throwable cause = failed.getCause();
            if (!(cause instanceof SceneFormatException || cause instanceof IllegalArgumentException)) {
                throw new IllegalStateException(cause);
            }
            // The message says where and what is wrong, which limit was exceeded, or why there is no picture
            throw problem(HttpStatus.UNPROCESSABLE_CONTENT, cause.getMessage());
        } catch (TimeoutException e) {
            throw problem(HttpStatus.SERVICE_UNAVAILABLE, "the picture takes too long");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw problem(HttpStatus.SERVICE_UNAVAILABLE, "the server is being closed");
        } finally {
            places.release();
        }
    }

    /** Returns the result of a task. A task that takes too long is interrupted, and ends soon. */
    private static byte[] timed(Future<byte[]> task) throws ExecutionException, InterruptedException, TimeoutException {
        try {
            return task.get(MOST_SECONDS, TimeUnit.SECONDS);
        } finally {
            task.cancel(true);
        }
    }

    private byte[] png(byte[] model, SceneFormat format) throws IOException, InterruptedException {
        LoadedScene loaded = Scenes.load(model, format, "upload", OPTIONS);
        long setUp = loaded.getScene().getSetUpBytes();
        requireMemory(setUp <= DRAWING_BYTES);
        PictureFrame frame = SETTINGS.frame(loaded);
        RenderPlan plan = frame.plan(
                new RenderPlanner(DRAWING_BYTES), List.of(renderer), List.of(new RenderPlan.Item("set-up", setUp)));
        requireMemory(plan.getFits());
        return Images.toPng(frame.render(plan.getRenderer()));
    }

    private static void requireMemory(boolean isEnough) {
        if (!isEnough) throw new IllegalArgumentException("too many triangles or translucent layers to draw");
    }

    @PreDestroy
    void end() {
        workers.shutdownNow();
    }

    private static ResponseStatusException problem(HttpStatus status, String reason) {
        return new ResponseStatusException(status, reason);
    }
}
