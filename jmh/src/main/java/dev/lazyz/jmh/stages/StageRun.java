package dev.lazyz.jmh.stages;

import dev.lazyz.Raster;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.Rgba;
import dev.lazyz.jmh.PictureCheck;
import dev.lazyz.jmh.peers.TriangleSource;
import dev.lazyz.jmh.report.JsonRecords;
import dev.lazyz.jmh.report.Options;
import dev.lazyz.jmh.workload.SteadyState;
import dev.lazyz.jmh.workload.Triangles;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.time.Duration;
import java.util.Arrays;
import java.util.Set;

/**
 * Measures the stages of one scene in this process, and prints each result on a line: its kind, and JSON.
 * {@link StageTable} starts it.
 *
 * <p>A frame is that of {@code PeerRun}: the same triangles, {@code scene.frame(raster)} and a rendering into a sink that
 * drops the rows. First the frames are timed, then they are recorded, and at the end the picture is compared with
 * another strategy's: if it differs, nothing is printed.
 */
final class StageRun {
    private static final Set<String> OPTIONS = Set.of("scene", "side", "warm-up", "measure", "record");

    /** The strategy that draws the picture for comparison. It shades only what is visible. */
    private static final String OTHER = "hybrid";

    private static final int LEAST_FRAMES = 5;
    private static final Duration PERIOD = Duration.ofMillis(1);

    private final Scene scene;
    private final Raster raster;
    private final Renderer renderer = PictureCheck.renderer("tiled").configured(new RenderOptions().withThreads(1));
    private final DroppedRows rows = new DroppedRows();
    private double setUp;

    private StageRun(Scene scene, int side) {
        this.scene = scene;
        raster = new Raster(side, side, Rgba.TRANSPARENT);
    }

    /** Without {@code --scene} measures the machine. Other options: see {@link StageTable}. */
    public static void main(String[] args) throws InterruptedException, IOException {
        Options options = new Options(args, OPTIONS);
        String name = options.get("scene", "");
        if (name.isEmpty()) {
            print("machine", Machine.measure(StageResults.jvm()));
            return;
        }
        int side = Integer.parseInt(options.get("side", "1024"));
        Triangles triangles = TriangleSource.find(name);
        StageRun run = new StageRun(triangles.scene(), side);
        SteadyState.await(seconds(options, "warm-up"), run::frame);
        double[] times = new double[1 << 16];
        double[] setUps = new double[times.length];
        int frames = 0;
        long end = System.nanoTime() + (long) (1e9 * seconds(options, "measure"));
        while (frames < times.length && (frames < LEAST_FRAMES || System.nanoTime() < end)) {
            times[frames] = run.frame();
            setUps[frames++] = run.setUp;
        }
        double length = seconds(options, "record");
        Profile profile = Profile.of(PERIOD, () -> run.frames(length));
        PictureCheck.verify(run.scene.frame(run.raster), run.renderer, OTHER);

        String label = TriangleSource.label(name);
        double median = median(times, frames);
        double setUpMedian = median(setUps, frames);
        String jvm = StageResults.jvm();
        print(
                "frame",
                new StageResults.FrameTime(
                        jvm, label, side, rounded(median), rounded(setUpMedian), frames, profile.samples()));
        for (Stage stage : Stage.values()) {
            double time = profile.time(stage, setUpMedian, median - setUpMedian);
            print("stage", new StageResults.StageTime(jvm, label, side, stage.label(), rounded(time)));
        }
        print("counts", FrameCounts.of(label, triangles, side, run.renderer));
        profile.unknown().forEach(type -> System.err.println("no rule in StageMap for " + type));
    }

    private static double seconds(Options options, String name) {
        return Double.parseDouble(options.get(name, "1"));
    }

    private static void print(String kind, Record result) {
        System.out.println(kind + " " + JsonRecords.of(result));
    }

    /** Renders for some seconds. */
    private void frames(double seconds) throws InterruptedException, IOException {
        long end = System.nanoTime() + (long) (1e9 * seconds);
        while (System.nanoTime() < end) {
            frame();
        }
    }

    /** Returns the time of a frame, milliseconds, and stores that of its set-up. */
    private double frame() throws InterruptedException, IOException {
        long start = System.nanoTime();
        var frame = scene.frame(raster);
        setUp = (System.nanoTime() - start) / 1e6;
        if (renderer.render(frame, rows).getPrimitives() == 0) {
            throw new IllegalStateException("nothing was rendered");
        }
        return (System.nanoTime() - start) / 1e6;
    }

    private static double median(double[] values, int count) {
        Arrays.sort(values, 0, count);
        return values[count / 2];
    }

    /** Returns {@code milliseconds} with four decimals. */
    private static double rounded(double milliseconds) {
        return Math.rint(1e4 * milliseconds) / 1e4;
    }
}
