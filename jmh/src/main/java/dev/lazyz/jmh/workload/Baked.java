package dev.lazyz.jmh.workload;

import dev.lazyz.Rgba;
import dev.lazyz.world.Scene;
import dev.lazyz.world.camera.Camera;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.surface.Mesh;
import dev.lazyz.world.surface.Polygon;
import dev.lazyz.world.surface.Polygon.Vertex;
import dev.lazyz.world.surface.Sphere;
import dev.lazyz.world.surface.Surface;
import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import java.util.List;
import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Converts any scene to {@link Triangles}, so that other renderers can draw scenes that were not made for benchmarks.
 *
 * <p>Either light is baked into vertex colours: a light source at the eye, and the material's colour. Or vertices have
 * the material's colour and a normal, and the renderer computes the light. Textures and highlights are omitted.
 * Shared vertices stay shared. A sphere becomes {@value #STEPS} by {@value #RINGS} quadrilaterals, a polygon a fan
 * around its first vertex. Not thread safe.
 */
public final class Baked {
    private static final int STEPS = 64;
    private static final int RINGS = 32;

    private final Camera camera;
    private final boolean isLit;
    private final ByteArrayOutputStream rgb = new ByteArrayOutputStream();
    private float[] positions = new float[0];
    private float[] normals = new float[0];
    private int[] indices = new int[0];

    private Baked(Camera camera, boolean isLit) {
        this.camera = camera;
        this.isLit = isLit;
    }

    /**
     * Returns the triangles of a scene, seen by the scene's camera on a square raster.
     *
     * @throws IllegalArgumentException if a surface is of a kind that cannot be converted to triangles
     */
    public static Triangles of(String id, Scene scene) {
        return of(id, scene, false);
    }

    /** Like {@link #of}, with normals and without light. */
    public static Triangles lit(String id, Scene scene) {
        return of(id, scene, true);
    }

    private static Triangles of(String id, Scene scene, boolean isLit) {
        Baked baked = new Baked(scene.camera(1, 1), isLit);
        for (Surface surface : scene.getSurfaces()) {
            baked.add(mesh(surface));
        }
        return new Triangles(
                id,
                baked.positions,
                baked.indices,
                baked.rgb.toByteArray(),
                isLit ? baked.normals : null,
                isLit ? Coloring.LIT : Coloring.SMOOTH,
                baked.camera);
    }

    private static Mesh mesh(Surface surface) {
        if (surface instanceof Mesh mesh) {
            return mesh.getNormals() == null ? mesh.withSmoothNormals() : mesh;
        }
        if (surface instanceof Sphere sphere) {
            return sphere(sphere);
        }
        if (surface instanceof Polygon polygon && polygon.getContours().size() == 1) {
            return fan(polygon.getContours().get(0), polygon.getMaterial()).withSmoothNormals();
        }
        throw new IllegalArgumentException("neither a mesh, a sphere nor a polygon of one contour: " + surface);
    }

    private static Mesh sphere(Sphere sphere) {
        int stride = STEPS + 1;
        float[] positions = new float[3 * stride * (RINGS + 1)];
        float[] normals = new float[positions.length];
        int[] triangles = new int[6 * STEPS * RINGS];
        int to = 0;
        int at = 0;
        for (int ring = 0; ring <= RINGS; ring++) {
            for (int step = 0; step <= STEPS; step++) {
                double polar = StrictMath.PI * ring / RINGS;
                double turn = 2 * StrictMath.PI * step / STEPS;
                Vector3d normal = new Vector3d(
                        StrictMath.sin(polar) * StrictMath.sin(turn),
                        StrictMath.cos(polar),
                        StrictMath.sin(polar) * StrictMath.cos(turn));
                for (int axis = 0; axis < 3; axis++) {
                    normals[to] = (float) normal.get(axis);
                    positions[to++] = (float) (sphere.getCenter().get(axis) + sphere.getRadius() * normal.get(axis));
                }
                if (ring < RINGS && step < STEPS) {
                    int corner = ring * stride + step;
                    for (int offset : new int[] {0, stride, stride + 1, 0, stride + 1, 1}) {
                        triangles[at++] = corner + offset;
                    }
                }
            }
        }
        return new Mesh(positions, triangles, sphere.getMaterial(), normals);
    }

    private static Mesh fan(List<Vertex> contour, Material material) {
        float[] positions = new float[3 * contour.size()];
        for (int i = 0; i < contour.size(); i++) {
            positions[3 * i] = (float) contour.get(i).getX();
            positions[3 * i + 1] = (float) contour.get(i).getY();
            positions[3 * i + 2] = (float) contour.get(i).getZ();
        }
        int[] triangles = new int[3 * (contour.size() - 2)];
        for (int i = 0; i < contour.size() - 2; i++) {
            triangles[3 * i + 1] = i + 1;
            triangles[3 * i + 2] = i + 2;
        }
        return new Mesh(positions, triangles, material);
    }

    private void add(Mesh mesh) {
        int first = positions.length / 3;
        positions = joined(positions, mesh.getPositions());
        normals = joined(normals, mesh.getNormals());
        int at = indices.length;
        indices = Arrays.copyOf(indices, at + mesh.getTriangles().length);
        for (int vertex : mesh.getTriangles()) {
            indices[at++] = first + vertex;
        }
        for (int vertex = 0; vertex < mesh.getVertexCount(); vertex++) {
            addColor(mesh, vertex);
        }
    }

    private static float[] joined(float[] first, float[] second) {
        float[] both = Arrays.copyOf(first, first.length + second.length);
        System.arraycopy(second, 0, both, first.length, second.length);
        return both;
    }

    private void addColor(Mesh mesh, int vertex) {
        double light = isLit ? 1 : light(mesh, vertex);
        Rgba base = mesh.getMaterial().getBaseColor();
        float[] own = mesh.getColors();
        float[] color = {base.getRed(), base.getGreen(), base.getBlue()};
        for (int i = 0; i < 3; i++) {
            double component = color[i] * light * (own == null ? 1 : own[4 * vertex + i]);
            rgb.write((int) (255 * Math.min(1, Math.max(0, component)) + 0.5));
        }
    }

    private double light(Mesh mesh, int vertex) {
        Vector3dc eye = camera.getEye();
        float[] p = mesh.getPositions();
        float[] n = mesh.getNormals();
        Vector3d toEye =
                new Vector3d(eye.x() - p[3 * vertex], eye.y() - p[3 * vertex + 1], eye.z() - p[3 * vertex + 2]);
        Vector3d normal = new Vector3d(n[3 * vertex], n[3 * vertex + 1], n[3 * vertex + 2]);
        double cosine = Math.abs(toEye.x * normal.x + toEye.y * normal.y + toEye.z * normal.z);
        double lengths = StrictMath.sqrt((toEye.x * toEye.x + toEye.y * toEye.y + toEye.z * toEye.z)
                * (normal.x * normal.x + normal.y * normal.y + normal.z * normal.z));
        return 0.2 + (lengths > 0 ? 0.8 * cosine / lengths : 0);
    }
}
