package dev.lazyz.scenes.gltf.draco

import com.openize.drako.DataType
import com.openize.drako.Draco
import com.openize.drako.DracoMesh
import com.openize.drako.PointAttribute
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.loading.Source
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/** A mesh that was compressed with Draco and is decoded by the library drako. */
internal class DracoGeometry private constructor(private val mesh: DracoMesh, private val step: (Int) -> Unit) {
    /** Number of vertices. */
    val vertexCount: Int = mesh.numPoints

    /** Vertex numbers, three for each triangle. */
    val triangles: IntArray = IntArray(mesh.numFaces * 3) {
        step(1)
        mesh.readCorner(it)
    }

    /**
     * Returns the numbers of the attribute with the given [id], vertex by vertex, or null if there is none. If
     * [isNormalized], integers of 8 and 16 bits are returned as fractions.
     *
     * @throws DracoException if the data is damaged
     */
    fun floats(id: Int, isNormalized: Boolean): FloatArray? = guarded {
        val attribute = (0 until mesh.numAttributes).map { mesh.attribute(it) }
            .firstOrNull { it.uniqueId.toInt() and 0xFFFF == id } ?: return@guarded null
        val width = attribute.componentsCount
        val result = FloatArray(Math.multiplyExact(vertexCount, width))
        val row = ByteArray(attribute.byteStride)
        val bytes = ByteBuffer.wrap(row).order(ByteOrder.LITTLE_ENDIAN)
        for (vertex in 0 until vertexCount) {
            step(1)
            attribute.getValue(attribute.mappedIndex(vertex), row)
            for (i in 0 until width) result[vertex * width + i] = number(attribute, bytes, i, isNormalized)
        }
        result
    }

    private fun number(attribute: PointAttribute, bytes: ByteBuffer, i: Int, isNormalized: Boolean): Float {
        val (number, most) = when (attribute.dataType) {
            DataType.FLOAT32 -> return bytes.getFloat(4 * i)
            DataType.INT8 -> bytes.get(i).toFloat() to 127f
            DataType.UINT8 -> (bytes.get(i).toInt() and 0xFF).toFloat() to 255f
            DataType.INT16 -> bytes.getShort(2 * i).toFloat() to 32767f
            DataType.UINT16 -> (bytes.getShort(2 * i).toInt() and 0xFFFF).toFloat() to 65535f
            DataType.UINT32 -> return (bytes.getInt(4 * i).toLong() and 0xFFFFFFFFL).toFloat()
            DataType.INT32 -> return bytes.getInt(4 * i).toFloat()
            else -> throw DracoException("an attribute is of a kind that glTF does not have")
        }
        return if (isNormalized) maxOf(number / most, -1f) else number
    }

    companion object {
        /** Memory that drako needs for a triangle or a vertex while decoding, with a margin; measured. */
        private const val FACE_BYTES = 120L
        private const val VERTEX_BYTES = 120L

        /** Time limit: a base and an amount for each byte, about a thousand times what undamaged data needs. */
        private const val BASE_MILLISECONDS = 5_000L
        private const val MILLISECONDS_PER_BYTE = 1L

        private const val DAMAGED = "the compressed data is damaged"

        /** Limits the decoding time, because drako may not terminate on damaged data. */
        private val steps = EndlessSteps(2)

        /**
         * Decodes [bytes].
         *
         * @param milliseconds time limit, if it is shorter than the usual limit for data of this size; null for no such
         *   limit
         * @param step counts steps of work, see [Source.step]
         * @param allow called with a number of bytes before they are allocated; throws if they are too many
         * @throws DracoException if the data is damaged
         */
        fun decode(
            bytes: ByteArray,
            milliseconds: Long?,
            step: (Int) -> Unit = {},
            allow: (Long) -> Unit,
        ): DracoGeometry {
            val header = DracoHeader.read(bytes)
            allow(header.faces * FACE_BYTES + header.vertices * VERTEX_BYTES)
            val most = BASE_MILLISECONDS + bytes.size * MILLISECONDS_PER_BYTE
            return guarded {
                val mesh = steps.run(minOf(most, milliseconds ?: most)) { Draco.decode(bytes) }
                DracoGeometry(mesh as? DracoMesh ?: throw DracoException(DAMAGED), step)
            }
        }

        /**
         * Converts the exceptions that drako throws for damaged data: for an index, for a size, or for recursion that
         * is too deep.
         */
        private fun <T> guarded(step: () -> T): T = try {
            step()
        } catch (e: DracoException) {
            throw e
        } catch (e: SceneFormatException) {
            throw e
        } catch (e: Exception) {
            throw DracoException(DAMAGED, e)
        } catch (e: StackOverflowError) {
            throw DracoException(DAMAGED, e)
        }
    }
}

/**
 * Runs steps with a time limit. Java cannot stop a thread, so an abandoned step continues in the background, in a
 * daemon thread of the lowest priority. While the maximum number of abandoned steps are running, no further step is
 * started.
 *
 * @param most maximum number of abandoned steps that are still running
 */
internal class EndlessSteps(private val most: Int) {
    private val abandoned = ArrayList<Thread>()

    /**
     * Returns what [step] returns, or throws what it throws.
     *
     * @throws DracoException if the step takes more than [milliseconds], if too many abandoned steps are still running,
     *   or if the calling thread is interrupted
     */
    fun <T> run(milliseconds: Long, step: () -> T): T {
        if (countRunning() >= most) {
            throw DracoException("the decoder is still busy with damaged data; start the program again")
        }
        val task = FutureTask(step)
        val thread = Thread(task, "lazyz-draco")
        thread.isDaemon = true
        thread.start()
        try {
            return task.get(milliseconds, TimeUnit.MILLISECONDS)
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        } catch (e: TimeoutException) {
            abandon(thread)
            throw DracoException("the compressed data is damaged, or takes more than $milliseconds ms to decode", e)
        } catch (e: InterruptedException) {
            abandon(thread)
            Thread.currentThread().interrupt()
            throw DracoException("the thread was interrupted", e)
        }
    }

    private fun abandon(thread: Thread) {
        synchronized(abandoned) { abandoned.add(thread) }
        thread.priority = Thread.MIN_PRIORITY
    }

    private fun countRunning(): Int = synchronized(abandoned) {
        abandoned.removeAll { !it.isAlive }
        abandoned.size
    }
}
