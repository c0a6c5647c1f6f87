package dev.lazyz.jmh.peers;

import dev.lazyz.Frame;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.scenes.Scenes;
import dev.lazyz.scenes.writers.AlphaChannel;
import dev.lazyz.scenes.writers.ImageFiles;
import dev.lazyz.scenes.writers.ImageFormat;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.world.Scene;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Performs whole jobs, from a mesh file to a PNG file of 512 x 512 samples, repeatedly in one process. Each line of
 * standard input is a request: {@code SECONDS FILE}. The response is a line on standard output: the number of jobs,
 * the time of the shortest in milliseconds, and its times for loading and for rendering with writing.
 * {@code vtk_job.py} uses the same protocol.
 */
public final class JobRun {
    private static final int SIDE = 512;
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
                int at = line.indexOf(' ');
                System.out.println(
                        run.measure(Double.parseDouble(line.substring(0, at)), Path.of(line.substring(at + 1))));
            }
        } finally {
            Files.deleteIfExists(picture);
        }
    }

    private String measure(double seconds, Path file) throws InterruptedException, IOException {
        List<long[]> jobs = new ArrayList<>();
        long end = System.nanoTime() + (long) (seconds * 1e9);
        do {
            jobs.add(job(file));
        } while (System.nanoTime() < end);
        long[] best = jobs.get(0);
        for (long[] job : jobs) {
            if (job[0] + job[1] < best[0] + best[1]) {
                best = job;
            }
        }
        return String.format(
                Locale.ROOT,
                "%d %.3f %.3f %.3f",
                jobs.size(),
                (best[0] + best[1]) / NANOSECONDS,
                best[0] / NANOSECONDS,
                best[1] / NANOSECONDS);
    }

    /** Performs one job, and returns the times of loading and of rendering with writing, nanoseconds. */
    private long[] job(Path file) throws InterruptedException, IOException {
        long start = System.nanoTime();
        Scene scene = Scenes.load(file).getScene();
        long loaded = System.nanoTime();
        Frame frame = scene.frame(SIDE, SIDE);
        ImageFiles.write(picture, SIDE, SIDE, ImageFormat.PNG, AlphaChannel.DROP, sink -> renderer.render(frame, sink));
        return new long[] {loaded - start, System.nanoTime() - loaded};
    }
}
