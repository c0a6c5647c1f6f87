package dev.lazyz.jmh.large;

import java.io.IOException;
import java.io.OutputStream;
import java.io.Writer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A hilly square as a binary STL, a binary PLY or an OBJ file, row by row, as programs for maps and scans write it. All
 * three have the same triangles in the same order.
 */
public final class Hills {
    private Hills() {}

    /** Writes about so many triangles in the format of the file's extension; returns how many. */
    public static int write(Path file, int triangles) throws IOException {
        int side = Math.max(1, (int) Math.sqrt(triangles / 2.0));
        if (file.toString().endsWith(".ply")) {
            return writePly(file, side);
        }
        return file.toString().endsWith(".obj") ? writeObj(file, side) : writeStl(file, side);
    }

    private static int writePly(Path file, int side) throws IOException {
        try (OutputStream output = Files.newOutputStream(file)) {
            String header = "ply\nformat binary_little_endian 1.0\nelement vertex " + (side + 1) * (side + 1)
                    + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + 2 * side * side
                    + "\nproperty list uchar int vertex_indices\nend_header\n";
            output.write(header.getBytes(StandardCharsets.US_ASCII));
            ByteBuffer row = ByteBuffer.allocate(26 * (side + 1)).order(ByteOrder.LITTLE_ENDIAN);
            for (int y = 0; y <= side; y++) {
                float[] heights = heights(side, y);
                row.clear();
                for (int x = 0; x <= side; x++) {
                    point(row, side, x, y, heights[x]);
                }
                output.write(row.array(), 0, row.position());
            }
            for (int y = 0; y < side; y++) {
                row.clear();
                for (int x = 0; x < side; x++) {
                    for (int upper = 0; upper <= 1; upper++) {
                        row.put((byte) 3).putInt(number(side, x, y)).putInt(number(side, x + 1, y + upper));
                        row.putInt(number(side, x + 1 - upper, y + 1));
                    }
                }
                output.write(row.array(), 0, row.position());
            }
        }
        return 2 * side * side;
    }

    private static int writeObj(Path file, int side) throws IOException {
        try (Writer output = Files.newBufferedWriter(file, StandardCharsets.US_ASCII)) {
            for (int y = 0; y <= side; y++) {
                float[] heights = heights(side, y);
                for (int x = 0; x <= side; x++) {
                    output.write("v " + (2f * x / side - 1) + ' ' + (2f * y / side - 1) + ' ' + heights[x] + '\n');
                }
            }
            for (int y = 0; y < side; y++) {
                for (int x = 0; x < side; x++) {
                    for (int upper = 0; upper <= 1; upper++) {
                        output.write("f " + (number(side, x, y) + 1) + ' ' + (number(side, x + 1, y + upper) + 1) + ' '
                                + (number(side, x + 1 - upper, y + 1) + 1) + '\n');
                    }
                }
            }
        }
        return 2 * side * side;
    }

    /** Returns the number of the vertex at a corner of the square's cells. */
    private static int number(int side, int x, int y) {
        return y * (side + 1) + x;
    }

    private static int writeStl(Path file, int side) throws IOException {
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

    private static void point(ByteBuffer row, int side, int x, int y, float height) {
        row.putFloat(2f * x / side - 1).putFloat(2f * y / side - 1).putFloat(height);
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
