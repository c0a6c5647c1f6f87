package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.json.JsonWriter
import org.joml.Vector3d
import org.joml.Vector3dc

private val WORLD_ORIGIN = Vector3d()

internal fun JsonWriter.vector(v: Vector3dc) = doubles(v.x(), v.y(), v.z())

/** Writes the key `origin`, unless it is the world's origin. */
internal fun JsonWriter.origin(origin: Vector3dc) {
    if (origin != WORLD_ORIGIN) key("origin").vector(origin)
}
