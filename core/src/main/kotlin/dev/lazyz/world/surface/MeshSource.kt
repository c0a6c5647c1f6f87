package dev.lazyz.world.surface

import dev.lazyz.geometry.Box
import org.joml.Vector3dc

/**
 * Triangles that are read part by part each time they are needed, for models that are larger than memory. Shown by a
 * [StreamedMesh].
 *
 * A part should have some 1,000 triangles that are close to each other. For a fitted camera, single parts are read; for
 * a rendering, as many at a time as have some 100,000 triangles. Implementations must return the same triangles each
 * time, and be thread safe. An exception ends the rendering and is rethrown unchanged.
 */
public interface MeshSource {
    /** Number of triangles of all parts. */
    public val triangleCount: Int

    /** Whether parts have colours of vertices. */
    public val hasColors: Boolean

    /** Number of parts. */
    public val partCount: Int

    /** The origin of the positions of all parts, see [Mesh.origin]. */
    public val origin: Vector3dc

    /** Returns the number of triangles of part [number], without reading it. */
    public fun triangleCount(number: Int): Int

    /**
     * Returns the smallest box around the vertices that the triangles of part [number] use, relative to [origin], or
     * null if there are none. A fitted camera and each rendering call it for all parts, so it should not read the part.
     */
    public fun bounds(number: Int): Box?

    /**
     * Reads [count] parts from number [first] on, and returns their triangles in order as one mesh. The triangles of
     * all parts are those of the whole mesh. The material of the result is not used, and its origin must be [origin].
     */
    public fun read(first: Int, count: Int): Mesh
}
