package dev.lazyz.lighting

import dev.lazyz.Checkpoint
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.drawing.EdgeDrawing
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Vectors
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * The surfaces of a scene that hide light: opaque and masked ones; not translucent ones, [Points], [Lines] and
 * [EdgeDrawing].
 *
 * @throws IllegalArgumentException if there is an [obstacle]
 */
internal class Occluders(scene: Scene) {
    /** The box around the scene, world space. */
    val box: Box

    /** What points are relative to. */
    val origin: Vector3dc = scene.origin

    /** The radius of a sphere around the [box], world units. */
    val radius: Double

    private val scene = scene.withSurfaces(scene.surfaces.filter(::hidesLight))

    init {
        obstacle(scene)?.let { throw IllegalArgumentException(it) }
        box = checkNotNull(scene.bounds)
        val diagonal = Vector3d(box.maxX - box.minX, box.maxY - box.minY, box.maxZ - box.minZ)
        val center = box.center
        val away = StrictMath.sqrt(Vectors.dot(center, center))
        radius = maxOf(StrictMath.sqrt(Vectors.dot(diagonal, diagonal)) / 2, LEAST_SHARE * away, LEAST_RADIUS)
    }

    private fun hidesLight(surface: Surface): Boolean =
        surface.pixelSize == 0.0 && surface.material?.alphaMode != AlphaMode.BLEND

    /**
     * Returns a map with [size] texels a side for each of the [directions]. Cost: a small rendering without colours for
     * each, which takes about as long as transforming all vertices; memory: 2 bytes a texel. Calls [done] after each,
     * by the thread that computed it.
     */
    fun maps(directions: List<Vector3d>, size: Int, options: RenderOptions, done: Runnable): List<DistanceMap> {
        val maps = directions.map { DistanceMap(it, box.center, origin, radius, size) }
        val alone = RenderOptions(threads = 1)
        val caller = Thread.currentThread()
        options.workers.forEach(maps.size, Checkpoint.CALLER) { number, checkpoint ->
            val image = undisturbed(caller, checkpoint) {
                val frame = scene.withViewpoint(maps[number].camera()).frame(Raster(size, size), alone)
                TiledRenderer(alone).render(frame.unshaded())
            }
            maps[number].fill(image)
            done.run()
        }
        return maps
    }

    /** Returns the result of [render]. Only an interrupt of the [caller] ends it; that of another thread stays set. */
    private inline fun undisturbed(caller: Thread, checkpoint: Checkpoint, render: () -> Image): Image {
        var interrupts = 0
        try {
            while (true) {
                try {
                    return render()
                } catch (e: InterruptedException) {
                    // A custom surface may throw it, too, each time
                    if (Thread.currentThread() === caller || ++interrupts == MOST_INTERRUPTS) throw e

                    // After an interrupt of the caller, the other threads end, too
                    checkpoint.pass()
                }
            }
        } finally {
            if (interrupts > 0) Thread.currentThread().interrupt()
        }
    }

    companion object {
        /** Returns why [scene] cannot have shadows, or null if it can. */
        fun obstacle(scene: Scene): String? {
            val box = scene.bounds ?: return "an empty scene has no shadows"
            if (scene.isOnScreen) return "a scene given on the screen has no shadows"
            val origin = scene.origin
            val reach = listOf(box.corner(0), box.corner(7)).map { Vectors.minus(it, origin) }
                .maxOf { maxOf(StrictMath.abs(it.x), StrictMath.abs(it.y), StrictMath.abs(it.z)) }
            if (reach <= LARGEST_REACH) return null
            return "the scene reaches more than $LARGEST_REACH world units from its origin, too far for shadows; " +
                "scale the model down"
        }

        /**
         * World units along an axis. Shadows are computed in single precision, and the ground reaches 1.2 times as far
         * beyond a scene: at most 2.2 times this number, which is below the greatest one, 3.4e38.
         */
        private const val LARGEST_REACH = 1e38

        private const val MOST_INTERRUPTS = 100

        /** World units; the numbers of smaller scenes would not fit into single precision. */
        private const val LEAST_RADIUS = 1e-30

        /** The least radius in multiples of the distance from the world's origin. */
        private const val LEAST_SHARE = 1e-9
    }
}
