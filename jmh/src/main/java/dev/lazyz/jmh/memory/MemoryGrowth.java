package dev.lazyz.jmh.memory;

import dev.lazyz.Renderer;
import dev.lazyz.StreamingRenderer;
import dev.lazyz.jmh.large.Hills;
import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.jmh.report.Options;
import dev.lazyz.strategies.Renderers;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.knowm.xchart.ChartEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.Styler;

/**
 * Finds the smallest heap, {@code -Xmx}, with which each strategy renders a picture, by bisection, while the picture or
 * the number of triangles grows. Draws charts, and writes tables into a page.
 *
 * <p>{@code java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.memory.MemoryGrowth}
 *
 * <p>Options: {@code --jar}, that of zcli; {@code --page}; {@code --charts}, the folder of charts; {@code --axis},
 * pixels or triangles, by default both; {@code --seconds}, the longest time of a run. A run that takes longer counts as
 * one without enough memory.
 */
public final class MemoryGrowth {
    private static final List<Integer> SIDES = List.of(512, 1448, 4096);
    private static final List<Integer> TRIANGLES = List.of(10_000, 60_000, 360_000, 2_160_000);

    /** The smallest heap is found to within one part in so many. */
    private static final int PRECISION = 4;

    /** Where the search begins. */
    private static final int FIRST = 12;

    private static final int MOST = 4096;

    private final Path jar;
    private final int seconds;
    private final Path folder;

    private MemoryGrowth(Path jar, int seconds, Path folder) {
        this.jar = jar;
        this.seconds = seconds;
        this.folder = folder;
    }

    public static void main(String[] args) throws IOException, InterruptedException {
        Options options = new Options(args, Set.of("jar", "page", "charts", "axis", "seconds"));
        Path folder = Files.createTempDirectory("memory-growth");
        MemoryGrowth growth = new MemoryGrowth(
                Path.of(options.get("jar", "cli/target/zcli.jar")),
                Integer.parseInt(options.get("seconds", "40")),
                folder);
        Path page = Path.of(options.get("page", "docs/memory.md"));
        Path charts = Path.of(options.get("charts", "docs/images"));
        try {
            for (String axis : options.list("axis", "pixels,triangles")) {
                boolean isPixels = axis.equals("pixels");
                List<Integer> points = isPixels ? SIDES : TRIANGLES;
                Map<String, List<Integer>> curves = new LinkedHashMap<>();
                for (Map.Entry<String, List<String>> contender : contenders().entrySet()) {
                    List<Integer> curve =
                            isPixels ? growth.pixels(contender.getValue()) : growth.triangles(contender.getValue());
                    curves.put(contender.getKey(), curve);
                    System.out.println(contender.getKey() + " " + curve);

                    // If a long run is stopped, the results so far are kept
                    write(axis, points, curves, page, charts);
                }
            }
        } finally {
            Files.deleteIfExists(folder.resolve("model.stl"));
            Files.deleteIfExists(folder.resolve("picture.ppm"));
            Files.delete(folder);
        }
    }

    private static void write(
            String axis, List<Integer> points, Map<String, List<Integer>> curves, Path page, Path charts)
            throws IOException {
        String table = table(axis.equals("pixels") ? "side of the picture" : "triangles", points, curves);
        Path chart = charts.resolve("memory-" + axis + ".png");
        ChartEncoder.saveChart(chart(axis, points, curves), chart.toString(), "png");
        if (Files.exists(page)) {
            String filled = GeneratedPage.fill(Files.readString(page), name -> name.equals(axis) ? table : null);
            Files.writeString(page, filled);
        }
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

    private List<Integer> pixels(List<String> contender) throws IOException, InterruptedException {
        Hills.write(folder.resolve("model.stl"), TRIANGLES.get(0));
        List<Integer> curve = new ArrayList<>();
        for (int side : SIDES) {
            curve.add(least(contender, side, curve));
        }
        return curve;
    }

    private List<Integer> triangles(List<String> contender) throws IOException, InterruptedException {
        List<Integer> curve = new ArrayList<>();
        for (int triangles : TRIANGLES) {
            Hills.write(folder.resolve("model.stl"), triangles);
            curve.add(least(contender, SIDES.get(0), curve));
        }
        return curve;
    }

    /**
     * Returns the smallest heap that is enough, mebibytes, or 0 if none is. It is about that of the point {@code
     * before}.
     */
    private int least(List<String> contender, int side, List<Integer> before) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of(folder.resolve("model.stl").toString()));
        words.addAll(contender);
        words.addAll(List.of("--shading", "flat", "--aa", "1", "--size", String.valueOf(side)));
        words.addAll(List.of("-o", folder.resolve("picture.ppm").toString()));
        int last = before.isEmpty() ? FIRST : before.get(before.size() - 1);
        int tooLittle = last == 0 ? MOST : last * 3 / 4;
        int enough = last == 0 ? MOST : last;
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

    private static String table(String axis, List<Integer> points, Map<String, List<Integer>> curves) {
        List<String> head = new ArrayList<>(List.of(axis));
        points.forEach(point -> head.add(String.format("%,d", point)));
        List<List<String>> rows = new ArrayList<>();
        curves.forEach((name, curve) -> {
            List<String> row = new ArrayList<>(List.of(name));
            curve.forEach(least -> row.add(least == 0 ? "–" : least + " MiB"));
            rows.add(row);
        });
        return GeneratedPage.table(head, rows);
    }

    private static XYChart chart(String axis, List<Integer> points, Map<String, List<Integer>> curves) {
        boolean isPixels = axis.equals("pixels");
        XYChart chart = new XYChartBuilder()
                .width(1000)
                .height(620)
                .title("Smallest heap, by " + (isPixels ? "side of the picture" : "number of triangles"))
                .xAxisTitle(isPixels ? "side of the picture, pixels" : "triangles")
                .yAxisTitle("smallest -Xmx, MiB")
                .build();
        chart.getStyler().setXAxisLogarithmic(true);
        chart.getStyler().setYAxisLogarithmic(true);
        chart.getStyler().setYAxisMin(1.0);
        chart.getStyler().setYAxisMax(10_000.0);
        chart.getStyler().setLegendPosition(Styler.LegendPosition.OutsideE);
        chart.getStyler().setChartBackgroundColor(Color.WHITE);
        curves.forEach((name, curve) -> {
            List<Integer> x = new ArrayList<>();
            List<Integer> y = new ArrayList<>();
            for (int i = 0; i < curve.size(); i++) {
                if (curve.get(i) > 0) {
                    x.add(points.get(i));
                    y.add(curve.get(i));
                }
            }
            if (!x.isEmpty()) {
                chart.addSeries(name, x, y);
            }
        });
        return chart;
    }
}
