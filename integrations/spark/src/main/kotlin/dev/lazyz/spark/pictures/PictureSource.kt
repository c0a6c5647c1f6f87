package dev.lazyz.spark.pictures

import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import java.io.Serializable

/**
 * Makes the frame of a picture. It is sent to all executors, and called once in each JVM; so it should name a scene (a
 * file that all can read, a built-in scene, some parameters) rather than hold it. All calls must return the same
 * picture. In Kotlin and Java it can be a lambda:
 *
 * ```
 * PictureSource { SuperSampling.NONE.of(Scenes.load(path).scene.frame(30000, 20000)) }
 * ```
 *
 * [SuperSampling] also gives frames of several samples a pixel.
 */
public fun interface PictureSource : Serializable {
    /** Returns the frame, for pixels of the whole picture. */
    @Throws(Exception::class)
    public fun picture(): SampledFrame
}

/** Calls [source] once in each JVM. Thread safe. */
internal class OncePerJvm(private val source: PictureSource) : Serializable {
    @Transient
    private var made: SampledFrame? = null

    @Synchronized
    fun picture(): SampledFrame = made ?: source.picture().also { made = it }

    /** Does the work of a task. A source that holds its frame is notified. */
    fun <T> rendering(work: (SampledFrame) -> T): T =
        if (source is TaskWitness) source.during { work(picture()) } else work(picture())
}

/** A source that wants to know when tasks run, and what they throw. */
internal interface TaskWitness {
    /** Does [work], the work of a task. */
    fun <T> during(work: () -> T): T
}
