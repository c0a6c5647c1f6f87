package dev.lazyz.jmh.large;

import dev.lazyz.jmh.workload.MeshFiles;
import java.io.IOException;
import java.nio.file.Path;

/**
 * A hilly square as a file.
 *
 * <p>{@code java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.large.Hills hills.stl 50000000} writes one; a third
 * argument is a format of {@link MeshFiles}.
 */
public final class Hills {
    private Hills() {}

    public static void main(String[] args) throws IOException {
        int written = write(Path.of(args[0]), Integer.parseInt(args[1]), args.length > 2 ? args[2] : "stl");
        System.out.printf("%d triangles%n", written);
    }

    /** Writes about so many triangles in a format of {@link MeshFiles}; returns how many. */
    public static int write(Path file, int triangles, String format) throws IOException {
        MeshFiles files = new MeshFiles(Math.max(1, (int) Math.sqrt(triangles / 2.0)), Hills::heights);
        files.write(file, format);
        return files.triangleCount();
    }

    private static float[] heights(int side, int row) {
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
