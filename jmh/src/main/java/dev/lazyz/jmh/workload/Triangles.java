package dev.lazyz.jmh.workload;

import dev.lazyz.Rgba;
import dev.lazyz.world.Camera;
import dev.lazyz.world.Projection;
import dev.lazyz.world.Scene;
import dev.lazyz.world.Viewpoint;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.material.Shading;
import dev.lazyz.world.surface.Mesh;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.joml.Matrix4d;

/**
 * Triangles with one colour per vertex and no other attributes, which any renderer can draw.
 *
 * @param id name on command lines
 * @param positions x, y, z for each vertex, world space
 * @param indices three vertex numbers per triangle, in the order of submission
 * @param rgb red, green, blue for each vertex, 8 bits each, linear light
 * @param coloring the source of the triangles' colours
 * @param viewpoint the viewpoint from which the triangles are seen
 */
public record Triangles(
        String id, float[] positions, int[] indices, byte[] rgb, Coloring coloring, Viewpoint viewpoint) {
    /** The first bytes of a file written by {@link #write}. */
    static final String MAGIC = "LZTRI001";

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

    /** Returns the scene of these triangles: opaque, unlit, before a transparent background. */
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
                .add(new Mesh(positions, indices, material, null, null, colors))
                .viewpoint(viewpoint)
                .background(Rgba.TRANSPARENT)
                .build();
    }

    private Material material() {
        Material plain = new Material(Rgba.WHITE).withShading(Shading.CONSTANT);
        return coloring == Coloring.ROUNDS ? plain.withShader(new RoundsShader()) : plain;
    }

    /**
     * Writes the triangles to a file that other renderers read, for a square raster.
     *
     * <p>Little-endian: {@value #MAGIC}; 32-bit integers: coloring (0 flat, 1 smooth, 2 rounds), 1 for perspective
     * and 0 otherwise, number of vertices, number of indices or 0 if vertices are not shared; the matrix from world
     * to clip space, 16 floats, column by column; for each vertex three floats and the bytes red, green, blue, 255;
     * the indices.
     */
    public void write(Path file) throws IOException {
        Camera camera = scene().camera(1, 1);
        int indexCount = isIndexed() ? indices.length : 0;
        long size = MAGIC.length() + 16L + 64 + 16L * vertexCount() + 4L * indexCount;
        ByteBuffer bytes = ByteBuffer.allocate(Math.toIntExact(size)).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(MAGIC.getBytes(StandardCharsets.US_ASCII));
        bytes.putInt(coloring.ordinal());
        bytes.putInt(camera.getProjection() instanceof Projection.Perspective ? 1 : 0);
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
        Files.write(file, bytes.array());
    }

    @Override
    public String toString() {
        return "Triangles(" + id + ", " + triangleCount() + " of " + vertexCount() + " vertices, " + coloring + ")";
    }
}
