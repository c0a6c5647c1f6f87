package dev.lazyz.jmh.growth;

import dev.lazyz.Renderer;
import dev.lazyz.jmh.report.JsonRecords;
import dev.lazyz.strategies.FrameNumbers;
import dev.lazyz.strategies.Renderers;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import kotlinx.serialization.json.JsonObject;

/**
 * Everything that {@link Growth} measured, as it is kept in a JSON file.
 *
 * @param facts machine, versions, settings, command
 * @param points what was rendered
 * @param costs what it took
 * @param missing what was not measured, and why
 */
record GrowthResults(Map<String, String> facts, List<Point> points, List<Cost> costs, List<Missing> missing) {
    /** Why a strategy was not measured: it took too long at this point or at a smaller one. */
    static final String SLOW = "slow";

    /** Why a strategy was not measured: it does not fit into the heap, here or at a smaller point. */
    static final String MEMORY = "memory";

    /**
     * A frame that was rendered.
     *
     * @param axis what grows
     * @param value how far it has grown
     * @param side width and height of the raster, samples
     * @param threads of the renderers
     * @param rounds of shading a sample
     * @param primitives how many
     * @param primitiveRows see {@link FrameNumbers}
     * @param fragments see {@link FrameNumbers}
     */
    record Point(
            String axis,
            long value,
            int side,
            int threads,
            int rounds,
            long primitives,
            double primitiveRows,
            double fragments) {
        /** What the model knows of the frame. */
        FrameNumbers numbers() {
            return new FrameNumbers(side, side, primitives, primitiveRows, fragments, false, Math.max(1, rounds));
        }
    }

    /**
     * One strategy in one round.
     *
     * @param axis what grows
     * @param value how far it has grown
     * @param strategy its id
     * @param round from 1; within one, strategies follow each other closely
     * @param millis wall clock of a frame, set-up included; the median of the round's frames
     * @param frames how many
     * @param allocated bytes allocated in a frame by threads that live on, set-up included
     * @param peak bytes of working memory at its peak, as the renderer tells
     */
    record Cost(
            String axis,
            long value,
            String strategy,
            int round,
            double millis,
            int frames,
            long allocated,
            long peak) {}

    /**
     * A strategy that has no figures at a point.
     *
     * @param reason {@link #SLOW} or {@link #MEMORY}
     */
    record Missing(String axis, long value, String strategy, String reason) {}

    static GrowthResults empty() {
        return new GrowthResults(new TreeMap<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
    }

    /** Returns these results but for some axes. */
    GrowthResults without(List<String> axes) {
        return new GrowthResults(
                new TreeMap<>(facts),
                new ArrayList<>(points.stream()
                        .filter(point -> !axes.contains(point.axis()))
                        .toList()),
                new ArrayList<>(costs.stream()
                        .filter(cost -> !axes.contains(cost.axis()))
                        .toList()),
                new ArrayList<>(missing.stream()
                        .filter(gap -> !axes.contains(gap.axis()))
                        .toList()));
    }

    static GrowthResults read(Path file) throws IOException {
        JsonObject root = JsonRecords.parse(Files.readString(file));
        return new GrowthResults(
                JsonRecords.texts(root, "facts"),
                JsonRecords.records(root, "points", Point.class),
                JsonRecords.records(root, "costs", Cost.class),
                JsonRecords.records(root, "missing", Missing.class));
    }

    void write(Path file) throws IOException {
        Map<String, List<? extends Record>> lists = new LinkedHashMap<>();
        lists.put("points", points);
        lists.put("costs", costs);
        lists.put("missing", missing);
        Files.writeString(file, JsonRecords.write(facts, lists));
    }

    /** Points of an axis, in ascending order. */
    List<Point> points(Axis axis) {
        return points.stream().filter(point -> point.axis().equals(axis.id())).toList();
    }

    /** Strategies that were measured somewhere on an axis, in the order in which they are listed. */
    List<String> strategies(Axis axis) {
        return strategies().stream()
                .filter(strategy -> costs.stream()
                        .anyMatch(cost ->
                                cost.axis().equals(axis.id()) && cost.strategy().equals(strategy)))
                .toList();
    }

    /** All strategies that were measured, in the order in which they are listed. */
    List<String> strategies() {
        Set<String> measured = costs.stream().map(Cost::strategy).collect(Collectors.toSet());
        return Renderers.getBuiltIn().stream()
                .map(Renderer::getId)
                .filter(measured::contains)
                .toList();
    }

    /** Median of the rounds of a strategy at a point. */
    OptionalDouble median(Point point, String strategy, ToDoubleFunction<Cost> quantity) {
        double[] values = costs.stream()
                .filter(cost -> cost.axis().equals(point.axis()) && cost.value() == point.value())
                .filter(cost -> cost.strategy().equals(strategy))
                .mapToDouble(quantity)
                .sorted()
                .toArray();
        return values.length == 0 ? OptionalDouble.empty() : OptionalDouble.of(median(values));
    }

    /** Returns the points (value, median) of a strategy's curve along an axis, as far as they are positive. */
    List<double[]> curve(Axis axis, String strategy, Quantity quantity) {
        List<double[]> curve = new ArrayList<>();
        for (Point point : points(axis)) {
            double median = median(point, strategy, quantity.of).orElse(0);
            if (median > 0) {
                curve.add(new double[] {point.value(), median});
            }
        }
        return curve;
    }

    /** Why a strategy has no figures at a point, or null. */
    String reason(Point point, String strategy) {
        return missing.stream()
                .filter(gap -> gap.axis().equals(point.axis()) && gap.value() == point.value())
                .filter(gap -> gap.strategy().equals(strategy))
                .map(Missing::reason)
                .findFirst()
                .orElse(null);
    }

    /** Median of values in any order. */
    static double median(double[] values) {
        double[] ascending = values.clone();
        Arrays.sort(ascending);
        int middle = ascending.length / 2;
        return ascending.length % 2 == 1 ? ascending[middle] : (ascending[middle - 1] + ascending[middle]) / 2;
    }
}
