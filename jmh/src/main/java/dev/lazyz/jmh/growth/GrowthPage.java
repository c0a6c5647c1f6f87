package dev.lazyz.jmh.growth;

import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.strategies.StrategyEstimates;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * Writes the tables of {@code docs/growth.md} and {@code docs/growth-tables.md}, their charts, and the coefficients of
 * {@link dev.lazyz.strategies.StrategyModel}, from the results of {@link Growth}.
 */
public final class GrowthPage {
    /** Path of the file with the model's coefficients, relative to the project's folder. */
    static final String COSTS = "core/src/main/kotlin/dev/lazyz/strategies/StrategyCosts.kt";

    /** The model's choice counts as good if its time is at most this factor times the time of the fastest strategy. */
    static final double TOLERANCE = 1.5;

    /** Times that differ by less than this factor are considered equal. */
    private static final double SAME = 1.2;

    /** Pairs of strategies whose times are compared along each axis. */
    private static final List<List<String>> PAIRS = List.of(
            List.of("zbuffer", "hybrid"),
            List.of("zbuffer", "lazy"),
            List.of("zbuffer", "hierarchical"),
            List.of("zbuffer", "scanline"),
            List.of("scanline", "warnock"),
            List.of("lazy", "flow"),
            List.of("tiled", "scanline"),
            List.of("tiled", "zbuffer"));

    private final GrowthResults results;
    private final ModelFit fit;

    GrowthPage(GrowthResults results) {
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
        Path page = Path.of(args[0]);
        Path file = Path.of(args[1]);
        GrowthResults results = GrowthResults.read(file);
        Files.writeString(Path.of(args[2]), new ModelFit(results).toKotlin());
        GeneratedPage.update(page, new GrowthPage(results)::fill);
        new GrowthCharts(results).write(file.toAbsolutePath().getParent());
    }

    /**
     * Returns the page with updated tables.
     *
     * @throws IllegalArgumentException if a table has no end or an unknown name
     */
    String fill(String page) {
        return GeneratedPage.fill(page, this::section);
    }

    private String section(String name) {
        if (name.equals("facts")) {
            List<List<String>> rows = new ArrayList<>();
            results.facts().forEach((fact, value) -> rows.add(List.of(fact, value)));
            return GeneratedPage.table(List.of("fact", "value"), rows);
        }
        if (name.equals("summary")) {
            return summary();
        }
        if (name.equals("crossings")) {
            return crossings();
        }
        if (name.equals("choices")) {
            return choices();
        }
        if (name.equals("accuracy")) {
            return accuracy();
        }
        for (Axis axis : Axis.values()) {
            for (Quantity quantity : Quantity.values()) {
                if (name.equals(axis.id() + " " + quantity.id())) {
                    return curves(axis, quantity);
                }
            }
        }
        throw new IllegalArgumentException("no table '" + name + "'");
    }

    /** Returns the table of a large frame for each quantity that grows, and how often {@code tiled} is the fastest. */
    private String summary() {
        List<Key> keys = List.of(
                new Key(Axis.TRIANGLES, 1_000_000, Quantity.TIME, "1,000,000 triangles, ms"),
                new Key(Axis.PIXELS, 4096L * 4096, Quantity.TIME, "4096 x 4096 pixels, ms"),
                new Key(Axis.PIXELS, 4096L * 4096, Quantity.PEAK, "the same, working memory"),
                new Key(Axis.DEPTH, 1_000, Quantity.TIME, "1,000 layers, ms"),
                new Key(Axis.SHADING, 1_000, Quantity.TIME, "1,000 rounds of shading, ms"));
        List<String> head = new ArrayList<>(List.of("strategy"));
        keys.forEach(key -> head.add(key.title));
        List<List<String>> rows = new ArrayList<>();
        for (String strategy : results.strategies()) {
            List<String> row = new ArrayList<>(List.of(strategy));
            keys.forEach(key -> row.add(cell(key, strategy)));
            rows.add(row);
        }
        List<GrowthResults.Point> compared = results.points().stream()
                .filter(point -> measured(point).size() > 1)
                .toList();
        long best = compared.stream()
                .filter(point -> fastest(point, measured(point)).equals("tiled"))
                .count();
        return GeneratedPage.table(head, rows) + "\n`tiled` is the fastest in " + best + " of " + compared.size()
                + " measured frames. Measured on " + results.facts().getOrDefault("date", "") + ", "
                + results.facts().getOrDefault("processor", "") + ".\n";
    }

