package dev.lazyz.world.surface

import dev.lazyz.geometry.Box
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Triangles that are read part by part each time they are needed, for models that are larger than memory. Shown by a
 * [StreamedMesh].
 *
 * Implementations must return the same triangles in the same order each time, and be thread safe. An exception from
 * [parts] ends the rendering and is rethrown unchanged.
 */
public interface MeshSource {
    /** Number of triangles of all parts. */
    public val triangleCount: Int

    /** The smallest box around all vertices that triangles use, or null if there is none. */
    public val bounds: Box?

    /** The origin of the positions of all parts, see [Mesh.origin]. */
    public val origin: Vector3dc

    /**
     * Returns the vertex that is farthest along [direction], as [Surface.farthest] does. The default looks at all
     * parts; a fitted camera calls it some 30 times.
     */
    public fun farthest(direction: Vector3dc): Vector3d? {
        val search = FarthestPoint(direction)
        for (part in parts()) part.farthest(direction)?.let { search.look(it) }
        return search.point
    }

    /**
     * Returns the triangles as meshes, in order, for one pass over them. A part should have 10,000 to 1,000,000
     * triangles: a few parts are in memory at the same time, and each takes some time of its own. The materials of the
     * parts are not used.
     */
    public fun parts(): Iterator<Mesh>
}
