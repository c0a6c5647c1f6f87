package dev.lazyz.scenes.loading

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.world.material.Texture
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Surface
import java.nio.file.Path
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * One call of `Scenes.load`: its [options], the amount of each limit that is used so far, and the textures that it
 * has read. All sources of the call share this object. Not thread safe.
 */
internal class Loading(val options: LoadOptions = LoadOptions()) {
    val limits: LoadLimits = options.limits

    /** Textures by the real path of the file; null for a texture that cannot be decoded. */
    val textures: MutableMap<Path, Texture?> = HashMap()

    /** The files that the sources refer to; reported by [LoadedScene.files]. */
    val files: MutableSet<Path> = LinkedHashSet()

    private val start = System.nanoTime()
    private var read = 0L

    /** Steps of work that are left before the next [look]. */
    private var stepsLeft = 0

    /** The amounts that are used so far. A reader that discards its result sets them back. */
    var used: UsedAmounts = UsedAmounts()

    /** Milliseconds left for reading; null without a limit. */
    val millisecondsLeft: Long?
        get() = limits.time?.let { maxOf(it.toMillis() - (System.nanoTime() - start) / NANOSECONDS, 0) }

    /** Records that [bytes] bytes of a file were read. */
    fun read(bytes: Int) {
        read += bytes
    }

    /** Adds [count] vertices; fails if [source] then exceeds a limit. Call it before allocating memory for them. */
    fun vertices(source: Source, count: Long): Unit = vertices(source, count, VERTEX_BYTES)

    /** Adds [count] vertices that are not kept in memory; fails if [source] then exceeds a limit. */
    fun streamedVertices(source: Source, count: Long): Unit = vertices(source, count, 0)

    private fun vertices(source: Source, count: Long, bytes: Long) {
        used = used.copy(vertices = used.vertices + count)
        check(source, used.vertices, limits.vertices, "vertices", "vertices", "--max-vertices", moreMemory(bytes))
        decode(source, count * bytes)
    }

    /** Adds [count] triangles; fails if [source] then exceeds a limit. Call it before allocating memory for them. */
    fun triangles(source: Source, count: Long): Unit = triangles(source, count, TRIANGLE_BYTES)

    /** Adds [count] triangles that are not kept in memory; fails if [source] then exceeds a limit. */
    fun streamed(source: Source, count: Long): Unit = triangles(source, count, 0)

    private fun triangles(source: Source, count: Long, bytes: Long) {
        used = used.copy(triangles = used.triangles + count)
        check(source, used.triangles, limits.triangles, "triangles", "triangles", "--max-triangles", moreMemory(bytes))
        decode(source, count * bytes)
    }

    /** Like [triangles], for [count] line segments, each of which counts as a triangle. */
    fun segments(source: Source, count: Long): Unit = triangles(source, count)

    /**
     * Adds [count] items: parts that a file names or lists, other than triangles, vertices and texels. Fails if
     * [source] then exceeds a limit.
     */
    fun items(source: Source, count: Long) {
        used = used.copy(items = used.items + count)
        val what = "items such as objects and materials"
        check(source, used.items, limits.items, what, "items", "--max-items", MORE_MEMORY)
        decode(source, count * ITEM_BYTES)
    }

    /**
     * Adds [count] texels, for which a decoder needs so many bytes; fails if [source] then exceeds a limit. Call it
     * before allocating memory for them.
     */
    fun texels(source: Source, count: Long, decoding: Long = count * DECODING_BYTES) {
        used = used.copy(texels = used.texels + count)
        check(source, used.texels, limits.texels, "pixels of textures", "texels", "--max-texels", MORE_MEMORY)
        used = used.copy(decoding = maxOf(used.decoding, decoding))
        decode(source, count * TEXEL_BYTES)
    }

    /** Adds decoded [bytes]; fails if [source] then exceeds a limit. Call it before allocating memory for them. */
    fun decode(source: Source, bytes: Long) {
        used = used.copy(decoded = used.decoded + bytes)
        val most = limits.decodedBytes ?: LoadLimits.defaultDecodedBytes(read, limits.usableMemory)
        val memory = used.decoded + used.decoding
        if (limits.decodedBytes == null && memory > most) {
            val problem = "has more than $most bytes of decoded data: $memory at least"
            source.exhausted(problem, remedy("decodedBytes", "--max-decoded", MORE_MEMORY))
        }
        check(source, memory, most, "bytes of decoded data", "decodedBytes", "--max-decoded", MORE_MEMORY)
        look(source.name)
    }

    /**
     * Counts [steps] of work on [source], each about as long as reading a word. Some thousands of steps after the last
     * [look], looks again. Every loop that is as long as the input says calls this.
     */
    fun step(source: Source, steps: Int) {
        stepsLeft -= steps
        if (stepsLeft < 0) look(source.name)
    }

    /** Fails if the thread is interrupted or the time is over. [name] is the name of what is being read. */
    fun look(name: String) {
        stepsLeft = STEPS
        if (Thread.currentThread().isInterrupted) {
            throw SceneFormatException(name, null, INTERRUPTED)
        }
        val time = limits.time ?: return
        if (System.nanoTime() - start >= time.toNanos()) {
            exceeded(name, "takes more than ${time.toMillis()} ms to read", "time", "--max-seconds", "")
        }
    }

