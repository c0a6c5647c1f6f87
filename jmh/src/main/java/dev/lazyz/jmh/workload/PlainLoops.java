package dev.lazyz.jmh.workload;

import dev.lazyz.world.surface.Mesh;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;

/**
 * The minimum work for reading the files of {@link MeshFiles}: from the file's bytes to a mesh without normals, in
 * one loop that assumes how the file is written and how much it contains, checks nothing, and does not merge the
 * corners of STL.
 *
 * <p>Binary formats: floats and vertex numbers are copied to arrays one by one. OBJ: each number is parsed from its
 * digits, point and exponent, with one division; the result is not always the nearest float.
 */
public final class PlainLoops {
    private static final byte[] END_OF_HEADER = "end_header\n".getBytes(StandardCharsets.US_ASCII);
    private static final int STL_HEADER = 84;
    private static final int STL_NORMAL = 12;
    private static final int GLB_HEADER = 12;
    private static final int GLB_CHUNK_HEADER = 8;
    private static final int LARGEST_POWER = 22;
    private static final double[] POWERS = new double[LARGEST_POWER + 1];

    static {
        POWERS[0] = 1;
        for (int i = 1; i < POWERS.length; i++) {
            POWERS[i] = POWERS[i - 1] * 10;
        }
    }

    private final int positionCount;
    private final int cornerCount;

    /** Creates loops for files with this number of coordinates and of triangle corners. */
    public PlainLoops(int positionCount, int cornerCount) {
        this.positionCount = positionCount;
        this.cornerCount = cornerCount;
    }

    /**
     * Reads a file in the format given by the extension of its name.
     *
     * @throws IllegalArgumentException if the extension is not {@code .obj}, {@code .stl}, {@code .ply} or
     *     {@code .glb}
     */
    public Mesh read(Path file) throws IOException {
        byte[] bytes = Files.readAllBytes(file);
        String name = file.toString();
        return switch (name.substring(name.lastIndexOf('.') + 1)) {
            case "obj" -> obj(bytes);
            case "stl" -> stl(littleEndian(bytes));
            case "ply" -> ply(bytes);
            case "glb" -> glb(littleEndian(bytes));
            default -> throw new IllegalArgumentException("neither .obj, .stl, .ply nor .glb: " + file);
        };
    }

    private Mesh stl(ByteBuffer bytes) {
        float[] positions = new float[3 * cornerCount];
        int[] triangles = new int[cornerCount];
        int at = STL_HEADER;
        for (int corner = 0; corner < cornerCount; corner += 3) {
            at += STL_NORMAL;
            for (int i = 0; i < 9; i++) {
                positions[3 * corner + i] = bytes.getFloat(at);
                at += Float.BYTES;
            }
            for (int i = 0; i < 3; i++) {
                triangles[corner + i] = corner + i;
            }
            at += Short.BYTES;
        }
        return new Mesh(positions, triangles);
    }

    private Mesh ply(byte[] bytes) {
        ByteBuffer buffer = littleEndian(bytes);
        int at = 0;
        while (!Arrays.equals(bytes, at, at + END_OF_HEADER.length, END_OF_HEADER, 0, END_OF_HEADER.length)) {
            at++;
        }
        at += END_OF_HEADER.length;
        float[] positions = floats(buffer, at);
        at += Float.BYTES * positionCount;
        int[] triangles = new int[cornerCount];
        for (int corner = 0; corner < cornerCount; corner += 3) {
            at++;
            for (int i = 0; i < 3; i++) {
                triangles[corner + i] = buffer.getInt(at);
                at += Integer.BYTES;
            }
        }
        return new Mesh(positions, triangles);
    }

    private Mesh glb(ByteBuffer bytes) {
        int at = GLB_HEADER + GLB_CHUNK_HEADER + bytes.getInt(GLB_HEADER) + GLB_CHUNK_HEADER;
        float[] positions = floats(bytes, at);
        at += Float.BYTES * positionCount;
        int[] triangles = new int[cornerCount];
        for (int i = 0; i < cornerCount; i++) {
            triangles[i] = bytes.getInt(at + Integer.BYTES * i);
        }
        return new Mesh(positions, triangles);
    }

    private float[] floats(ByteBuffer bytes, int at) {
        float[] positions = new float[positionCount];
        for (int i = 0; i < positionCount; i++) {
            positions[i] = bytes.getFloat(at + Float.BYTES * i);
        }
        return positions;
    }

    private Mesh obj(byte[] bytes) {
        float[] positions = new float[positionCount];
        int[] triangles = new int[cornerCount];
        int position = 0;
        int corner = 0;
        int at = 0;
        while (at < bytes.length) {
            boolean isVertex = bytes[at] == 'v';
            at += 2;
            for (int i = 0; i < 3; i++) {
                boolean isNegative = bytes[at] == '-';
                if (isNegative) {
                    at++;
                }
                long digits = 0;
                int power = 0;
                boolean isBehindPoint = false;
                byte letter = bytes[at];
                while (letter > ' ' && letter != 'E') {
                    if (letter == '.') {
                        isBehindPoint = true;
                    } else {
                        digits = 10 * digits + (letter - '0');
                        if (isBehindPoint) {
                            power++;
                        }
                    }
                    letter = bytes[++at];
                }
                if (letter == 'E') {
                    at++;
                    boolean isDown = bytes[at] == '-';
                    if (isDown) {
                        at++;
                    }
                    int exponent = 0;
                    while (bytes[at] > ' ') {
                        exponent = 10 * exponent + (bytes[at++] - '0');
                    }
                    power += isDown ? exponent : -exponent;
                }
                at++;
                if (isVertex) {
                    double number = power < 0 ? digits * POWERS[-power] : digits / POWERS[power];
                    positions[position++] = (float) (isNegative ? -number : number);
                } else {
                    triangles[corner++] = (int) digits - 1;
                }
            }
        }
        return new Mesh(positions, triangles);
    }

    private static ByteBuffer littleEndian(byte[] bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }
}
