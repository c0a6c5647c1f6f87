package dev.lazyz.scenes

import java.time.Duration

/**
 * Options for reading a scene. Immutable.
 *
 * @property limits limits on what the file can request
 * @property animationTime the time in the file's first animation at which to show the model, in seconds from the
 *   start of the animation. A time before the first keyframe shows the first keyframe, a time after the last shows
 *   the last. Null, the default, shows the model at rest, without its animations. Only glTF files have animations
 * @property smoothNormals whether meshes without normals in the file get smooth normals, except at the creases that
 *   the file's format defines. If false, each triangle has its own normal, and reading takes less time and memory
 * @property variant the name of the variant whose materials are shown (`KHR_materials_variants`). Null, the default,
 *   shows the materials without variants. Only glTF files have variants
 * @property sceneNumber the scene of a glTF file that is shown, from 0. Null, the default, shows the default scene
 * @throws IllegalArgumentException if [animationTime] is negative, infinite, or not a number, or [sceneNumber]
 *   is negative
 */
public class LoadOptions @JvmOverloads constructor(
    public val limits: LoadLimits = LoadLimits(),
    public val animationTime: Double? = null,
    public val smoothNormals: Boolean = true,
    public val variant: String? = null,
    public val sceneNumber: Int? = null,
) {
    init {
        require(sceneNumber == null || sceneNumber >= 0) { "sceneNumber must be 0 or more: $sceneNumber" }
        require(animationTime == null || (animationTime >= 0.0 && animationTime.isFinite())) {
            "animationTime must be 0 or more: $animationTime"
        }
    }

    /** Returns these options with other limits. */
    public fun withLimits(limits: LoadLimits): LoadOptions = copy(limits = limits)

    /** Returns these options with a time in the file's first animation, in seconds, 0 or more. */
    public fun withAnimationTime(animationTime: Double): LoadOptions = copy(animationTime = animationTime)

    /** Returns these options for a model at rest, without its animations. */
    public fun withoutAnimationTime(): LoadOptions = copy(animationTime = null)

    /** Returns these options with smooth normals for meshes without normals in the file. */
    public fun withSmoothNormals(): LoadOptions = copy(smoothNormals = true)

    /** Returns these options without smooth normals: each triangle has its own normal. */
    public fun withoutSmoothNormals(): LoadOptions = copy(smoothNormals = false)

    /** Returns these options with the name of a variant, or without one. */
    public fun withVariant(variant: String?): LoadOptions = copy(variant = variant)

    /** Returns these options with the number of a scene, 0 or more, or for the default scene. */
    public fun withSceneNumber(sceneNumber: Int?): LoadOptions = copy(sceneNumber = sceneNumber)

    private fun copy(
        limits: LoadLimits = this.limits,
        animationTime: Double? = this.animationTime,
        smoothNormals: Boolean = this.smoothNormals,
        variant: String? = this.variant,
        sceneNumber: Int? = this.sceneNumber,
    ): LoadOptions = LoadOptions(limits, animationTime, smoothNormals, variant, sceneNumber)

    override fun toString(): String =
        "LoadOptions($limits, animationTime=$animationTime, smoothNormals=$smoothNormals, variant=$variant, " +
            "sceneNumber=$sceneNumber)"
}

/** Which files a model or a scene file may refer to. */
public enum class ReferencePolicy {
    /** Files in the model's own folder and its subfolders, symbolic links resolved; other files count as missing. */
    WITHIN_FOLDER,

    /** All files that this process can read. Only for models from a trusted source. */
    ANYWHERE,
}