    private String cell(Key key, String strategy) {
        return results.points(key.axis).stream()
                .filter(point -> point.value() == key.value)
                .findFirst()
                .map(point -> {
                    OptionalDouble median = results.median(point, strategy, key.quantity.of);
                    return median.isPresent() ? key.quantity.text(median.getAsDouble()) : gap(point, strategy);
                })
                .orElse("");
    }

    /** A column of the summary. */
    private record Key(Axis axis, long value, Quantity quantity, String title) {}

    private String curves(Axis axis, Quantity quantity) {
        List<GrowthResults.Point> points = results.points(axis);
        List<String> head = new ArrayList<>(List.of(axis.title));
        points.forEach(point -> head.add(axis.label(point.value())));
        boolean isCurve = axis != Axis.SCENES;
        if (isCurve) {
            head.addAll(List.of("theory", "slope", "at the end"));
        }
        List<List<String>> rows = new ArrayList<>();
        for (String strategy : results.strategies(axis)) {
            List<String> row = new ArrayList<>(List.of(strategy));
            for (GrowthResults.Point point : points) {
                OptionalDouble median = results.median(point, strategy, quantity.of);
                row.add(median.isPresent() ? quantity.text(median.getAsDouble()) : gap(point, strategy));
            }
            if (isCurve) {
                row.addAll(growth(axis, quantity, strategy));
            }
            rows.add(row);
        }
        String chart = "\n![" + quantity.title + ", by " + axis.title + "](growth/"
                + GrowthCharts.fileName(axis, quantity) + ")\n\n";
        return GeneratedPage.table(head, rows) + (isCurve ? chart : "");
    }

    private List<String> growth(Axis axis, Quantity quantity, String strategy) {
        List<double[]> curve = results.curve(axis, strategy, quantity);
        Order order = Order.of(axis, quantity, strategy);
        double end = Slope.last(curve);
        return List.of(
                order.text(), slope(Slope.of(curve)), order.isDeparture(end) ? "**" + slope(end) + "**" : slope(end));
    }

    private String gap(GrowthResults.Point point, String strategy) {
        return GrowthResults.MEMORY.equals(results.reason(point, strategy)) ? "no room" : "too slow";
    }

    private static String slope(double slope) {
        return Double.isNaN(slope)
                ? ""
                : String.format(Locale.ROOT, "%.2f", slope).replace("-0.00", "0.00");
    }

    /** Returns the table of the values along each axis at which the faster strategy of a pair changes. */
    private String crossings() {
        List<Axis> axes = new ArrayList<>(List.of(Axis.values()));
        axes.removeAll(List.of(Axis.THREADS, Axis.SCENES));
        List<String> head = new ArrayList<>(List.of("faster"));
        axes.forEach(axis -> head.add(axis.title));
        List<List<String>> rows = new ArrayList<>();
        for (List<String> pair : PAIRS) {
            List<String> row = new ArrayList<>(List.of(pair.get(0) + " or " + pair.get(1)));
            axes.forEach(axis -> row.add(crossing(axis, pair.get(0), pair.get(1))));
            rows.add(row);
        }
        return GeneratedPage.table(head, rows);
    }

    private String crossing(Axis axis, String first, String second) {
        StringBuilder text = new StringBuilder();
        double lastValue = 0;
        double lastRatio = 0;
        for (GrowthResults.Point point : results.points(axis)) {
            double ratio = StrictMath.log(time(point, second) / time(point, first));
            if (Double.isNaN(ratio) || Double.isInfinite(ratio) || Math.abs(ratio) < StrictMath.log(SAME)) {
                continue;
            }
            String faster = ratio > 0 ? first : second;
            if (text.length() == 0) {
                text.append(faster);
            } else if (ratio > 0 != lastRatio > 0) {
                // Interpolate linearly on log-log between two points
                double part = lastRatio / (lastRatio - ratio);
                double value =
                        StrictMath.exp(StrictMath.log(lastValue) + part * StrictMath.log(point.value() / lastValue));
                text.append(String.format(Locale.ROOT, ", from %,d %s", rounded(value), faster));
            }
            lastValue = point.value();
            lastRatio = ratio;
        }
        return text.length() == 0 ? "the same" : text.toString();
    }

    private static long rounded(double value) {
        double unit = StrictMath.pow(10, Math.max(0, Math.floor(StrictMath.log10(value)) - 1));
        return Math.round(Math.round(value / unit) * unit);
    }

