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
 * All measurements of {@link Growth}, stored in a JSON file.
 *
 * @param facts machine, versions, settings, command
 * @param points the frames that were rendered
 * @param costs the time and memory of each strategy and round
 * @param missing strategies that were not measured, with the reason
 */
record GrowthResults(Map<String, String> facts, List<Point> points, List<Cost> costs, List<Missing> missing) {
    /** Reason for a missing measurement: the strategy took too long at this point or at a smaller one. */
    static final String SLOW = "slow";

    /** Reason for a missing measurement: the strategy does not fit into the heap, at this point or at a smaller one. */
    static final String MEMORY = "memory";

    /**
     * A frame that was rendered.
     *
     * @param axis id of the axis, the quantity that grows
     * @param value value on the axis
     * @param side width and height of the raster, samples
     * @param threads number of threads of the renderers
     * @param rounds rounds of shading per sample
     * @param primitives number of primitives
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
        /** Returns the numbers of the frame that the model uses. */
        FrameNumbers numbers() {
            return new FrameNumbers(side, side, primitives, primitiveRows, fragments, false, Math.max(1, rounds));
        }
    }

    /**
     * The cost of one strategy in one round.
     *
     * @param axis id of the axis, the quantity that grows
     * @param value value on the axis
     * @param strategy id of the strategy
     * @param round number of the round, from 1; within a round, strategies are measured directly one after the other
     * @param millis wall-clock time of a frame, including set-up; the median of the round's frames
     * @param frames number of frames
     * @param allocated bytes allocated in a frame by threads that still exist afterwards, including set-up
     * @param peak peak working memory in bytes, as reported by the renderer
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

    /** Returns these results without the given axes. */
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

    /** Returns the points of an axis, in ascending order. */
    List<Point> points(Axis axis) {
        return points.stream().filter(point -> point.axis().equals(axis.id())).toList();
    }

    /** Returns the strategies that were measured somewhere on an axis, in the order of the built-in list. */
    List<String> strategies(Axis axis) {
        return strategies().stream()
                .filter(strategy -> costs.stream()
                        .anyMatch(cost ->
                                cost.axis().equals(axis.id()) && cost.strategy().equals(strategy)))
                .toList();
    }

    /** Returns all strategies that were measured, in the order of the built-in list. */
    List<String> strategies() {
        Set<String> measured = costs.stream().map(Cost::strategy).collect(Collectors.toSet());
        return Renderers.getBuiltIn().stream()
                .map(Renderer::getId)
                .filter(measured::contains)
                .toList();
    }

    /** Returns the median of the rounds of a strategy at a point. */
    OptionalDouble median(Point point, String strategy, ToDoubleFunction<Cost> quantity) {
        double[] values = costs.stream()
                .filter(cost -> cost.axis().equals(point.axis()) && cost.value() == point.value())
                .filter(cost -> cost.strategy().equals(strategy))
                .mapToDouble(quantity)
                .sorted()
                .toArray();
        return values.length == 0 ? OptionalDouble.empty() : OptionalDouble.of(median(values));
    }

    /** Returns the points (value, median) of a strategy's curve along an axis whose median is positive. */
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

    /** Returns the reason why a strategy has no figures at a point, or null. */
    String reason(Point point, String strategy) {
        return missing.stream()
                .filter(gap -> gap.axis().equals(point.axis()) && gap.value() == point.value())
                .filter(gap -> gap.strategy().equals(strategy))
                .map(Missing::reason)
                .findFirst()
                .orElse(null);
    }

    /** Returns the median of values in any order. */
    static double median(double[] values) {
        double[] ascending = values.clone();
        Arrays.sort(ascending);
        int middle = ascending.length / 2;
        return ascending.length % 2 == 1 ? ascending[middle] : (ascending[middle - 1] + ascending[middle]) / 2;
    }
}
