package dev.lazyz.jmh.growth;

import dev.lazyz.jmh.report.Charts;
import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.jmh.report.Measurements;
import dev.lazyz.strategies.FrameNumbers;
import dev.lazyz.strategies.Renderers.StrategyEstimates;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;

/**
 * Writes the tables of {@code docs/growth.md}, its charts, and the coefficients of
 * {@link dev.lazyz.strategies.StrategyModel}, from the results of {@link Growth}.
 */
public final class GrowthPage {
    /** Path of the file with the model's coefficients, relative to the project's folder. */
    static final String COSTS = "core/src/main/kotlin/dev/lazyz/strategies/StrategyCosts.kt";

    /** The model's choice counts as good if its time is at most this factor times the time of the fastest strategy. */
    static final double TOLERANCE = 1.5;

    /** Axes along which something grows for all strategies. */
    private static final List<GrowthAxis> CURVES =
            List.of(GrowthAxis.TRIANGLES, GrowthAxis.PIXELS, GrowthAxis.SMALL, GrowthAxis.DEPTH, GrowthAxis.SHADING);

    final ModelFit fit;
    private final Measurements results;

    GrowthPage(Measurements results) {
        this.results = results;
        this.fit = new ModelFit(results);
    }

    /**
     * Three arguments: the page, the results file, whose folder also receives the charts, and the file of
     * coefficients.
     */
    public static void main(String[] args) throws IOException {
        if (args.length != 3) {
            throw new IllegalArgumentException("give the page, the file of results, and the file of coefficients");
        }
        Path file = Path.of(args[1]);
        GrowthPage page = new GrowthPage(Measurements.read(file));
        Files.writeString(Path.of(args[2]), page.fit.toKotlin());
        GeneratedPage.update(Path.of(args[0]), page::section);
        page.writeCharts(file.toAbsolutePath().getParent());
    }

    /** Returns a table of the page by its name. */
    String section(String name) {
        return switch (name) {
            case "summary" -> summary();
            case "choices" ->
                "The model's choice takes at most " + TOLERANCE + " times as long as the fastest at " + good(false)
                        + " of " + choices(false) + " points; if `tiled` is left out, at " + good(true) + " of "
                        + choices(true) + ".\n";
            default -> throw new IllegalArgumentException("no table '" + name + "'");
        };
    }

    /** Returns the table of a large frame for each quantity that grows, and how often {@code tiled} is the fastest. */
    private String summary() {
        List<String> head = List.of(
                "strategy",
                "1,000,000 triangles, ms",
                "4096 x 4096 pixels, ms",
                "the same, working memory",
                "1,000 layers, ms",
                "1,000 rounds of shading, ms");
        List<List<String>> rows = new ArrayList<>();
        for (String strategy : fit.strategies()) {
            rows.add(List.of(
                    strategy,
                    GeneratedPage.time(time(new Point(GrowthAxis.TRIANGLES, 1_000_000), strategy)),
                    GeneratedPage.time(time(new Point(GrowthAxis.PIXELS, 4096L * 4096), strategy)),
                    GeneratedPage.bytes(results.median(Growth.PEAK, GrowthAxis.PIXELS.subject(4096L * 4096), strategy)),
                    GeneratedPage.time(time(new Point(GrowthAxis.DEPTH, 1_000), strategy)),
                    GeneratedPage.time(time(new Point(GrowthAxis.SHADING, 1_000), strategy))));
        }
        List<Point> compared =
                points().stream().filter(point -> measured(point).size() > 1).toList();
        long best = compared.stream()
                .filter(point -> fastest(point, measured(point)).equals("tiled"))
                .count();
        return GeneratedPage.table(head, rows) + "\n`tiled` is the fastest in " + best + " of " + compared.size()
                + " measured frames. " + GeneratedPage.source(results);
    }

    private void writeCharts(Path folder) throws IOException {
        for (GrowthAxis axis : CURVES) {
            chart(folder.resolve(axis.id() + "-time.png"), "Time of a frame", "ms", axis, Growth.TIME);
            chart(folder.resolve(axis.id() + "-memory.png"), "Working memory", "bytes", axis, Growth.PEAK);
        }
    }

    private void chart(Path file, String title, String unit, GrowthAxis axis, String quantity) throws IOException {
        Map<String, List<double[]>> curves = new LinkedHashMap<>();
        for (String strategy : fit.strategies()) {
            curves.put(strategy, Curve.of(results, quantity, axis, strategy).points());
        }
        if (curves.values().stream().anyMatch(curve -> !curve.isEmpty())) {
            Charts.curves(file, title + " by " + axis.title, axis.title, unit, curves);
        }
    }

    /** A value on an axis. */
    private record Point(GrowthAxis axis, long value) {}

    private List<Point> points() {
        List<Point> points = new ArrayList<>();
        for (GrowthAxis axis : GrowthAxis.values()) {
            axis.first(axis.values.length).forEach(value -> points.add(new Point(axis, value)));
        }
        return points;
    }

    private OptionalDouble time(Point point, String strategy) {
        return results.median(Growth.TIME, point.axis.subject(point.value), strategy);
    }

    /** Returns the strategies that have a time at a point. */
    private List<String> measured(Point point) {
        return fit.strategies().stream()
                .filter(strategy -> time(point, strategy).isPresent())
                .toList();
    }

    /** Returns the number of points at which the model's choice is good, with or without {@code tiled}. */
    long good(boolean isWithoutTiled) {
        return points().stream()
                .map(point -> loss(point, isWithoutTiled))
                .filter(loss -> loss.isPresent() && loss.getAsDouble() <= TOLERANCE)
                .count();
    }

    /** Returns the number of points that have strategies to choose from. */
    long choices(boolean isWithoutTiled) {
        return points().stream()
                .filter(point -> loss(point, isWithoutTiled).isPresent())
                .count();
    }

    /** Returns the time of the model's choice divided by that of the fastest; empty if there is nothing to choose. */
    private OptionalDouble loss(Point point, boolean isWithoutTiled) {
        List<String> strategies = measured(point).stream()
                .filter(strategy -> !isWithoutTiled || !strategy.equals("tiled"))
                .toList();
        if (strategies.isEmpty()) {
            return OptionalDouble.empty();
        }
        return OptionalDouble.of(time(point, chosen(point, strategies)).orElseThrow()
                / time(point, fastest(point, strategies)).orElseThrow());
    }

    private String fastest(Point point, List<String> strategies) {
        return least(strategies, strategy -> time(point, strategy).orElseThrow());
    }

    /** Returns the strategy that {@link StrategyEstimates#getBest} would return. */
    private String chosen(Point point, List<String> strategies) {
        FrameNumbers numbers = Curve.numbers(results, point.axis, point.value);
        String preferred = strategies.get(0);
        String fastest = least(strategies, strategy -> fit.milliseconds(strategy, numbers));
        boolean isMuchFaster =
                fit.milliseconds(preferred, numbers) > StrategyEstimates.MARGIN * fit.milliseconds(fastest, numbers);
        return isMuchFaster ? fastest : preferred;
    }

    private static String least(List<String> strategies, ToDoubleFunction<String> cost) {
        return strategies.stream().min(Comparator.comparingDouble(cost)).orElseThrow();
    }
}
