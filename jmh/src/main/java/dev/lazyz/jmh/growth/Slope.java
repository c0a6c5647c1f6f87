package dev.lazyz.jmh.growth;

import java.util.List;

/** Slopes of curves on logarithmic axes: the exponent of growth. */
final class Slope {
    /** Number of points that count as the end of a curve. */
    private static final int LAST = 3;

    private Slope() {}

    /** Returns the slope of the last points of a curve; NaN if there are fewer than two. */
    static double last(List<double[]> curve) {
        return of(curve.subList(Math.max(0, curve.size() - LAST), curve.size()));
    }

    /** Returns the slope of the least-squares line through (log x, log y); NaN if there are fewer than two points. */
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
