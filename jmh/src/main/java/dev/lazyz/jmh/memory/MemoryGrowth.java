package dev.lazyz.jmh.memory;

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
 * <p>Options: {@code --jar}, that of zcli; {@code --page}; {@code --charts}, the folder of charts; {@code --axis}, pixels
 * or triangles, by default both; {@code --seconds}, the longest time of a run.
 */
public final class MemoryGrowth {
    private static final List<Integer> SIDES = List.of(512, 1448, 4096);
    private static final List<Integer> TRIANGLES = List.of(10_000, 60_000, 360_000);

    /** The smallest heap is found to within one part in so many. */
    private static final int PRECISION = 4;

    private static final int LEAST = 4;
    private static final int MOST = 2048;

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
            for (String axis : options.all("axis").isEmpty() ? List.of("pixels", "triangles") : options.all("axis")) {
                boolean isPixels = axis.equals("pixels");
                List<Integer> points = isPixels ? SIDES : TRIANGLES;
                Map<String, List<Integer>> curves = isPixels ? growth.pixels() : growth.triangles();
                String table = table(isPixels ? "side of the picture" : "triangles", points, curves);
                System.out.println(table);
                Path chart = charts.resolve("memory-" + axis + ".png");
                ChartEncoder.saveChart(chart(axis, points, curves), chart.toString(), "png");
                if (Files.exists(page)) {
                    String filled =
                            GeneratedPage.fill(Files.readString(page), name -> name.equals(axis) ? table : null);
                    Files.writeString(page, filled);
                }
            }
        } finally {
            Files.delete(folder.resolve("model.stl"));
            Files.delete(folder.resolve("picture.ppm"));
            Files.delete(folder);
        }
    }

    /** The strategies, each with the options that choose it. */
    private static Map<String, List<String>> contenders() {
        Map<String, List<String>> all = new LinkedHashMap<>();
        Renderers.getBuiltIn().forEach(it -> all.put(it.getId(), List.of("--strategy", it.getId())));
        for (String id : List.of("tiled", "zbuffer", "hybrid")) {
            all.put(id + " --stream", List.of("--strategy", id, "--stream"));
        }
        return all;
    }

    private Map<String, List<Integer>> pixels() throws IOException, InterruptedException {
        Hills.write(folder.resolve("model.stl"), TRIANGLES.get(0));
        Map<String, List<Integer>> curves = new LinkedHashMap<>();
        for (Map.Entry<String, List<String>> contender : contenders().entrySet()) {
            List<Integer> curve = new ArrayList<>();
            for (int side : SIDES) {
                curve.add(least(contender.getValue(), side));
            }
            curves.put(contender.getKey(), curve);
            System.out.println(contender.getKey() + " " + curve);
        }
        return curves;
    }

    private Map<String, List<Integer>> triangles() throws IOException, InterruptedException {
        Map<String, List<Integer>> curves = new LinkedHashMap<>();
        for (int triangles : TRIANGLES) {
            Hills.write(folder.resolve("model.stl"), triangles);
            for (Map.Entry<String, List<String>> contender : contenders().entrySet()) {
                int least = least(contender.getValue(), 512);
                curves.computeIfAbsent(contender.getKey(), key -> new ArrayList<>())
                        .add(least);
                System.out.println(triangles + " triangles, " + contender.getKey() + " " + least);
            }
        }
        return curves;
    }

    /** Returns the smallest heap that is enough, mebibytes, or 0 if none is. */
    private int least(List<String> contender, int side) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of(folder.resolve("model.stl").toString()));
        words.addAll(contender);
        words.addAll(List.of("--shading", "flat", "--aa", "1", "--size", String.valueOf(side)));
        words.addAll(List.of("-o", folder.resolve("picture.ppm").toString()));
        int enough = LEAST;
        while (enough <= MOST && !isEnough(enough, words)) {
            enough *= 2;
        }
        if (enough > MOST) {
            return 0;
        }
        int tooLittle = enough / 2;
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
        chart.getStyler().setYAxisMax(1000.0);
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
