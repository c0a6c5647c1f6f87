package dev.lazyz.jmh.kernel;

import java.util.Random;

/**
 * Random triangles within one tile, as linear forms: the input of all variants.
 *
 * <p>Vertices lie on a grid of 1/16 of the sample distance. Edge functions are exact and at least 0 inside, with the
 * top-left rule in their constants. Depth is also a linear form, 31 bits.
 */
final class TileTriangles {
    /** Width and height of the tile, samples. */
    static final int SIDE = 128;

    /** Number of samples. */
    static final int SIZE = SIDE * SIDE;

    private static final int GRID = 16;

    final int count;

    /** Bounding box of each triangle in samples, inclusive. */
    final int[] minX, minY, maxX, maxY;

    /** The three edge functions at sample (0, 0), and their steps: at 3 i, 3 i + 1 and 3 i + 2 for triangle i. */
    final long[] edge, edgeDx, edgeDy;

    /** Depth at sample (0, 0), and its steps. */
    final long[] z, zdx, zdy;

    /** Creates {@code count} triangles of {@code area} samples each, plus or minus 50 %. */
    TileTriangles(int count, double area, long seed) {
        this.count = count;
        minX = new int[count];
        minY = new int[count];
        maxX = new int[count];
        maxY = new int[count];
        edge = new long[3 * count];
        edgeDx = new long[3 * count];
        edgeDy = new long[3 * count];
        z = new long[count];
        zdx = new long[count];
        zdy = new long[count];
        Random random = new Random(seed);
        int[] x = new int[3];
        int[] y = new int[3];
        for (int i = 0; i < count; i++) {
            double wanted = GRID * GRID * area * (0.5 + random.nextDouble());
            while (!place(random, x, y, wanted)) {
                // Try again: some shapes are too long for the tile
            }
            add(i, x, y);
            zdx[i] = random.nextInt(1 << 16) - (1 << 15);
            zdy[i] = random.nextInt(1 << 16) - (1 << 15);
            z[i] = (1L << 28) + random.nextInt(1 << 29);
        }
    }

    /**
     * Returns the key of triangle {@code i} at a sample with depth {@code depth}. The minimum key is the nearest
     * triangle, and the first among equals.
     */
    static long key(long depth, int i) {
        return depth << Integer.SIZE | i;
    }

    /** Returns the least depth of triangle {@code i} within a rectangle, inclusive. It occurs at a corner. */
    long nearest(int i, int fromX, int fromY, int toX, int toY) {
        long x = zdx[i] > 0 ? fromX : toX;
        long y = zdy[i] > 0 ? fromY : toY;
        return z[i] + zdx[i] * x + zdy[i] * y;
    }

    private static boolean place(Random random, int[] x, int[] y, double area) {
        double[] u = new double[3];
        double[] v = new double[3];
        for (int i = 0; i < 3; i++) {
            u[i] = random.nextDouble();
            v[i] = random.nextDouble();
        }
        double twice = (u[1] - u[0]) * (v[2] - v[0]) - (v[1] - v[0]) * (u[2] - u[0]);
        double scale = Math.sqrt(2 * area / Math.abs(twice));
        int end = GRID * SIDE;
        double left = random.nextDouble() * (end - scale);
        double top = random.nextDouble() * (end - scale);
        for (int i = 0; i < 3; i++) {
            int corner = twice > 0 ? i : 2 - i;
            x[i] = (int) (left + scale * u[corner]);
            y[i] = (int) (top + scale * v[corner]);
        }
        long exact = (long) (x[1] - x[0]) * (y[2] - y[0]) - (long) (y[1] - y[0]) * (x[2] - x[0]);
        return scale < end && exact > 0;
    }

    private void add(int i, int[] x, int[] y) {
        for (int k = 0; k < 3; k++) {
            int next = (k + 1) % 3;
            long dx = x[next] - x[k];
            long dy = y[next] - y[k];
            boolean ownsItsSamples = dy < 0 || dy == 0 && dx > 0;
            int half = GRID / 2;
            edge[3 * i + k] = dx * (half - y[k]) - dy * (half - x[k]) - (ownsItsSamples ? 0 : 1);
            edgeDx[3 * i + k] = -dy * GRID;
            edgeDy[3 * i + k] = dx * GRID;
        }
        minX[i] = Math.min(x[0], Math.min(x[1], x[2])) / GRID;
        minY[i] = Math.min(y[0], Math.min(y[1], y[2])) / GRID;
        maxX[i] = Math.min(SIDE - 1, Math.max(x[0], Math.max(x[1], x[2])) / GRID);
        maxY[i] = Math.min(SIDE - 1, Math.max(y[0], Math.max(y[1], y[2])) / GRID);
    }
}
