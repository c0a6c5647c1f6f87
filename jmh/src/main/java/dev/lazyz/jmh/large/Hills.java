package dev.lazyz.jmh.large;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A hilly square as a file, row by row, as programs for maps and scans write it.
 *
 * <p>{@code java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.large.Hills hills.stl 50000000} writes one; a third
 * argument is a format of {@link LargeModel}.
 */
public final class Hills {
    private Hills() {}

    public static void main(String[] args) throws IOException {
        int written = write(Path.of(args[0]), Integer.parseInt(args[1]), args.length > 2 ? args[2] : "stl");
        System.out.printf("%d triangles%n", written);
    }

    /** Writes about so many triangles in a {@code format} of {@link LargeModel}; returns how many. */
    static int write(Path file, int triangles, String format) throws IOException {
        switch (format) {
            case "stl":
                return write(file, triangles);
            case "ply":
                return IndexedHills.writePly(file, triangles);
            case "ply-text":
                return IndexedHills.writeText(file, triangles, true);
            case "obj":
                return IndexedHills.writeText(file, triangles, false);
            default:
                throw new IllegalArgumentException("--format: stl, ply, ply-text or obj: " + format);
        }
    }

    /** Returns the number of cells along a side of the square. */
    static int side(int triangles) {
        return Math.max(1, (int) Math.sqrt(triangles / 2.0));
    }

    /** Writes about so many triangles as binary STL; returns how many. */
    public static int write(Path file, int triangles) throws IOException {
        int side = side(triangles);
        ByteBuffer row = ByteBuffer.allocate(100 * side).order(ByteOrder.LITTLE_ENDIAN);
        try (OutputStream output = Files.newOutputStream(file)) {
            ByteBuffer header = ByteBuffer.allocate(84).order(ByteOrder.LITTLE_ENDIAN);
            output.write(header.putInt(80, 2 * side * side).array());
            float[] near = heights(side, 0);
            for (int y = 0; y < side; y++) {
                float[] far = heights(side, y + 1);
                row.clear();
                for (int x = 0; x < side; x++) {
                    for (int upper = 0; upper <= 1; upper++) {
                        row.position(row.position() + 12);
                        point(row, side, x, y, near[x]);
                        point(row, side, x + 1, y + upper, upper == 0 ? near[x + 1] : far[x + 1]);
                        point(row, side, x + 1 - upper, y + 1, upper == 0 ? far[x + 1] : far[x]);
                        row.position(row.position() + 2);
                    }
                }
                output.write(row.array());
                near = far;
            }
        }
        return 2 * side * side;
    }

    static void point(ByteBuffer row, int side, int x, int y, float height) {
        row.putFloat(2f * x / side - 1).putFloat(2f * y / side - 1).putFloat(height);
    }

    static float[] heights(int side, int row) {
        double y = 2.0 * row / side - 1;
        float[] heights = new float[side + 1];
        for (int column = 0; column <= side; column++) {
            double x = 2.0 * column / side - 1;
            heights[column] = (float) (0.2 * Math.sin(9 * x + 3 * y) * Math.cos(7 * y - 2 * x)
                    + 0.05 * Math.sin(61 * x) * Math.sin(53 * y)
                    + 0.01 * Math.sin(301 * x + y) * Math.sin(311 * y));
        }
        return heights;
    }
}
