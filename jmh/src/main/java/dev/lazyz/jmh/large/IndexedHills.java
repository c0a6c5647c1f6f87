package dev.lazyz.jmh.large;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** The square of {@link Hills} in files of shared vertices: all vertices row by row, then all triangles. */
final class IndexedHills {
    private IndexedHills() {}

    /** Writes a binary PLY file, little endian. */
    static int writePly(Path file, int triangles) throws IOException {
        int side = Hills.side(triangles);
        ByteBuffer row =
                ByteBuffer.allocate(Math.max(12 * (side + 1), 26 * side)).order(ByteOrder.LITTLE_ENDIAN);
        try (OutputStream output = Files.newOutputStream(file)) {
            String header = "ply\nformat binary_little_endian 1.0\nelement vertex " + (side + 1) * (side + 1)
                    + "\nproperty float x\nproperty float y\nproperty float z\nelement face " + 2 * side * side
                    + "\nproperty list uchar int vertex_indices\nend_header\n";
            output.write(header.getBytes(StandardCharsets.US_ASCII));
            for (int y = 0; y <= side; y++) {
                float[] heights = Hills.heights(side, y);
                row.clear();
                for (int x = 0; x <= side; x++) {
                    Hills.point(row, side, x, y, heights[x]);
                }
                output.write(row.array(), 0, row.position());
            }
            for (int y = 0; y < side; y++) {
                row.clear();
                for (int x = 0; x < side; x++) {
                    int near = y * (side + 1) + x;
                    int far = near + side + 1;
                    row.put((byte) 3).putInt(near).putInt(near + 1).putInt(far);
                    row.put((byte) 3).putInt(near + 1).putInt(far + 1).putInt(far);
                }
                output.write(row.array(), 0, row.position());
            }
        }
        return 2 * side * side;
    }

    /** Writes a file of text: OBJ, or PLY. */
    static int writeText(Path file, int triangles, boolean isPly) throws IOException {
        int side = Hills.side(triangles);
        String vertex = isPly ? "" : "v ";
        String face = isPly ? "3 " : "f ";
        int first = isPly ? 0 : 1;
        StringBuilder row = new StringBuilder();
        try (OutputStream output = Files.newOutputStream(file)) {
            if (isPly) {
                row.append("ply\nformat ascii 1.0\nelement vertex ").append((side + 1) * (side + 1));
                row.append("\nproperty float x\nproperty float y\nproperty float z\nelement face ");
                row.append(2 * side * side).append("\nproperty list uchar int vertex_indices\nend_header\n");
            }
            for (int y = 0; y <= side; y++) {
                float[] heights = Hills.heights(side, y);
                for (int x = 0; x <= side; x++) {
                    row.append(vertex).append(2f * x / side - 1).append(' ').append(2f * y / side - 1);
                    row.append(' ').append(heights[x]).append('\n');
                }
                flush(row, output);
            }
            for (int y = 0; y < side; y++) {
                for (int x = 0; x < side; x++) {
                    int near = y * (side + 1) + x + first;
                    int far = near + side + 1;
                    row.append(face).append(near).append(' ').append(near + 1);
                    row.append(' ').append(far).append('\n');
                    row.append(face).append(near + 1).append(' ').append(far + 1);
                    row.append(' ').append(far).append('\n');
                }
                flush(row, output);
            }
        }
        return 2 * side * side;
    }

    private static void flush(StringBuilder row, OutputStream output) throws IOException {
        output.write(row.toString().getBytes(StandardCharsets.US_ASCII));
        row.setLength(0);
    }
}
