package dev.lazyz.jmh.growth;

import dev.lazyz.jmh.report.Measurements;
import dev.lazyz.strategies.FrameNumbers;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * A quantity of a strategy along an axis: points (value, median of the rounds) at which it is positive.
 *
 * @param points in ascending order of values
 */
record Curve(List<double[]> points) {
    static Curve of(Measurements results, String quantity, GrowthAxis axis, String strategy) {
        List<double[]> points = new ArrayList<>();
        for (long value : axis.values) {
            double median =
                    results.median(quantity, axis.subject(value), strategy).orElse(0);
            if (median > 0) {
                points.add(new double[] {value, median});
            }
        }
        return new Curve(points);
    }

    /** Returns the numbers of the frame at a value of an axis; null if it was not measured. */
    static FrameNumbers numbers(Measurements results, GrowthAxis axis, long value) {
        String subject = axis.subject(value);
        OptionalDouble primitives = results.median(Growth.PRIMITIVES, subject, Growth.FRAME);
        if (primitives.isEmpty()) {
            return null;
        }
        return new FrameNumbers(
                axis.side(value),
                axis.side(value),
                (long) primitives.getAsDouble(),
                results.median(Growth.ROWS, subject, Growth.FRAME).orElseThrow(),
                results.median(Growth.FRAGMENTS, subject, Growth.FRAME).orElseThrow(),
                false,
                Math.max(1, axis.rounds(value)));
    }
}
