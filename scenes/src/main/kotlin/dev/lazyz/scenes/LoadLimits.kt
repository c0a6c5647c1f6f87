package dev.lazyz.scenes

import java.time.Duration

/** Which files a model or a scene file may refer to. */
public enum class ReferencePolicy {
    /** Files within the model's own folder and the folders in it, symbolic links resolved; others count as missing. */
    WITHIN_FOLDER,

    /** Files anywhere that this process may read. Only for models from a source that one trusts. */
    ANYWHERE,
}

/**
 * How much a model may ask for, so that a small file cannot fill the memory of a server.
 *
 * Each limit is for all that one call of [Scenes.load] reads: a scene file together with its meshes and textures. What
 * exceeds a limit is refused before memory is allocated for it, by a [SceneFormatException] that names the limit. The
 * defaults suit files from strangers; what is wrong with a larger model is that it is larger. Immutable.
 *
 * @property decodedBytes most bytes of decoded data in all, with what decoding takes: 12 for a triangle, 32 for a vertex,
 *   12 for a texel. By default what [defaultDecodedBytes] says
 * @property triangles most triangles in all; a segment of a line counts as one
 * @property vertices most vertices in all, points among them
 * @property texels most pixels of textures in all
 * @property nesting most lists and objects within each other in a scene file, glTF or 3MF
 * @property time most time for reading; looked at between steps of the work, so that a call may take a little longer. Null,
 *   the default, is no limit
 * @property references which files a model may refer to
 * @throws IllegalArgumentException if a limit is negative, or [nesting] is not in 1..1000
 */
public class LoadLimits @JvmOverloads constructor(
    public val decodedBytes: Long? = null,
    public val triangles: Long = Long.MAX_VALUE,
    public val vertices: Long = Long.MAX_VALUE,
    public val texels: Long = Long.MAX_VALUE,
    public val nesting: Int = DEFAULT_NESTING,
    public val time: Duration? = null,
    public val references: ReferencePolicy = ReferencePolicy.WITHIN_FOLDER,
) {
    init {
        require(decodedBytes == null || decodedBytes >= 0) { "decodedBytes must not be negative: $decodedBytes" }
        require(triangles >= 0) { "triangles must not be negative: $triangles" }
        require(vertices >= 0) { "vertices must not be negative: $vertices" }
        require(texels >= 0) { "texels must not be negative: $texels" }
        require(nesting in 1..MOST_NESTING) { "nesting must be in 1..$MOST_NESTING: $nesting" }
        require(time == null || !time.isNegative) { "time must not be negative: $time" }
    }

    /** Returns these limits with another one for bytes of decoded data, or with the default. */
    public fun withDecodedBytes(decodedBytes: Long?): LoadLimits = copy(decodedBytes = decodedBytes)

    /** Returns these limits with another one for triangles. */
    public fun withTriangles(triangles: Long): LoadLimits = copy(triangles = triangles)

    /** Returns these limits with another one for vertices. */
    public fun withVertices(vertices: Long): LoadLimits = copy(vertices = vertices)

    /** Returns these limits with another one for pixels of textures. */
    public fun withTexels(texels: Long): LoadLimits = copy(texels = texels)

    /** Returns these limits with another one for nested lists and objects, 1..1000. */
    public fun withNesting(nesting: Int): LoadLimits = copy(nesting = nesting)

    /** Returns these limits with another one for time, or without one. */
    public fun withTime(time: Duration?): LoadLimits = copy(time = time)

    /** Returns these limits with another rule for files that a model refers to. */
    public fun withReferences(references: ReferencePolicy): LoadLimits = copy(references = references)

    private fun copy(
        decodedBytes: Long? = this.decodedBytes,
        triangles: Long = this.triangles,
        vertices: Long = this.vertices,
        texels: Long = this.texels,
        nesting: Int = this.nesting,
        time: Duration? = this.time,
        references: ReferencePolicy = this.references,
    ): LoadLimits = LoadLimits(decodedBytes, triangles, vertices, texels, nesting, time, references)

    override fun toString(): String =
        "LoadLimits(decodedBytes=$decodedBytes, triangles=$triangles, vertices=$vertices, texels=$texels, " +
            "nesting=$nesting, time=$time, $references)"

    public companion object {
        /** The default of [nesting]. */
        public const val DEFAULT_NESTING: Int = 64

        private const val MOST_NESTING = 1000
        private const val FREE_BYTES = 128L shl 20
        private const val BYTES_PER_BYTE = 512L

        /**
         * The limit of decoded data where none is set: 128 MiB and 512 bytes for each byte that is read, but no more than
         * half of the memory that Java may use. Honest files need some 2 to 50 bytes for a byte.
         */
        @JvmStatic
        public fun defaultDecodedBytes(bytesRead: Long): Long =
            minOf(FREE_BYTES + bytesRead * BYTES_PER_BYTE, Runtime.getRuntime().maxMemory() / 2)
    }
}
