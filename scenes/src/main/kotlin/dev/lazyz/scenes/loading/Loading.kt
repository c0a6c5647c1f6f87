package dev.lazyz.scenes.loading

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.Scenes
import dev.lazyz.world.material.Texture
import dev.lazyz.world.surface.Mesh
import java.nio.file.Path

/**
 * One call of [Scenes.load]: its [options], the amount of each limit that is used so far, and the textures that it
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

    /** Adds [count] texels; fails if [source] then exceeds a limit. Call it before allocating memory for them. */
    fun texels(source: Source, count: Long) {
        used = used.copy(texels = used.texels + count)
        check(source, used.texels, limits.texels, "pixels of textures", "texels", "--max-texels", MORE_MEMORY)
        used = used.copy(decoding = maxOf(used.decoding, count * DECODING_BYTES))
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
        if (Thread.currentThread().isInterrupted) source.fail(null, "is not read further: the thread is interrupted")
        val time = limits.time ?: return
        if (System.nanoTime() - start >= time.toNanos()) {
            exceeded(source, "takes more than ${time.toMillis()} ms to read", "time", "--max-seconds", "")
        }
    }

    /**
     * Returns [mesh] with smooth normals, or [mesh] itself if it has normals or the options disable smooth normals.
     * Fails if the memory is too small.
     */
    fun smoothed(source: Source, mesh: Mesh, creaseAngle: Double): Mesh {
        if (mesh.normals != null || !options.smoothNormals) return mesh
        val need = LoadingMemory.normals(mesh.triangleCount.toLong(), mesh.vertexCount.toLong())
        val most = limits.usableMemory
        if (need > most) {
            val problem = "has too many triangles for the memory: their normals need $need bytes, Java may use $most"
            source.exhausted(problem, "raise -Xmx, or LoadOptions(smoothNormals = false)")
        }
        return mesh.withSmoothNormals(creaseAngle)
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
        if (used > most) exceeded(source, "has more than $most $what: $used at least", limit, flag, memory)
    }

    private fun exceeded(source: Source, problem: String, limit: String, flag: String, memory: String): Nothing =
        source.fail(null, problem, remedy(limit, flag, memory))

    private fun remedy(limit: String, flag: String, memory: String): String =
        "if it can be trusted, raise LoadLimits.$limit (zcli: $flag)$memory"

    companion object {
        /** Remedy for JSON that is nested too deeply. */
        const val NESTING_REMEDY: String = "if it can be trusted, raise LoadLimits.nesting (zcli: --max-nesting)"

        /** What else may be needed where a limit is on what is kept in memory. */
        private const val MORE_MEMORY = ", and -Xmx if need be"

        /** Nanoseconds per millisecond. */
        private const val NANOSECONDS = 1_000_000L

        private const val TRIANGLE_BYTES = 12L
        private const val VERTEX_BYTES = 32L

        /** A texel and its part of the mip levels. */
        private const val TEXEL_BYTES = 6L

        /** The decoder's image, of which there is only one at a time. */
        private const val DECODING_BYTES = 6L
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
    val decoding: Long = 0,
)
