package example;

import dev.lazyz.Image;
import dev.lazyz.Renderer;
import dev.lazyz.scenes.LoadLimits;
import dev.lazyz.scenes.LoadOptions;
import dev.lazyz.scenes.PictureSettings;
import dev.lazyz.scenes.SceneFormat;
import dev.lazyz.scenes.SceneFormatException;
import dev.lazyz.scenes.Scenes;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.strategies.tiled.Tiled;
import java.io.IOException;
import java.io.InputStream;
import java.time.Duration;
import java.util.concurrent.Semaphore;
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

    /** Thread safe, like all renderers: one is enough for all requests. */
    private final Renderer renderer = new Tiled();

    /** A server has many more threads than a rendering should compete with. */
    final Semaphore places = new Semaphore(2 * Runtime.getRuntime().availableProcessors());

    public static void main(String[] args) {
        SpringApplication.run(PictureApplication.class, args);
    }

    @PostMapping("/picture")
    ResponseEntity<byte[]> picture(@RequestParam String format, InputStream body) throws IOException {
        SceneFormat known = SceneFormat.ofFileName("upload." + format);
        if (known == null) throw problem(HttpStatus.UNSUPPORTED_MEDIA_TYPE, "format must be obj, stl, ply or glb");
        if (!places.tryAcquire()) throw problem(HttpStatus.TOO_MANY_REQUESTS, "too many requests; try again later");
        try {
            byte[] model = body.readNBytes(MOST_BYTES + 1);
            if (model.length > MOST_BYTES) throw problem(HttpStatus.CONTENT_TOO_LARGE, "at most 20 MiB");
            return ResponseEntity.ok().contentType(MediaType.IMAGE_PNG).body(png(model, known));
        } catch (SceneFormatException | IllegalArgumentException invalid) {
            // The message says where and what is wrong, which limit was exceeded, or why there is no picture
            throw problem(HttpStatus.UNPROCESSABLE_CONTENT, invalid.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw problem(HttpStatus.SERVICE_UNAVAILABLE, "the server is being closed");
        } finally {
            places.release();
        }
    }

    private byte[] png(byte[] model, SceneFormat format) throws InterruptedException {
        Image image = SETTINGS.frame(Scenes.load(model, format, "upload", OPTIONS)).render(renderer);
        return Images.toPng(image);
    }

    private static ResponseStatusException problem(HttpStatus status, String reason) {
        return new ResponseStatusException(status, reason);
    }
}
