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
    /** Number of points that count as the end of a curve. */
    private static final int LAST = 3;

    static Curve of(Measurements results, String quantity, Axis axis, String strategy) {
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
    static FrameNumbers numbers(Measurements results, Axis axis, long value) {
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

    /**
     * Returns the exponent of growth at the end: the slope of the least-squares line through (log x, log y) of the last
     * points; NaN if there are fewer than two.
     */
    double slope() {
        List<double[]> last = points.subList(Math.max(0, points.size() - LAST), points.size());
        double x = 0;
        double y = 0;
        for (double[] point : last) {
            x += StrictMath.log(point[0]) / last.size();
            y += StrictMath.log(point[1]) / last.size();
        }
        double both = 0;
        double square = 0;
        for (double[] point : last) {
            double dx = StrictMath.log(point[0]) - x;
            both += dx * (StrictMath.log(point[1]) - y);
            square += dx * dx;
        }
        return last.size() < 2 ? Double.NaN : both / square;
    }
}
