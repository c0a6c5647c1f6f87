package dev.lazyz.jmh.workload;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;

/** Scenes of any size, for measuring the growth of costs: one number varies, the others are constant. */
public final class Growing {
    private static final long SEED = 20_260_102L;
    private static final double SAMPLES = 1024.0 * 1024.0;

    private Growing() {}

    /**
     * Creates random triangles in smooth colours.
     *
     * @param count number of triangles; a small count requires a small depth complexity, because a triangle must fit
     *     into the raster
     * @param depthComplexity mean number of triangles that cover a sample, for any count
     */
    public static Triangles confetti(int count, double depthComplexity) {
        return RandomTriangles.of("confetti", count, depthComplexity * SAMPLES / count, 0.02, Coloring.SMOOTH);
    }

    /** Creates layers that fill the raster, of two triangles each, in random order of depth. */
    public static Triangles layers(int count) {
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            order.add(i);
        }
        Collections.shuffle(order, new Random(SEED));
        ScreenTriangles triangles = new ScreenTriangles();
        for (int layer : order) {
            double z = -0.9 + 1.8 * layer / count;
            int shade = 40 + layer * 41 % 200;
            int a = triangles.vertex(-1, -1, z, shade, 40, 200);
            int b = triangles.vertex(1, -1, z, 200, shade, 40);
            int c = triangles.vertex(1, 1, z, 40, 200, shade);
            int d = triangles.vertex(-1, 1, z, shade, shade, shade);
            triangles.triangle(a, b, c);
            triangles.triangle(a, c, d);
        }
        return triangles.toTriangles("layers", Coloring.SMOOTH);
    }
}
