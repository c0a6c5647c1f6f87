package dev.lazyz.scenes.teapot

/**
 * Triangles of the teapot, y up, right-handed, counter-clockwise seen from outside.
 *
 * The arrays belong to the mesh and are not copied: callers must not change them.
 *
 * @property positions x, y, z per vertex. No coordinate is -0.
 * @property normals x, y, z per vertex, of unit length, pointing outward.
 * @property uvs u, v per vertex in 0..1. Each patch covers the whole square. Seen from outside, u runs to the right
 *   and v up the chain of patches, so that a texture is never mirrored.
 * @property triangles three vertex numbers per triangle.
 */
internal class TeapotMesh(
    val positions: FloatArray,
    val normals: FloatArray,
    val uvs: FloatArray,
    val triangles: IntArray,
) {
    val vertexCount: Int get() = positions.size / 3

    val triangleCount: Int get() = triangles.size / 3

    override fun toString(): String = "TeapotMesh($vertexCount vertices, $triangleCount triangles)"
}

/** The Utah teapot as triangles. For the control points and their source see [TeapotControlPoints]. */
internal object Teapot {
    /** The finest tessellation: about two million vertices. */
    const val MAX_SEGMENTS: Int = 256

    /**
     * Divides each side of each of the 32 patches into [segments].
     *
     * With n [segments] there are `32 (n + 1)^2` vertices, patch after patch in the order of [TeapotPatches.all], and
     * `64 n^2 - 8 n` triangles; the missing `8 n` are degenerate, at the knob and at the centre of the bottom, and
     * are omitted. Neighbouring patches have separate vertices along their common border, at positions that are bit
     * for bit the same.
     *
     * The published axes (x, y, z), z up, become (x, z, -y), y up: the pot stands on y = 0, with the spout towards
     * +x. Heights are as published. The surface is open between rim and lid, at both ends of the handle, where the
     * spout enters the body, and inside the lip of the spout. The inside is visible through the gap at the rim and
     * through the mouth of the spout.
     *
     * Cost: linear in the number of vertices. Thread-safe; every call returns a new mesh.
     *
     * @throws IllegalArgumentException if [segments] is not in 1..[MAX_SEGMENTS].
     */
    fun tessellate(segments: Int): TeapotMesh {
        require(segments in 1..MAX_SEGMENTS) { "segments must be in 1..$MAX_SEGMENTS: $segments" }
        return TeapotTessellation(segments, TeapotPatches.all).mesh
    }
}
