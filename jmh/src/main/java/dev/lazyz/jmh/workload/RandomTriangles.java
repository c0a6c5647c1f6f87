package dev.lazyz.jmh.workload;

import java.util.SplittableRandom;

/** Triangles with random position, rotation, size and depth. None is a sliver, and all lie within the raster. */
final class RandomTriangles {
    private static final long SEED = 20_260_101L;

    /** The least angle between two corners, seen from the centre of the circumscribed circle: 50 degrees. */
    private static final double LEAST_GAP = StrictMath.PI * 50 / 180;

    /** Width and height of the raster to which the sizes of triangles in pixels refer. */
    private static final double SIDE = 1024;

    private final SplittableRandom places = new SplittableRandom(SEED);
    private final SplittableRandom colors = new SplittableRandom(SEED + 1);
    private final double[] x = new double[3];
    private final double[] y = new double[3];

    private RandomTriangles() {}

    /**
     * Creates {@code count} triangles of {@code area} pixels each, plus or minus 50 %, at 1024 x 1024.
     *
     * @param tilt maximum distance of a vertex before or behind the triangle's middle, in units of normalised depth
     * @param coloring {@link Coloring#FLAT} for one colour per triangle, otherwise one colour per vertex
     */
    static Triangles of(String id, int count, double area, double tilt, Coloring coloring) {
        RandomTriangles confetti = new RandomTriangles();
        ScreenTriangles triangles = new ScreenTriangles();
        for (int i = 0; i < count; i++) {
            confetti.add(triangles, area, tilt, coloring == Coloring.FLAT);
        }
        return triangles.toTriangles(id, coloring);
    }

    private void add(ScreenTriangles triangles, double area, double tilt, boolean isFlat) {
        shape(area * places.nextDouble(0.5, 1.5));
        place(x);
        place(y);
        double depth = places.nextDouble(-0.95, 0.95);
        int first = 0;
        int color = colors.nextInt(1 << 24);
        for (int i = 0; i < 3; i++) {
            double z = depth + places.nextDouble(-tilt, tilt);
            first = triangles.vertex(
                            2 * x[i] / SIDE - 1,
                            1 - 2 * y[i] / SIDE,
                            z,
                            color >> 16 & 0xFF,
                            color >> 8 & 0xFF,
                            color & 0xFF)
                    - i;
            if (!isFlat) {
                color = colors.nextInt(1 << 24);
            }
        }
        triangles.triangle(first, first + 1, first + 2);
    }

    /** Places the corners at random angles on a circle whose size gives the triangle its area. */
    private void shape(double area) {
        double spare = 2 * StrictMath.PI - 3 * LEAST_GAP;
        double a = places.nextDouble();
        double b = places.nextDouble();
        double first = LEAST_GAP + spare * Math.min(a, b);
        double second = LEAST_GAP + spare * Math.abs(a - b);
        double third = 2 * StrictMath.PI - first - second;
        double unitArea = (StrictMath.sin(first) + StrictMath.sin(second) + StrictMath.sin(third)) / 2;
        double radius = StrictMath.sqrt(area / unitArea);
        double angle = places.nextDouble(2 * StrictMath.PI);
        double[] turns = {angle, angle + first, angle + first + second};
        for (int i = 0; i < 3; i++) {
            x[i] = radius * StrictMath.cos(turns[i]);
            y[i] = radius * StrictMath.sin(turns[i]);
        }
    }

    /** Moves coordinates to a random position within the raster. */
    private void place(double[] coordinates) {
        double least = Math.min(coordinates[0], Math.min(coordinates[1], coordinates[2]));
        double greatest = Math.max(coordinates[0], Math.max(coordinates[1], coordinates[2]));
        double shift = places.nextDouble(SIDE - (greatest - least)) - least;
        for (int i = 0; i < 3; i++) {
            coordinates[i] += shift;
        }
    }
}
