package example;

import dev.lazyz.scenes.LoadLimits;
import dev.lazyz.scenes.LoadOptions;
import dev.lazyz.scenes.SceneFormat;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.strategies.tiled.TiledRenderer;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.time.Duration;

/**
 * A function that reads an STL file and writes a PNG file, for platforms that start a process for a request and keep it
 * for the next. The method has the form of {@code RequestStreamHandler} of AWS, without its third argument.
 */
public class Handler {
    private static final PictureSettings SETTINGS = new PictureSettings(256, 256);
    private static final LoadOptions OPTIONS = new LoadOptions(new LoadLimits()
            .withDecodedBytes(128L << 20)
            .withTime(Duration.ofSeconds(10)));

    /** What is created here is created before the first request, and kept for the next ones. */
    private final TiledRenderer renderer = new TiledRenderer();

    /** Renders a model. An exception for a damaged one names the place and what is wrong. */
    public void handle(InputStream input, OutputStream output) throws IOException, InterruptedException {
        var loaded = Scenes.load(input.readAllBytes(), SceneFormat.STL, "model", OPTIONS);
        Images.writePng(SETTINGS.frame(loaded).render(renderer), output);
    }

    /** Handles one request, from standard input to standard output: what happens in a cold start. */
    public static void main(String[] args) throws IOException, InterruptedException {
        try (OutputStream output = new BufferedOutputStream(System.out)) {
            new Handler().handle(System.in, output);
        }
    }
}
