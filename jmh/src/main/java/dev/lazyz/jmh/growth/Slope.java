package dev.lazyz.jmh.growth;

import java.util.List;

/** Slopes of curves on logarithmic axes: the exponent of growth. */
final class Slope {
    /** Points at the end of a curve. */
    private static final int LAST = 3;

    private Slope() {}

    /** Returns the slope at the end of a curve, by its last points; NaN if there are fewer than two. */
    static double last(List<double[]> curve) {
        return of(curve.subList(Math.max(0, curve.size() - LAST), curve.size()));
    }

    /** Returns the slope of the straight line that fits (log x, log y) best, by least squares; NaN for a single point. */
    static double of(List<double[]> curve) {
        double x = 0;
        double y = 0;
        for (double[] point : curve) {
            x += StrictMath.log(point[0]) / curve.size();
            y += StrictMath.log(point[1]) / curve.size();
        }
        double both = 0;
        double square = 0;
        for (double[] point : curve) {
            double dx = StrictMath.log(point[0]) - x;
            both += dx * (StrictMath.log(point[1]) - y);
            square += dx * dx;
        }
        return curve.size() < 2 ? Double.NaN : both / square;
    }
}
