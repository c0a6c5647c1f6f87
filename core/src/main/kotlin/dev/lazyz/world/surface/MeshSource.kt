package dev.lazyz.world.surface

import dev.lazyz.geometry.Box
import org.joml.Vector3dc

/**
 * Triangles that are read part by part each time they are needed, for models that are larger than memory. Shown by a
 * [StreamedMesh].
 *
 * A part should have 5,000 to 500,000 triangles: a few parts are in memory at the same time, and each takes some time
 * of its own. Implementations must return the same triangles each time, and be thread safe. An exception ends the
 * rendering and is rethrown unchanged.
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
     * Returns part [number], 0 until [partCount]. The triangles of all parts, in order, are those of the whole mesh.
     * The materials of the parts are not used, and their origins must be [origin].
     */
    public fun part(number: Int): Mesh
}
