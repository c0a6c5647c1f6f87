package dev.lazyz.jmh.workload;

import dev.lazyz.Rgba;
import dev.lazyz.world.Scene;
import dev.lazyz.world.camera.Camera;
import dev.lazyz.world.camera.Projection;
import dev.lazyz.world.camera.Viewpoint;
import dev.lazyz.world.light.Light;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.material.Material.Shading;
import dev.lazyz.world.surface.Mesh;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.joml.Matrix4d;
import org.joml.Vector3dc;

/**
 * Triangles with one colour per vertex, and with normals if they are lit, which any renderer can draw.
 *
 * @param id name on command lines
 * @param positions x, y, z for each vertex, world space
 * @param indices three vertex numbers per triangle, in the order of submission
 * @param rgb red, green, blue for each vertex, 8 bits each, linear light
 * @param normals x, y, z for each vertex if the triangles are lit, otherwise null
 * @param coloring the source of the triangles' colours
 * @param viewpoint the viewpoint from which the triangles are seen
 */
public record Triangles(
        String id,
        float[] positions,
        int[] indices,
        byte[] rgb,
        float[] normals,
        Coloring coloring,
        Viewpoint viewpoint) {
    /** The first bytes of a file written by {@link #write}. */
    static final String MAGIC = "LZTRI001";

    /** Number of lights with a direction that a scene without lights gets. */
    private static final int LIGHTS = 2;

    /** Number of vertices. */
    public int vertexCount() {
        return positions.length / 3;
    }

    /** Number of triangles. */
    public int triangleCount() {
        return indices.length / 3;
    }

    /** Whether vertices are shared; otherwise the indices are 0, 1, 2 and so on. */
    public boolean isIndexed() {
        return vertexCount() != indices.length;
    }

    /** Returns the scene of these triangles: opaque, without lights, before a transparent background. */
    public Scene scene() {
        return scene(material());
    }

    /** Returns the scene of these triangles with the given material. */
    public Scene scene(Material material) {
        float[] colors = new float[4 * vertexCount()];
        for (int vertex = 0; vertex < vertexCount(); vertex++) {
            for (int i = 0; i < 3; i++) {
                colors[4 * vertex + i] = (rgb[3 * vertex + i] & 0xFF) / 255f;
            }
            colors[4 * vertex + 3] = 1f;
        }
        return Scene.builder()
                .add(new Mesh(positions, indices, material, normals, null, colors))
                .viewpoint(viewpoint)
                .background(Rgba.TRANSPARENT)
                .build();
    }

    private Material material() {
        Material lit = new Material(Rgba.WHITE);
        return switch (coloring) {
            case LIT -> lit;
            case ROUNDS -> lit.withShader(new RoundsShader());
            case FLAT, SMOOTH -> lit.withShading(Shading.CONSTANT);
        };
    }

    /**
     * Writes the triangles to a file that other renderers read, for a square raster.
     *
     * <p>Little-endian: {@value #MAGIC}; 32-bit integers: coloring (0 flat, 1 smooth, 2 rounds, 3 lit), 1 for
     * perspective and 0 otherwise, number of vertices, number of indices or 0 if vertices are not shared; the matrix
     * from world to clip space, 16 floats, column by column; for each vertex three floats and the bytes red, green,
     * blue, 255; the indices. Lit triangles have more floats at the end: three for the normal of each vertex; the
     * eye, or the direction to it, and 1 or 0; ambient light; and for each of {@value #LIGHTS} lights the direction
     * in which it travels and its colour.
     */
    public void write(Path file) throws IOException {
        Camera camera = scene().camera(1, 1);
        boolean isPerspective = camera.getProjection() instanceof Projection.Perspective;
        int indexCount = isIndexed() ? indices.length : 0;
        long size = MAGIC.length() + 16L + 64 + 16L * vertexCount() + 4L * indexCount + litSize();
        ByteBuffer bytes = ByteBuffer.allocate(Math.toIntExact(size)).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(MAGIC.getBytes(StandardCharsets.US_ASCII));
        bytes.putInt(coloring.ordinal());
        bytes.putInt(isPerspective ? 1 : 0);
        bytes.putInt(vertexCount());
        bytes.putInt(indexCount);
        Matrix4d toClip = camera.projectionMatrix(1.0).mul(camera.viewMatrix());
        for (int column = 0; column < 4; column++) {
            for (int row = 0; row < 4; row++) {
                bytes.putFloat((float) toClip.get(column, row));
            }
        }
        for (int vertex = 0; vertex < vertexCount(); vertex++) {
            for (int i = 0; i < 3; i++) {
                bytes.putFloat(positions[3 * vertex + i]);
            }
            bytes.put(rgb, 3 * vertex, 3).put((byte) 255);
        }
        for (int i = 0; i < indexCount; i++) {
            bytes.putInt(indices[i]);
        }
        if (coloring == Coloring.LIT) {
            putLight(bytes, camera, isPerspective);
        }
        Files.write(file, bytes.array());
    }

    private long litSize() {
        return coloring == Coloring.LIT ? Float.BYTES * (normals.length + 7L + 6L * LIGHTS) : 0;
    }

    private void putLight(ByteBuffer bytes, Camera camera, boolean isPerspective) {
        for (float component : normals) {
            bytes.putFloat(component);
        }
        put(bytes, isPerspective ? camera.getEye() : camera.toWorldDirection(0, 0, 1));
        bytes.putFloat(isPerspective ? 1 : 0);
        int directions = 0;
        for (Light light : Light.studio(camera)) {
            if (light instanceof Light.Directional directional) {
                put(bytes, directional.getDirection());
                directions++;
            }
            bytes.putFloat(light.getColor().getRed());
            bytes.putFloat(light.getColor().getGreen());
            bytes.putFloat(light.getColor().getBlue());
        }
        if (directions != LIGHTS) {
            throw new IllegalStateException("a scene without lights has " + directions + " lights with a direction");
        }
    }

    private static void put(ByteBuffer bytes, Vector3dc vector) {
        for (int axis = 0; axis < 3; axis++) {
            bytes.putFloat((float) vector.get(axis));
        }
    }

    @Override
    public String toString() {
        return "Triangles(" + id + ", " + triangleCount() + " of " + vertexCount() + " vertices, " + coloring + ")";
    }
}