    /**
     * Returns [mesh] with smooth normals, or [mesh] itself if it has normals or the options disable smooth normals.
     * Fails if the memory is too small.
     */
    fun smoothed(source: Source, mesh: Mesh, creaseAngle: Double): Mesh {
        if (mesh.normals != null || !options.smoothNormals) return mesh
        val need = NORMALS_OF_TRIANGLE * mesh.triangleCount + NORMALS_OF_VERTEX * mesh.vertexCount
        val most = limits.usableMemory
        if (need > most) {
            val problem = "has too many triangles for the memory: their normals need $need bytes, Java may use $most"
            source.exhausted(problem, "raise -Xmx, or LoadOptions(smoothNormals = false)")
        }
        return mesh.withSmoothNormals(creaseAngle) { look(source.name) }
    }

    /** What else may be needed for more elements of [bytes] each; nothing, if they are not kept in memory. */
    private fun moreMemory(bytes: Long): String = if (bytes > 0) MORE_MEMORY else ""

    private fun check(
        source: Source,
        used: Long,
        most: Long,
        what: String,
        limit: String,
        flag: String,
        memory: String,
    ) {
        if (used > most) exceeded(source.name, "has more than $most $what: $used at least", limit, flag, memory)
    }

    private fun exceeded(name: String, problem: String, limit: String, flag: String, memory: String): Nothing =
        throw SceneFormatException(name, null, problem, remedy(limit, flag, memory))

    private fun remedy(limit: String, flag: String, memory: String): String =
        "if it can be trusted, raise LoadLimits.$limit (zcli: $flag)$memory"

    companion object {
        /** What happens to a file when its thread is interrupted. */
        const val INTERRUPTED: String = "is not read further: the thread is interrupted"

        /** Remedy for JSON that is nested too deeply. */
        const val NESTING_REMEDY: String = "if it can be trusted, raise LoadLimits.nesting (zcli: --max-nesting)"

        /** Bytes for computing smooth normals, including the mesh; measured. */
        private const val NORMALS_OF_TRIANGLE = 36L
        private const val NORMALS_OF_VERTEX = 50L

        /** What else may be needed where a limit is on what is kept in memory. */
        private const val MORE_MEMORY = ", and -Xmx if need be"

        /** Nanoseconds per millisecond. */
        private const val NANOSECONDS = 1_000_000L

        /** Steps of work between two looks at the clock and the interrupt: some milliseconds at most. */
        private const val STEPS = 1 shl 12

        private const val TRIANGLE_BYTES = 12L
        private const val VERTEX_BYTES = 32L
        private const val ITEM_BYTES = 64L

        /** A texel and its part of the mip levels. */
        private const val TEXEL_BYTES = 6L

        /** A pixel of the decoder's image, of which there is only one at a time. */
        const val DECODING_BYTES: Long = 6
    }
}

/**
 * Amounts that count towards the limits of [LoadLimits]. Immutable.
 *
 * @property decoding bytes that are needed only while the largest texture is decoded
 */
internal data class UsedAmounts(
    val decoded: Long = 0,
    val triangles: Long = 0,
    val vertices: Long = 0,
    val texels: Long = 0,
    val items: Long = 0,
    val decoding: Long = 0,
)

/** Keeps the precision of files whose decimal or 64-bit positions are far from the world's origin. */
internal object FarOrigin {
    /**
     * Returns the result of [read], whose argument is the vector that [read] subtracts from all positions. First the
     * vector is zero. If the model is so far from the origin that 32-bit positions are too coarse, the result is
     * discarded, and the file is read again with the model's centre subtracted. It counts towards the limits of
     * [loading] once.
     *
     * @param bounds the bounding box of a result, or null if it is empty
     */
    fun <T : Any> reading(loading: Loading, read: (Vector3dc) -> T, bounds: (T) -> Box?): T {
        val before = loading.used
        val first = First(read(Vector3d()))
        val origin = bounds(first.found())?.origin()
        if (origin == null || origin == Vector3d()) return first.found()
        first.drop()
        loading.used = before
        return read(origin)
    }

    /** Holds the first result. A local variable would keep it in memory until the call ends. */
    private class First<T : Any>(private var found: T?) {
        fun found(): T = checkNotNull(found)

        fun drop() {
            found = null
        }
    }
}

/** Names of parts, see [Surface.name]. */
internal object PartNames {
    /** In characters: a name in the file can be long, and many parts can be inside the part that has it. */
    const val LONGEST: Int = 1000

    private const val CUT = "..."

    /**
     * Returns the path of the part [name] in the part with the path [parent]; either can be empty. A path with more
     * than [LONGEST] characters loses its beginning.
     */
    fun path(parent: String, name: String?): String {
        if (name.isNullOrBlank()) return parent
        val own = name.trim().takeLast(LONGEST + 1)
        val path = if (parent.isEmpty()) own else "${parent.takeLast(LONGEST)}/$own"
        return if (path.length <= LONGEST) path else CUT + path.takeLast(LONGEST - CUT.length)
    }

    /** Returns the memory of [path]. */
    fun bytes(path: String): Long = 2L * path.length
}