/**
 * Limits on what a model can request, so that a small file cannot fill the memory of a server.
 *
 * Each limit applies to everything that one call of `Scenes.load` reads: a scene file together with its meshes and
 * textures. A file that exceeds a limit is refused before the memory is allocated, with a [SceneFormatException] that
 * names the limit. The defaults suit files from untrusted sources; raise them for larger models. Immutable.
 *
 * @property decodedBytes maximum total bytes of decoded data, including the memory that decoding takes: 12 for a
 *   triangle, 32 for a vertex, 6 for a texel, and 6 more for each texel of the largest texture. By default the result
 *   of [defaultDecodedBytes]
 * @property triangles maximum total number of triangles; a line segment counts as one
 * @property vertices maximum total number of vertices, including points
 * @property texels maximum total number of texture pixels
 * @property nesting maximum depth of nested lists and objects in a scene file, glTF or 3MF, 1..1000
 * @property time maximum time for reading, on the clock on the wall. It is checked between steps of the work, so a call
 *   can take slightly longer. Null, the default, means no limit
 * @property references which files a model can refer to
 * @property memory the memory that Java may use while the model is read, in bytes, to which files and decoded data must
 *   be in proportion. Null, the default, means the maximum Java heap size, which also is the most that counts
 * @property items maximum total number of items: the parts that files name or list, such as objects, materials,
 *   statements `o` and `newmtl`, nodes and all other objects of JSON, elements and properties of PLY, solids of STL,
 *   files and resources of 3MF. An item also counts as 64 bytes of decoded data
 * @property spoolBytes maximum total bytes of temporary files, which models that are read part by part, and archives,
 *   may need. Null, the default, means no limit but the free space of the folder
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
    public val memory: Long? = null,
    public val spoolBytes: Long? = null,
    public val items: Long = DEFAULT_ITEMS,
) {
    /** The memory that counts. */
    internal val usableMemory: Long get() = minOf(memory ?: Long.MAX_VALUE, Runtime.getRuntime().maxMemory())

    init {
        require(decodedBytes == null || decodedBytes >= 0) { "decodedBytes must not be negative: $decodedBytes" }
        require(triangles >= 0) { "triangles must not be negative: $triangles" }
        require(vertices >= 0) { "vertices must not be negative: $vertices" }
        require(texels >= 0) { "texels must not be negative: $texels" }
        require(items >= 0) { "items must not be negative: $items" }
        require(nesting in 1..MOST_NESTING) { "nesting must be in 1..$MOST_NESTING: $nesting" }
        require(memory == null || memory >= 0) { "memory must not be negative: $memory" }
        require(spoolBytes == null || spoolBytes >= 0) { "spoolBytes must not be negative: $spoolBytes" }
        require(time == null || !time.isNegative) { "time must not be negative: $time" }
    }

    /** Returns these limits with another limit for bytes of decoded data. */
    public fun withDecodedBytes(decodedBytes: Long): LoadLimits = copy(decodedBytes = decodedBytes)

    /** Returns these limits with the default limit for bytes of decoded data, see [defaultDecodedBytes]. */
    public fun withDefaultDecodedBytes(): LoadLimits = copy(decodedBytes = null)

    /** Returns these limits with another limit for triangles. */
    public fun withTriangles(triangles: Long): LoadLimits = copy(triangles = triangles)

    /** Returns these limits with another limit for vertices. */
    public fun withVertices(vertices: Long): LoadLimits = copy(vertices = vertices)

    /** Returns these limits with another limit for texture pixels. */
    public fun withTexels(texels: Long): LoadLimits = copy(texels = texels)

    /** Returns these limits with another limit for nested lists and objects, 1..1000. */
    public fun withNesting(nesting: Int): LoadLimits = copy(nesting = nesting)

    /** Returns these limits with another limit for time, or without one if null. */
    public fun withTime(time: Duration?): LoadLimits = copy(time = time)

    /** Returns these limits with another rule for the files that a model refers to. */
    public fun withReferences(references: ReferencePolicy): LoadLimits = copy(references = references)

    /** Returns these limits with another amount of memory, in bytes. */
    public fun withMemory(memory: Long): LoadLimits = copy(memory = memory)

    /** Returns these limits with the default amount of memory, the maximum Java heap size. */
    public fun withDefaultMemory(): LoadLimits = copy(memory = null)

    /** Returns these limits with another limit for temporary files, in bytes. */
    public fun withSpoolBytes(spoolBytes: Long): LoadLimits = copy(spoolBytes = spoolBytes)

    /** Returns these limits without a limit for temporary files. */
    public fun withoutSpoolLimit(): LoadLimits = copy(spoolBytes = null)

    /** Returns these limits with another limit for items. */
    public fun withItems(items: Long): LoadLimits = copy(items = items)

    private fun copy(
        decodedBytes: Long? = this.decodedBytes,
        triangles: Long = this.triangles,
        vertices: Long = this.vertices,
        texels: Long = this.texels,
        nesting: Int = this.nesting,
        time: Duration? = this.time,
        references: ReferencePolicy = this.references,
        memory: Long? = this.memory,
        spoolBytes: Long? = this.spoolBytes,
        items: Long = this.items,
    ): LoadLimits =
        LoadLimits(decodedBytes, triangles, vertices, texels, nesting, time, references, memory, spoolBytes, items)

    override fun toString(): String =
        "LoadLimits(decodedBytes=$decodedBytes, triangles=$triangles, vertices=$vertices, texels=$texels, " +
            "nesting=$nesting, time=$time, $references, memory=$memory, spoolBytes=$spoolBytes, items=$items)"

    public companion object {
        /** The default of [nesting]. */
        public const val DEFAULT_NESTING: Int = 64

        /** The default of [items]. */
        public const val DEFAULT_ITEMS: Long = 1_000_000

        private const val MOST_NESTING = 1000
        private const val FREE_BYTES = 128L shl 20
        private const val BYTES_PER_BYTE = 512L

        /**
         * The default limit of decoded data: 128 MiB plus 512 bytes for each byte that is read, but at most half of
         * [memory], the maximum Java heap size by default. Normal files need about 2 to 50 bytes for each byte.
         */
        @JvmStatic
        @JvmOverloads
        public fun defaultDecodedBytes(bytesRead: Long, memory: Long = Runtime.getRuntime().maxMemory()): Long =
            minOf(FREE_BYTES + bytesRead * BYTES_PER_BYTE, memory / 2)
    }
}