    /**
     * Returns the table with the fastest strategy and the model's choice at each point: among all strategies, and
     * without tiled.
     */
    private String choices() {
        List<List<String>> rows = new ArrayList<>();
        for (Axis axis : Axis.values()) {
            for (GrowthResults.Point point : results.points(axis)) {
                List<String> all = measured(point);
                List<String> row = new ArrayList<>(List.of(axis.title, axis.label(point.value())));
                row.addAll(choice(point, all));
                row.addAll(choice(point, withoutTiled(all)));
                rows.add(row);
            }
        }
        List<String> head = List.of(
                "axis",
                "value",
                "fastest",
                "the model's choice",
                "times",
                "without tiled",
                "the model's choice",
                "times");
        return GeneratedPage.table(head, rows) + "\nThe model's choice takes at most " + TOLERANCE
                + " times as long as the fastest at " + good(false) + " of " + points(false)
                + " points; if `tiled` is left out, at " + good(true) + " of " + points(true) + ".\n";
    }

    private List<String> choice(GrowthResults.Point point, List<String> strategies) {
        return strategies.isEmpty()
                ? List.of("", "", "")
                : List.of(
                        fastest(point, strategies),
                        chosen(point, strategies),
                        String.format(Locale.ROOT, "%.2f", loss(point, strategies)));
    }

    /** Returns the number of points at which the model's choice is good, with or without {@code tiled}. */
    long good(boolean isWithoutTiled) {
        return results.points().stream()
                .filter(point -> !candidates(point, isWithoutTiled).isEmpty())
                .filter(point -> loss(point, candidates(point, isWithoutTiled)) <= TOLERANCE)
                .count();
    }

    /** Returns the number of points that have candidates to choose from. */
    long points(boolean isWithoutTiled) {
        return results.points().stream()
                .filter(point -> !candidates(point, isWithoutTiled).isEmpty())
                .count();
    }

    private List<String> candidates(GrowthResults.Point point, boolean isWithoutTiled) {
        return isWithoutTiled ? withoutTiled(measured(point)) : measured(point);
    }

    private static List<String> withoutTiled(List<String> strategies) {
        return strategies.stream().filter(strategy -> !strategy.equals("tiled")).toList();
    }

    /** Returns the strategies that have a time at a point. */
    private List<String> measured(GrowthResults.Point point) {
        return results.strategies().stream()
                .filter(strategy -> time(point, strategy) < Double.POSITIVE_INFINITY)
                .toList();
    }

    private String fastest(GrowthResults.Point point, List<String> strategies) {
        return strategies.stream()
                .min(Comparator.comparingDouble(strategy -> time(point, strategy)))
                .orElseThrow();
    }

    /** Returns the strategy that {@link dev.lazyz.strategies.StrategyEstimates#getBest} would return. */
    private String chosen(GrowthResults.Point point, List<String> strategies) {
        String preferred = strategies.get(0);
        String fastest = strategies.stream()
                .min(Comparator.comparingDouble(strategy -> estimate(point, strategy)))
                .orElseThrow();
        return estimate(point, preferred) > StrategyEstimates.MARGIN * estimate(point, fastest) ? fastest : preferred;
    }

    private double estimate(GrowthResults.Point point, String strategy) {
        return fit.milliseconds(strategy, point);
    }

    /** Returns the time of the model's choice divided by the time of the fastest. */
    private double loss(GrowthResults.Point point, List<String> strategies) {
        return time(point, chosen(point, strategies)) / time(point, fastest(point, strategies));
    }

    /** Returns the table of the model's accuracy at the points to which it was fitted: estimate / measured. */
    private String accuracy() {
        List<List<String>> rows = new ArrayList<>();
        for (String strategy : results.strategies()) {
            double[] ratios = results.points().stream()
                    .filter(ModelFit::isFitted)
                    .filter(point -> measured(point).contains(strategy))
                    .mapToDouble(point -> estimate(point, strategy) / time(point, strategy))
                    .sorted()
                    .toArray();
            List<String> row = new ArrayList<>(List.of(strategy));
            for (int quarter = 0; quarter <= 4; quarter++) {
                row.add(String.format(Locale.ROOT, "%.2f", ratios[(ratios.length - 1) * quarter / 4]));
            }
            rows.add(row);
        }
        return GeneratedPage.table(
                List.of("estimate / measured", "least", "first quartile", "median", "third quartile", "greatest"),
                rows);
    }

    /** Returns the time of a strategy at a point, or infinity if it has none. */
    private double time(GrowthResults.Point point, String strategy) {
        return results.median(point, strategy, Quantity.TIME.of).orElse(Double.POSITIVE_INFINITY);
    }
}
