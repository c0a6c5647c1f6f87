package dev.lazyz.scenes.teapot

/** The Utah teapot as triangles. Its numbers and their source: [TeapotControlPoints]. */
internal object Teapot {
    /** The finest tessellation: some two million vertices. */
    const val MAX_SEGMENTS: Int = 256

    /**
     * Cuts each side of each of the 32 patches into [segments].
     *
     * With n [segments] there are `32 (n + 1)^2` vertices, patch after patch in the order of [TeapotPatches.all], and
     * `64 n^2 - 8 n` triangles; the missing `8 n` have collapsed at the knob and at the centre of the bottom.
     * Neighbouring patches have vertices of their own along the common border, in the same positions bit for bit.
     *
     * The published axes (x, y, z), z up, become (x, z, -y), y up: the pot stands on y = 0, spout towards +x. Heights are
     * as published. The surface is open between rim and lid, at both ends of the handle, where the spout enters the body,
     * and inside its lip; through the gap at the rim and the mouth of the spout its inside is seen.
     *
     * Cost: linear in the number of vertices. Thread-safe; every call returns a mesh of its own.
     *
     * @throws IllegalArgumentException if [segments] is not in 1..[MAX_SEGMENTS].
     */
    fun tessellate(segments: Int): TeapotMesh {
        require(segments in 1..MAX_SEGMENTS) { "segments must be in 1..$MAX_SEGMENTS: $segments" }
        return TeapotTessellation(segments, TeapotPatches.all).mesh
    }
}
