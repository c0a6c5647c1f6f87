package dev.lazyz.setup

import dev.lazyz.Checkpoint
import dev.lazyz.Raster
import dev.lazyz.Workers
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.SceneLight
import dev.lazyz.world.light.ToneMapping
import org.joml.Vector3d
import org.joml.Vector3dc

/** Returns a set-up without a scene, an environment and tone mapping. */
internal fun setUp(
    raster: Raster,
    camera: Camera,
    lights: List<Light> = emptyList(),
    origin: Vector3dc = Vector3d(),
): SceneSetUp = SceneSetUp(raster, camera, lightOf(lights), origin, Workers.ALL, Checkpoint.NONE)

/** Returns these lights for all materials, without an environment and without tone mapping. */
internal fun lightOf(lights: List<Light>): SceneLight =
    SceneLight(lights, lights, Environment.NONE, ToneMapping.NONE, null)
