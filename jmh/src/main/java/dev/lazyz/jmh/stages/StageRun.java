package dev.lazyz.jmh.stages;

import dev.lazyz.Frame;
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
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Set;

/**
 * Measures the stages of one scene in this process, and prints each result on a line: its kind, and JSON.
 * {@link StageTable} starts it.
 *
 * <p>A frame is that of {@code PeerRun}: the same triangles, {@code scene.frame(raster)} and a rendering into a sink
 * that drops the rows. First the frames are timed, then they are recorded, and at the end the picture is compared with
 * another strategy's: if it differs, nothing is printed.
 */
final class StageRun {
    private static final Set<String> OPTIONS = Set.of("scene", "side", "warm-up", "measure", "record", "methods");

    /** The strategy that draws the picture for comparison. It shades only what is visible. */
    private static final String OTHER = "hybrid";

    private static final int LEAST_FRAMES = 5;

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private final Scene scene;
    private final Raster raster;
    private final Renderer renderer = PictureCheck.renderer("tiled").configured(new RenderOptions().withThreads(1));
    private final DroppedRows rows = new DroppedRows();

    /** The time of the last frame's set-up, milliseconds. */
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
        long recordStart = THREADS.getCurrentThreadCpuTime();
        Profile profile = Profile.of(() -> run.frames(length));
        double recorded = (THREADS.getCurrentThreadCpuTime() - recordStart) / 1e6;
        PictureCheck.verify(run.scene.frame(run.raster), run.renderer, OTHER);

        String label = TriangleSource.label(name);
        Arrays.sort(times, 0, frames);
        Arrays.sort(setUps, 0, frames);
        double time = times[0];
        double setUpTime = setUps[0];
        String jvm = StageResults.jvm();
        print(
                "frame",
                new StageResults.FrameTime(
                        jvm,
                        label,
                        side,
                        rounded(time),
                        rounded(setUpTime),
                        rounded(times[frames / 2]),
                        frames,
                        profile.samples(),
                        rounded(profile.samples() / recorded)));
        for (Stage stage : Stage.values()) {
            double part = profile.time(stage, setUpTime, time - setUpTime);
            print("stage", new StageResults.StageTime(jvm, label, side, stage.label(), rounded(part)));
        }
        print("counts", FrameCounts.of(label, triangles, side, run.renderer));
        profile.methods(Integer.parseInt(options.get("methods", "0"))).forEach(System.err::println);
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

    /**
     * Renders a frame; returns the time of this thread on its processor, milliseconds. Unlike the time by the clock, it
     * does not contain what other programs take.
     */
    private double frame() throws InterruptedException, IOException {
        long start = THREADS.getCurrentThreadCpuTime();
        Frame frame = scene.frame(raster);
        long middle = THREADS.getCurrentThreadCpuTime();
        if (renderer.render(frame, rows).getPrimitives() == 0) {
            throw new IllegalStateException("nothing was rendered");
        }
        long end = THREADS.getCurrentThreadCpuTime();
        setUp = (middle - start) / 1e6;
        return (end - start) / 1e6;
    }

    /** Returns {@code milliseconds} with four decimals. */
    private static double rounded(double milliseconds) {
        return Math.rint(1e4 * milliseconds) / 1e4;
    }
}
