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
