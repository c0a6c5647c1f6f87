package dev.lazyz.world

import dev.lazyz.world.material.MetallicRoughness
import org.joml.Vector3dc

/**
 * All light of a scene, and how it becomes the colours of a picture.
 *
 * @property classical the lights of materials without [MetallicRoughness]
 * @property physical the lights of materials with it
 * @property environment what the latter reflect besides
 * @property toneMapping exposure and tone curve
 * @property visibility which part of ambient light and of the environment reaches a point; null for all of it
 */
internal class SceneLight(
    val classical: List<Light>,
    val physical: List<Light>,
    val environment: Environment,
    val toneMapping: ToneMapping,
    val visibility: AmbientVisibility?,
) {
    /** The same lights for all materials, without an environment and without tone mapping. */
    constructor(lights: List<Light>) : this(lights, lights, Environment.NONE, ToneMapping.NONE, null)

    /** Returns the same light relative to [origin]. */
    fun relativeTo(origin: Vector3dc): SceneLight = SceneLight(
        classical.map { it.relativeTo(origin) },
        physical.map { it.relativeTo(origin) },
        environment,
        toneMapping,
        visibility,
    )
}
