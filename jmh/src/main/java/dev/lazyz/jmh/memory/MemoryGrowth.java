package dev.lazyz.jmh.memory;

import dev.lazyz.Renderer;
import dev.lazyz.StreamingRenderer;
import dev.lazyz.jmh.large.Hills;
import dev.lazyz.jmh.report.Charts;
import dev.lazyz.jmh.report.Measurements;
import dev.lazyz.jmh.report.Options;
import dev.lazyz.strategies.Renderers;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Finds the smallest heap, {@code -Xmx}, with which each strategy renders a picture, by bisection, while the picture or
 * the number of triangles grows. Writes a file of results, and draws charts.
 *
 * <p>{@code java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.memory.MemoryGrowth}
 *
 * <p>Options: {@code --jar}, that of zcli; {@code --results}, a file; {@code --charts}, the folder of charts;
 * {@code --axis}, pixels or triangles, by default both; {@code --seconds}, the longest time of a run. A run that takes
 * longer counts as one without enough memory.
 */
public final class MemoryGrowth {
    private static final List<Integer> SIDES = List.of(512, 1448, 4096);
    private static final List<Integer> TRIANGLES = List.of(10_000, 60_000, 360_000, 2_160_000);

    /** The smallest heap is found to within one part in so many. */
    private static final int PRECISION = 4;

    /** Where the search begins. */
    private static final int FIRST = 12;

    private static final int MOST = 4096;

    /** The quantity that is found. */
    private static final String HEAP = "heap MiB";

    private final Path jar;
    private final int seconds;
    private final Path folder;

    private MemoryGrowth(Path jar, int seconds, Path folder) {
        this.jar = jar;
        this.seconds = seconds;
        this.folder = folder;
    }

    public static void main(String[] args) throws IOException, InterruptedException {
        Options options = new Options(args, Set.of("jar", "results", "charts", "axis", "seconds"));
        Path folder = Files.createTempDirectory("memory-growth");
        MemoryGrowth growth = new MemoryGrowth(
                Path.of(options.get("jar", "cli/target/zcli.jar")),
                Integer.parseInt(options.get("seconds", "40")),
                folder);
        Measurements heaps = new Measurements();
        heaps.noteMachine();
        Path charts = Path.of(options.get("charts", "docs/images"));
        try {
            for (String axis : options.list("axis", "pixels,triangles")) {
                for (Map.Entry<String, List<String>> contender : contenders().entrySet()) {
                    growth.measure(axis, contender.getKey(), contender.getValue(), heaps);
                }
                chart(axis, heaps, charts.resolve("memory-" + axis + ".png"));
            }
        } finally {
            Files.deleteIfExists(folder.resolve("model.stl"));
            Files.deleteIfExists(folder.resolve("picture.ppm"));
            Files.delete(folder);
        }
        heaps.write(Path.of(options.get("results", "docs/memory/heaps.csv")));
    }

    /** Returns the values along an axis; none if there is no such axis. */
    private static List<Integer> points(String axis) {
        return switch (axis) {
            case "pixels" -> SIDES;
            case "triangles" -> TRIANGLES;
            default -> List.of();
        };
    }

    private static String subject(String axis, int point) {
        return axis + " " + point;
    }

    /** The strategies, each with the options that choose it; those that can read a model part by part also do that. */
    private static Map<String, List<String>> contenders() {
        Map<String, List<String>> all = new LinkedHashMap<>();
        for (Renderer renderer : Renderers.getBuiltIn()) {
            String id = renderer.getId();
            all.put(id, List.of("--strategy", id));
            if (renderer instanceof StreamingRenderer) {
                all.put(id + " --stream", List.of("--strategy", id, "--stream"));
            }
        }
        return all;
    }

    /** Finds the smallest heap at each point of an axis with which there is one. */
    private void measure(String axis, String name, List<String> contender, Measurements heaps)
            throws IOException, InterruptedException {
        int last = FIRST;
        for (int point : points(axis)) {
            boolean isSide = axis.equals("pixels");
            Hills.write(folder.resolve("model.stl"), isSide ? TRIANGLES.get(0) : point, "stl");
            last = least(contender, isSide ? point : SIDES.get(0), last);
            if (last == 0) {
                return;
            }
            heaps.add(HEAP, subject(axis, point), name, 0, last);
        }
    }

    /**
     * Returns the smallest heap that is enough, mebibytes, or 0 if none is. It is about {@code last}.
     */
    private int least(List<String> contender, int side, int last) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of(folder.resolve("model.stl").toString()));
        words.addAll(contender);
        words.addAll(List.of("--shading", "flat", "--aa", "1", "--size", String.valueOf(side)));
        words.addAll(List.of("-o", folder.resolve("picture.ppm").toString()));
        int tooLittle = last * 3 / 4;
        int enough = last;
        while (enough <= MOST && !isEnough(enough, words)) {
            tooLittle = enough;
            enough *= 2;
        }
        if (enough > MOST) {
            return 0;
        }
        while (enough - tooLittle > Math.max(1, enough / PRECISION)) {
            int middle = (enough + tooLittle) / 2;
            if (isEnough(middle, words)) {
                enough = middle;
            } else {
                tooLittle = middle;
            }
        }
        return enough;
    }

    private boolean isEnough(int mebibytes, List<String> words) throws IOException, InterruptedException {
        return ForkedRendering.run(jar, List.of("-XX:+UseSerialGC"), mebibytes, words, seconds)
                        .code()
                == 0;
    }

    private static void chart(String axis, Measurements heaps, Path file) throws IOException {
        boolean isPixels = axis.equals("pixels");
        Map<String, List<double[]>> curves = new LinkedHashMap<>();
        for (String name : heaps.programs(HEAP)) {
            List<double[]> curve = new ArrayList<>();
            for (int point : points(axis)) {
                heaps.median(HEAP, subject(axis, point), name).ifPresent(heap -> curve.add(new double[] {point, heap}));
            }
            curves.put(name, curve);
        }
        String title = isPixels ? "side of the picture" : "number of triangles";
        Charts.curves(file, "Smallest heap by " + title, title, "smallest -Xmx, MiB", curves);
    }
}
