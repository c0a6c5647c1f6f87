package dev.lazyz.scenes

import dev.lazyz.RenderOptions
import dev.lazyz.filter.SampledFrame
import dev.lazyz.geometry.UpAxis
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Viewpoint

/**
 * Pictures of a model from all around it, as `zcli render --turntable` makes them. Created by
 * [PictureSettings.turntable].
 *
 * ```
 * val turntable = PictureSettings(320, 240).turntable(Scenes.load(path), steps = 36)
 * val pictures = List(turntable.steps) { turntable.frame(it).render(Tiled()) }
 * ```
 *
 * Frames can be made and rendered in any order and by several threads. Immutable and thread safe.
 */
public class Turntable internal constructor(private val settings: PictureSettings, loaded: LoadedScene, steps: Int) {
    private val upright: LoadedScene
    private val camera: TurntableCamera

    init {
        if (loaded.scene.isOnScreen) {
            throw NoPictureException("a scene given on the screen has no camera that could go around it")
        }
        val scene = settings.upright(loaded)
        upright = loaded.withScene(scene)
        val aspect = settings.size.width.toDouble() / settings.size.height
        camera = TurntableCamera(scene, aspect, steps, FittedViewpoint.like(scene.viewpoint))
    }

    /** Number of pictures. */
    public val steps: Int get() = camera.steps

    /**
     * Sets up the picture with this number: 0 is the side of the settings, the next ones are from farther right.
     *
     * @param options the threads of set-up
     * @throws IllegalArgumentException if [step] is not in 0 until [steps]
     * @throws NoPictureException as [PictureSettings.frame]
     */
    @JvmOverloads
    @Throws(InterruptedException::class)
    public fun frame(step: Int, options: RenderOptions = RenderOptions()): SampledFrame {
        val seen = camera.at(step)
        return settings.withUp(UpAxis.Y).withViewpoint(Viewpoint { _, _ -> seen }).frame(upright, options)
    }

    override fun toString(): String = "Turntable($steps steps, $settings)"
}
