package dev.lazyz.jmh.workload;

import dev.lazyz.Rgba;
import dev.lazyz.world.Camera;
import dev.lazyz.world.FittedViewpoint.Fit;
import dev.lazyz.world.Scene;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.material.Material.Shading;
import dev.lazyz.world.surface.Mesh;
import dev.lazyz.world.surface.Surface;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/** A hilly landscape that can be written as OBJ, binary STL, binary PLY and GLB files. */
public final class MeshFiles {
    private static final int JSON_CHUNK = 0x4E4F534A;
    private static final int BINARY_CHUNK = 0x004E4942;

    private final float[] positions;
    private final int[] triangles;

    /** Creates a landscape of {@code squares} by {@code squares} squares. */
    public MeshFiles(int squares) {
        int stride = squares + 1;
        positions = new float[3 * stride * stride];
        triangles = new int[6 * squares * squares];
        int to = 0;
        int at = 0;
        for (int row = 0; row <= squares; row++) {
            for (int column = 0; column <= squares; column++) {
                double x = 2.0 * column / squares - 1;
                double y = 2.0 * row / squares - 1;
                positions[to++] = (float) x;
                positions[to++] = (float) y;
                positions[to++] = (float) (0.2 * StrictMath.sin(5 * x + 1) * StrictMath.sin(7 * y));
                if (row < squares && column < squares) {
                    int corner = row * stride + column;
                    for (int offset : new int[] {0, 1, stride + 1, 0, stride + 1, stride}) {
                        triangles[at++] = corner + offset;
                    }
                }
            }
        }
    }

    /** Returns the landscape as a scene. */
    public Scene scene() {
        return Scene.builder().add(new Mesh(positions, triangles)).build();
    }

    /** Returns the plain loops that read the files of this landscape. */
    public PlainLoops plainLoops() {
        return new PlainLoops(positions.length, triangles.length);
    }

    /** Returns a scene with only the shapes of the meshes, flat-shaded, seen from the front. */
    public static Scene facets(Scene scene) {
        Scene.Builder facets = Scene.builder()
                .viewpoint(Camera.fit(0.0, 0.0, 1.0, Fit.ORTHOGRAPHIC))
                .background(Rgba.BLACK);
        Material material = new Material(Rgba.WHITE).withShading(Shading.FLAT);
        for (Surface surface : scene.getSurfaces()) {
            if (surface instanceof Mesh mesh) {
                facets.add(new Mesh(mesh.getPositions(), mesh.getTriangles(), material));
            }
        }
        return facets.build();
    }

    /**
     * Writes the landscape in the format given by the extension of the file name.
     *
     * @throws IllegalArgumentException if the extension is not {@code .obj}, {@code .stl}, {@code .ply} or
     *     {@code .glb}
     */
    public void write(Path file) throws IOException {
        String name = file.toString();
        switch (name.substring(name.lastIndexOf('.') + 1)) {
            case "obj" -> Files.writeString(file, obj());
            case "stl" -> Files.write(file, stl());
            case "ply" -> Files.write(file, ply());
            case "glb" -> Files.write(file, glb());
            default -> throw new IllegalArgumentException("neither .obj, .stl, .ply nor .glb: " + file);
        }
    }

    private String obj() {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < positions.length; i += 3) {
            text.append("v ").append(positions[i]).append(' ').append(positions[i + 1]);
            text.append(' ').append(positions[i + 2]).append('\n');
        }
        for (int i = 0; i < triangles.length; i += 3) {
            text.append("f ").append(triangles[i] + 1).append(' ').append(triangles[i + 1] + 1);
            text.append(' ').append(triangles[i + 2] + 1).append('\n');
        }
        return text.toString();
    }

    private byte[] stl() {
        ByteBuffer bytes = littleEndian(84 + 50 * (triangles.length / 3));
        bytes.position(80).putInt(triangles.length / 3);
        for (int i = 0; i < triangles.length; i += 3) {
            bytes.putFloat(0f).putFloat(0f).putFloat(0f);
            for (int corner = i; corner < i + 3; corner++) {
                for (int axis = 0; axis < 3; axis++) {
                    bytes.putFloat(positions[3 * triangles[corner] + axis]);
                }
            }
            bytes.putShort((short) 0);
        }
        return bytes.array();
    }

    private byte[] ply() {
        String header = """
                ply
                format binary_little_endian 1.0
                element vertex %d
                property float x
                property float y
                property float z
                element face %d
                property list uchar int vertex_indices
                end_header
                """.formatted(positions.length / 3, triangles.length / 3);
        byte[] text = header.getBytes(StandardCharsets.US_ASCII);
        int faceBytes = 1 + 3 * Integer.BYTES;
        ByteBuffer bytes =
                littleEndian(text.length + Float.BYTES * positions.length + faceBytes * triangles.length / 3);
        bytes.put(text);
        for (float position : positions) {
            bytes.putFloat(position);
        }
        for (int i = 0; i < triangles.length; i++) {
            if (i % 3 == 0) {
                bytes.put((byte) 3);
            }
            bytes.putInt(triangles[i]);
        }
        return bytes.array();
    }

    private byte[] glb() {
        int positionBytes = Float.BYTES * positions.length;
        int indexBytes = Integer.BYTES * triangles.length;
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
                        positions.length / 3,
                        triangles.length);
        byte[] text = (json + " ".repeat(-json.length() & 3)).getBytes(StandardCharsets.US_ASCII);
        int total = 12 + 8 + text.length + 8 + positionBytes + indexBytes;
        ByteBuffer bytes = littleEndian(total);
        bytes.put("glTF".getBytes(StandardCharsets.US_ASCII)).putInt(2).putInt(total);
        bytes.putInt(text.length).putInt(JSON_CHUNK).put(text);
        bytes.putInt(positionBytes + indexBytes).putInt(BINARY_CHUNK);
        for (float position : positions) {
            bytes.putFloat(position);
        }
        for (int vertex : triangles) {
            bytes.putInt(vertex);
        }
        return bytes.array();
    }

    private static ByteBuffer littleEndian(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }
}
