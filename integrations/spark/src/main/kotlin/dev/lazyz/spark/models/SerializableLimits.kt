package dev.lazyz.spark.models

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.ReferencePolicy
import java.io.Serializable
import java.time.Duration

/** The values of [LoadLimits], on their way to an executor. */
internal class SerializableLimits(limits: LoadLimits) : Serializable {
    private val decodedBytes: Long? = limits.decodedBytes
    private val triangles: Long = limits.triangles
    private val vertices: Long = limits.vertices
    private val texels: Long = limits.texels
    private val nesting: Int = limits.nesting
    private val time: Duration? = limits.time
    private val references: ReferencePolicy = limits.references
    private val items: Long = limits.items

    /** Returns the limits. */
    fun limits(): LoadLimits =
        LoadLimits(decodedBytes, triangles, vertices, texels, nesting, time, references, items = items)

    private companion object {
        const val serialVersionUID = 1L
    }
}
