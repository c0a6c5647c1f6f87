package dev.lazyz.jmh.workload;

import dev.lazyz.world.Scene;
import dev.lazyz.world.surface.Mesh;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.IntBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A landscape of squares, of two triangles each, that can be written to files: row by row, as programs for maps and
 * scans do, so that it need not fit into memory. Not thread safe.
 */
public final class MeshFiles {
    /** The heights of the vertices in a row. */
    public interface Heights {
        float[] of(int squares, int row);
    }

    private interface Corners {
        void add(int a, int b, int c) throws IOException;
    }

    private static final int JSON_CHUNK = 0x4E4F534A;
    private static final int BINARY_CHUNK = 0x004E4942;
    private final int squares;
    private final Heights heights;

    /** The heights of two rows, and their numbers. */
    private final float[][] rows = new float[2][];

    private final int[] numbers = {-1, -1};

    /** Creates a landscape of {@code squares} by {@code squares} squares. */
    public MeshFiles(int squares, Heights heights) {
        this.squares = squares;
        this.heights = heights;
    }

    public int vertexCount() {
        return (squares + 1) * (squares + 1);
    }

    public int triangleCount() {
        return 2 * squares * squares;
    }

    /** Returns the landscape as a scene. */
    public Scene scene() throws IOException {
        float[] positions = new float[3 * vertexCount()];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = coordinate(i / 3, i % 3);
        }
        IntBuffer corners = IntBuffer.allocate(3 * triangleCount());
        eachTriangle((a, b, c) -> corners.put(a).put(b).put(c));
        return Scene.builder().add(new Mesh(positions, corners.array())).build();
    }

    /**
     * Writes the landscape.
     *
     * @param format {@code stl}, {@code ply} and {@code glb}, which are binary, {@code ply-text} or {@code obj}
     * @throws IllegalArgumentException if it is another
     */
    public void write(Path file, String format) throws IOException {
        try (OutputStream output = new BufferedOutputStream(Files.newOutputStream(file), 1 << 16)) {
            switch (format) {
                case "stl" -> stl(output);
                case "ply" -> ply(output);
                case "glb" -> glb(output);
                case "ply-text" -> text(output, plyHeader("ascii"), "", "3 ", 0);
                case "obj" -> text(output, "", "v ", "f ", 1);
                default -> throw new IllegalArgumentException("--format: stl, ply, glb, ply-text or obj: " + format);
            }
        }
    }

    /** Returns x (0), y (1) or z (2) of a vertex. */
    private float coordinate(int vertex, int axis) {
        int row = vertex / (squares + 1);
        int column = vertex % (squares + 1);
        if (axis < 2) {
            return 2f * (axis == 0 ? column : row) / squares - 1;
        }
        int place = row & 1;
        if (numbers[place] != row) {
            rows[place] = heights.of(squares, row);
            numbers[place] = row;
        }
        return rows[place][column];
    }

    private void eachTriangle(Corners triangles) throws IOException {
        for (int near = 0; near < vertexCount() - squares - 1; near++) {
            if (near % (squares + 1) < squares) {
                int far = near + squares + 1;
                triangles.add(near, near + 1, far);
                triangles.add(near + 1, far + 1, far);
            }
        }
    }

    private void text(OutputStream output, String header, String vertex, String face, int first) throws IOException {
        output.write(ascii(header));
        for (int i = 0; i < vertexCount(); i++) {
            String place = coordinate(i, 0) + " " + coordinate(i, 1) + " " + coordinate(i, 2);
            output.write(ascii(vertex + place + "\n"));
        }
        eachTriangle(
                (a, b, c) -> output.write(ascii(face + (a + first) + ' ' + (b + first) + ' ' + (c + first) + '\n')));
    }

    private void stl(OutputStream output) throws IOException {
        output.write(littleEndian(84).putInt(80, triangleCount()).array());
        ByteBuffer facet = littleEndian(50);
        eachTriangle((a, b, c) -> {
            facet.position(12);
            putPoint(facet, a);
            putPoint(facet, b);
            putPoint(facet, c);
            output.write(facet.array());
        });
    }

    private void ply(OutputStream output) throws IOException {
        output.write(ascii(plyHeader("binary_little_endian")));
        positions(output);
        ByteBuffer face = littleEndian(1 + 3 * Integer.BYTES);
        eachTriangle((a, b, c) -> output.write(
                face.clear().put((byte) 3).putInt(a).putInt(b).putInt(c).array()));
    }

    private String plyHeader(String format) {
        return """
                ply
                format %s 1.0
                element vertex %d
                property float x
                property float y
                property float z
                element face %d
                property list uchar int vertex_indices
                end_header
                """.formatted(format, vertexCount(), triangleCount());
    }

    private void glb(OutputStream output) throws IOException {
        int positionBytes = 3 * Float.BYTES * vertexCount();
        int indexBytes = 3 * Integer.BYTES * triangleCount();
        String json = """
                {"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],\
                "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],\
                "buffers":[{"byteLength":%d}],\
                "bufferViews":[{"buffer":0,"byteLength":%d},{"buffer":0,"byteOffset":%d,"byteLength":%d}],\
                "accessors":[{"bufferView":0,"componentType":5126,"count":%d,"type":"VEC3",\
                "min":[-1,-1,-0.2],"max":[1,1,0.2]},\
                {"bufferView":1,"componentType":5125,"count":%d,"type":"SCALAR"}]}\
                """.formatted(
                        positionBytes + indexBytes,
                        positionBytes,
                        positionBytes,
                        indexBytes,
                        vertexCount(),
                        3 * triangleCount());
        byte[] text = ascii(json + " ".repeat(-json.length() & 3));
        int total = 12 + 8 + text.length + 8 + positionBytes + indexBytes;
        ByteBuffer header = littleEndian(total - positionBytes - indexBytes);
        header.put(ascii("glTF")).putInt(2).putInt(total);
        header.putInt(text.length).putInt(JSON_CHUNK).put(text);
        output.write(
                header.putInt(positionBytes + indexBytes).putInt(BINARY_CHUNK).array());
        positions(output);
        ByteBuffer corners = littleEndian(3 * Integer.BYTES);
        eachTriangle((a, b, c) ->
                output.write(corners.clear().putInt(a).putInt(b).putInt(c).array()));
    }

    private void positions(OutputStream output) throws IOException {
        ByteBuffer point = littleEndian(3 * Float.BYTES);
        for (int vertex = 0; vertex < vertexCount(); vertex++) {
            putPoint(point.clear(), vertex);
            output.write(point.array());
        }
    }

    private void putPoint(ByteBuffer to, int vertex) {
        for (int axis = 0; axis < 3; axis++) {
            to.putFloat(coordinate(vertex, axis));
        }
    }

    private static byte[] ascii(String text) {
        return text.getBytes(StandardCharsets.US_ASCII);
    }

    private static ByteBuffer littleEndian(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }
}
