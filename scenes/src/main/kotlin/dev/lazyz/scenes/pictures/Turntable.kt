package dev.lazyz.scenes.pictures

import dev.lazyz.RenderOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.world.Viewpoint

/**
 * Pictures of a model from all around it, as `zcli render --turntable` makes them. Created by
 * [PictureSettings.turntable].
 *
 * ```
 * val turntable = PictureSettings(320, 240).turntable(Scenes.load(path), steps = 36)
 * val pictures = List(turntable.steps) { turntable.frame(it).render(TiledRenderer()) }
 * ```
 *
 * Frames can be made and rendered in any order and by several threads. The distance of the camera is computed for the
 * first of them, and kept. Thread safe.
 *
 * @property steps number of pictures
 */
public class Turntable internal constructor(
    private val settings: PictureSettings,
    private val loaded: LoadedScene,
    public val steps: Int,
) {
    @Volatile
    private var camera: TurntableCamera? = null

    init {
        require(steps >= 1) { "steps must be at least 1: $steps" }
    }

    /**
     * Sets up the picture with this number: 0 is the side of the settings, the next ones are from farther right.
     *
     * @param options the threads of set-up
     * @param observer is told what happens
     * @throws IllegalArgumentException if [step] is not in 0 until [steps]
     * @throws NoPictureException as [PictureSettings.frame], or if the scene is given on the screen
     */
    @JvmOverloads
    @Throws(InterruptedException::class)
    public fun frame(
        step: Int,
        options: RenderOptions = RenderOptions(),
        observer: PictureObserver = PictureObserver(),
    ): PictureFrame = PictureSteps(settings, loaded, options, observer).frame { start ->
        Viewpoint { scene, aspect ->
            (camera ?: TurntableCamera(scene, aspect, steps, start).also { camera = it }).at(step)
        }
    }

    override fun toString(): String = "Turntable($steps steps, $settings)"
}
