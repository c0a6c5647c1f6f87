package dev.lazyz.jmh.large;

import dev.lazyz.Counters;
import dev.lazyz.Frame;
import dev.lazyz.Image;
import dev.lazyz.Raster;
import dev.lazyz.jmh.report.Options;
import dev.lazyz.scenes.LoadLimits;
import dev.lazyz.scenes.LoadOptions;
import dev.lazyz.scenes.StreamedScene;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.strategies.tiled.TiledRenderer;
import dev.lazyz.strategies.zbuffer.ZBufferRenderer;
import dev.lazyz.world.Scene;
import dev.lazyz.world.surface.Mesh;
import dev.lazyz.world.surface.StreamedMesh;
import dev.lazyz.world.surface.StreamedMesh.MeshSource;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * Renders a file that is larger than memory, and compares the time with a plain loop over its numbers, and the picture
 * with that of the same triangles: rendered in pieces and merged, or, if vertices are shared, in memory. Each step has
 * a process of its own.
 *
 * <p>{@code java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.large.LargeModel --triangles 100000000 --heap 256m}
 *
 * <p>Other options: {@code --format}, {@code stl} and {@code ply}, which are binary, {@code ply-text} or {@code obj};
 * {@code --side}, the side of the picture, 1024 samples; {@code --rounds}, 2; {@code --folder}, where
 * the file is written and deleted, by default that of temporary files; {@code --pieces no}, without the comparison of
 * pictures.
 */
public final class LargeModel {
    /** Parts of a file that are rendered at a time: a million triangles. */
    private static final int PARTS = 1024;

    private LargeModel() {}

    public static void main(String[] args) throws IOException, InterruptedException {
        if (args.length == 3) {
            System.out.println(step(args[0], Path.of(args[1]), Integer.parseInt(args[2])));
            return;
        }
        Options options =
                new Options(args, Set.of("triangles", "format", "heap", "side", "rounds", "folder", "pieces"));
        int triangles = Integer.parseInt(options.get("triangles", "10000000"));
        String heap = "-Xmx" + options.get("heap", "256m");
        String side = options.get("side", "1024");
        Path folder = Path.of(options.get("folder", System.getProperty("java.io.tmpdir")));
        String format = options.get("format", "stl");
        Path file = Files.createTempFile(folder, "hills", "." + format.replace("-text", ""));
        try {
            int written = Hills.write(file, triangles, format);
            System.out.printf(
                    Locale.ROOT,
                    "%,d triangles, %,d bytes, %s, %s x %s samples%n",
                    written,
                    Files.size(file),
                    heap,
                    side,
                    side);
            for (int round = 0; round < Integer.parseInt(options.get("rounds", "2")); round++) {
                System.out.println("plain loop   " + run(heap, "plain-" + format, file, side));
                System.out.println("streamed     " + run(heap, "stream", file, side));
            }
            if (!options.get("pieces", "yes").equals("no")) {
                if (format.equals("stl")) {
                    System.out.println("in pieces    " + run("-Xmx2g", "pieces", file, side));
                } else {
                    System.out.println("in memory    " + run("-Xmx6g", "whole", file, side));
                }
            }
        } finally {
            Files.delete(file);
        }
    }

    private static String run(String heap, String step, Path file, String side)
            throws IOException, InterruptedException {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        String classPath = System.getProperty("java.class.path");
        List<String> words = List.of(
                java,
                heap,
                "--add-modules",
                "jdk.incubator.vector",
                "-cp",
                classPath,
                LargeModel.class.getName(),
                step,
                file.toString(),
                side);
        Process process =
                new ProcessBuilder(words).redirectError(new File("/dev/null")).start();
        String text = new String(process.getInputStream().readAllBytes()).strip();
        if (process.waitFor() != 0) {
            throw new IOException(step + " failed with code " + process.exitValue() + ": " + text);
        }
        return text;
    }

    private static String step(String step, Path file, int side) throws IOException, InterruptedException {
        switch (step) {
            case "plain-stl":
                return plain(PlainLoop::stl, file);
            case "plain-ply":
                return plain(PlainLoop::ply, file);
            case "plain-obj":
            case "plain-ply-text":
                return plain(PlainLoop::text, file);
            case "whole":
                return whole(file, side);
            case "stream":
                return stream(file, side);
            case "pieces":
                return pieces(file, side);
            default:
                throw new IllegalArgumentException(step);
        }
    }

    private interface Loop {
        double least(Path file) throws IOException;
    }

    private static String plain(Loop loop, Path file) throws IOException {
        long start = System.nanoTime();
        double least = loop.least(file);
        return seconds(start) + ", least number " + least;
    }

    /** Renders the whole model in memory. */
    private static String whole(Path file, int side) throws IOException, InterruptedException {
        long start = System.nanoTime();
        LoadOptions flat = new LoadOptions(new LoadLimits(), null, false);
        Frame frame = Scenes.load(file, flat).getScene().frame(side, side);
        String loaded = seconds(start);
        Image image = new TiledRenderer().render(frame);
        return seconds(start) + " (loaded after " + loaded + "), " + image.pixelHash();
    }

    private static String stream(Path file, int side) throws IOException, InterruptedException {
        long start = System.nanoTime();
        try (StreamedScene streamed = Scenes.stream(file)) {
            String opened = seconds(start);
            Frame frame = streamed.getLoaded().getScene().frame(side, side);
            String framed = seconds(start);
            Image image = new TiledRenderer().render(frame);
            return seconds(start) + " (opened after " + opened + ", camera after " + framed + "), "
                    + counters(image.getCounters()) + image.pixelHash();
        }
    }

    private static String counters(Counters counters) {
        return String.format(Locale.ROOT, "%,d shading calls, ", counters.getShadingCalls());
    }

    /** Renders a million triangles at a time as ordinary scenes, and keeps the nearest fragments. */
    private static String pieces(Path file, int side) throws IOException, InterruptedException {
        long start = System.nanoTime();
        try (StreamedScene streamed = Scenes.stream(file)) {
            Scene whole = streamed.getLoaded().getScene();
            Raster raster = new Raster(side, side, whole.getBackground());
            MeshSource source = ((StreamedMesh) whole.getSurfaces().get(0)).getSource();
            Scene seen = whole.withViewpoint(whole.camera(side, side));
            int[] colors = new int[side * side];
            int[] depths = new int[side * side];
            Arrays.fill(colors, raster.getBackground().toArgb());
            Arrays.fill(depths, raster.getBackgroundDepth());
            for (int first = 0; first < source.getPartCount(); first += PARTS) {
                Mesh mesh = source.read(first, Math.min(PARTS, source.getPartCount() - first));
                Frame piece = seen.withSurfaces(List.of(mesh)).frame(raster);
                new ZBufferRenderer().render(piece, (y, argb, depth, primitive) -> {
                    for (int x = 0; x < side; x++) {
                        // Where depths are equal, the earlier piece has the smaller submission index
                        if (depth[x] < depths[y * side + x]) {
                            depths[y * side + x] = depth[x];
                            colors[y * side + x] = argb[x];
                        }
                    }
                });
            }
            Image.Collector collector = new Image.Collector(raster.getRegion());
            for (int y = 0; y < side; y++) {
                int[] row = Arrays.copyOfRange(colors, y * side, (y + 1) * side);
                collector.row(y, row, row, row);
            }
            return seconds(start) + ", "
                    + collector.toImage(new Counters.Builder().build()).pixelHash();
        }
    }

    private static String seconds(long start) {
        return String.format(Locale.ROOT, "%.1f s", (System.nanoTime() - start) / 1e9);
    }
}
