package dev.lazyz.jmh.workload;

/** A sphere with bumps, made from the six faces of a cube, each a grid. Neighbouring triangles share their vertices. */
final class BumpySphere {
    /** Squares along a face's side: 6 x 289 x 289 x 2 = 1,002,252 triangles. */
    private static final int SQUARES = 289;

    private static final double RADIUS = 0.9;
    private static final double BUMP = 0.05;

    private BumpySphere() {}

    static Triangles of(String id) {
        ScreenTriangles triangles = new ScreenTriangles();
        for (int face = 0; face < 6; face++) {
            face(triangles, face);
        }
        return triangles.toTriangles(id, Coloring.SMOOTH);
    }

    private static void face(ScreenTriangles triangles, int face) {
        int axis = face / 2;
        double side = face % 2 == 0 ? 1 : -1;
        double[] p = new double[3];
        int first = 0;
        for (int row = 0; row <= SQUARES; row++) {
            for (int column = 0; column <= SQUARES; column++) {
                // Equal angles instead of equal lengths, so that squares in a face's corners are not much smaller
                p[axis] = side;
                p[(axis + 1) % 3] = StrictMath.tan((2.0 * column / SQUARES - 1) * StrictMath.PI / 4);
                p[(axis + 2) % 3] = side * StrictMath.tan((2.0 * row / SQUARES - 1) * StrictMath.PI / 4);
                int vertex = vertex(triangles, p);
                if (row == 0 && column == 0) {
                    first = vertex;
                }
            }
        }
        int stride = SQUARES + 1;
        for (int row = 0; row < SQUARES; row++) {
            for (int column = 0; column < SQUARES; column++) {
                int corner = first + row * stride + column;
                triangles.triangle(corner, corner + 1, corner + stride + 1);
                triangles.triangle(corner, corner + stride + 1, corner + stride);
            }
        }
    }

    private static int vertex(ScreenTriangles triangles, double[] p) {
        double length = StrictMath.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        double x = p[0] / length;
        double y = p[1] / length;
        double z = p[2] / length;
        double bump = StrictMath.sin(9 * x + 1) * StrictMath.sin(11 * y) * StrictMath.sin(7 * z + 2);
        double radius = RADIUS * (1 + BUMP * bump);

        // An oblique view: rotate around y, then around x
        double turnedX = 0.8 * x + 0.6 * z;
        double turnedZ = 0.8 * z - 0.6 * x;
        double turnedY = 0.8 * y - 0.6 * turnedZ;
        return triangles.vertex(
                radius * turnedX,
                radius * turnedY,
                -radius * (0.6 * y + 0.8 * turnedZ),
                shade(5 * x),
                shade(6 * y + 1),
                shade(7 * z + 2));
    }

    private static int shade(double phase) {
        return (int) (128 + 120 * StrictMath.sin(phase));
    }
}
