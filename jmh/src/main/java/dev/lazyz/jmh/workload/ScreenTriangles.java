package dev.lazyz.jmh.workload;

import dev.lazyz.world.camera.Camera;
import java.util.Arrays;
import org.joml.Vector3d;

/**
 * Collects triangles in normalised device coordinates: x to the right and y up, -1..1, and z from -1, near, to 1,
 * far. The camera maps them to a square raster, so a larger raster shows the same scene enlarged. Not thread safe.
 */
final class ScreenTriangles {
    /** Looks along -z at the cube of -1..1, where far is z = -1. */
    static final Camera CAMERA = Camera.orthographic(
            new Vector3d(0.0, 0.0, 1.0), new Vector3d(0.0, 0.0, 0.0), new Vector3d(0.0, 1.0, 0.0), 2.0, 0.0, 2.0);

    private float[] positions = new float[3 * 1024];
    private byte[] rgb = new byte[3 * 1024];
    private int[] indices = new int[3 * 1024];
    private int vertexCount;
    private int indexCount;

    /** Adds a vertex and returns its number; colours are 0..255. */
    int vertex(double ndcX, double ndcY, double ndcZ, int red, int green, int blue) {
        if (3 * vertexCount == positions.length) {
            positions = Arrays.copyOf(positions, 2 * positions.length);
            rgb = Arrays.copyOf(rgb, 2 * rgb.length);
        }
        int at = 3 * vertexCount;
        positions[at] = (float) ndcX;
        positions[at + 1] = (float) ndcY;
        positions[at + 2] = (float) -ndcZ;
        rgb[at] = (byte) red;
        rgb[at + 1] = (byte) green;
        rgb[at + 2] = (byte) blue;
        return vertexCount++;
    }

    /** Adds a triangle of three vertex numbers. */
    void triangle(int a, int b, int c) {
        if (indexCount + 3 > indices.length) {
            indices = Arrays.copyOf(indices, 2 * indices.length);
        }
        indices[indexCount++] = a;
        indices[indexCount++] = b;
        indices[indexCount++] = c;
    }

    /** Returns the triangles added so far. */
    Triangles toTriangles(String id, Coloring coloring) {
        return new Triangles(
                id,
                Arrays.copyOf(positions, 3 * vertexCount),
                Arrays.copyOf(indices, indexCount),
                Arrays.copyOf(rgb, 3 * vertexCount),
                null,
                coloring,
                CAMERA);
    }
}
