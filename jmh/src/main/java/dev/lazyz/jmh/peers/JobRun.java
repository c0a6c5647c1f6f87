package dev.lazyz.jmh.peers;

import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.scenes.LoadLimits;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.scenes.pictures.PictureFrame;
import dev.lazyz.scenes.pictures.PictureParameters;
import dev.lazyz.scenes.pictures.PictureSettings;
import dev.lazyz.scenes.writers.ImageFiles;
import dev.lazyz.scenes.writers.ImageFormat;
import dev.lazyz.strategies.tiled.TiledRenderer;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;

/**
 * Performs whole jobs, from a mesh file to the PNG file that {@code zcli render} makes of it, repeatedly in one
 * process. Each line of standard input is a request: {@code SECONDS SIDE SAMPLES FILE}, with 1, 4 or 16 samples a
 * pixel. The response is a line on standard output: the number of jobs, the time of the shortest in milliseconds, and
 * its times for loading and for rendering with writing. {@code vtk_job.py} uses the same protocol.
 */
public final class JobRun {
    private static final double NANOSECONDS = 1e6;

    private final Renderer renderer = new TiledRenderer(new RenderOptions());
    private final Path picture;

    private JobRun(Path picture) {
        this.picture = picture;
    }

    /** No arguments. */
    public static void main(String[] args) throws InterruptedException, IOException {
        Path picture = Files.createTempFile("lazyz-job-", ".png");
        try {
            JobRun run = new JobRun(picture);
            BufferedReader lines = new BufferedReader(new InputStreamReader(System.in));
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                String[] words = line.split(" ", 4);
                int side = Integer.parseInt(words[1]);
                PictureSettings settings = new PictureSettings(side, side)
                        .with(PictureParameters.AA, (int) Math.sqrt(Integer.parseInt(words[2])));
                System.out.println(run.measure(Double.parseDouble(words[0]), settings, Path.of(words[3])));
            }
        } finally {
            Files.deleteIfExists(picture);
        }
    }

    private String measure(double seconds, PictureSettings settings, Path file)
            throws InterruptedException, IOException {
        int count = 0;
        long[] best = {Long.MAX_VALUE / 2, 0};
        long end = System.nanoTime() + (long) (seconds * 1e9);
        do {
            long[] job = job(settings, file);
            best = job[0] + job[1] < best[0] + best[1] ? job : best;
            count++;
        } while (System.nanoTime() < end);
        return String.format(
                Locale.ROOT,
                "%d %.3f %.3f %.3f",
                count,
                (best[0] + best[1]) / NANOSECONDS,
                best[0] / NANOSECONDS,
                best[1] / NANOSECONDS);
    }

    /** Performs one job, and returns the times of loading and of rendering with writing, nanoseconds. */
    private long[] job(PictureSettings settings, Path file) throws InterruptedException, IOException {
        long start = System.nanoTime();
        LoadedScene scene = Scenes.load(file, settings.loadOptions(new LoadLimits()));
        long loaded = System.nanoTime();
        PictureFrame frame = settings.frame(scene);
        ImageFiles.write(
                picture,
                frame.getPixels().getWidth(),
                frame.getPixels().getHeight(),
                ImageFormat.PNG,
                frame.getAlpha(),
                sink -> frame.render(renderer, sink));
        return new long[] {loaded - start, System.nanoTime() - loaded};
    }
}
