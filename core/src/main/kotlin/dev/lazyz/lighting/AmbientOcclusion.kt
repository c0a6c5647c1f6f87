package dev.lazyz.lighting

import dev.lazyz.RenderOptions
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.light.AmbientVisibility
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import org.joml.Vector3d

/**
 * Which part of a uniform sky each point of a scene sees: hollows and contacts are darker.
 *
 * ```
 * val soft = AmbientOcclusion.of(scene).on(scene)
 * ```
 *
 * The scene is rendered once from each of many directions, without colours, to a small map of distances. At a sample,
 * each map on the outer side of the surface says whether the light from its direction arrives, and the answers are
 * summed with the cosines to the normal as weights. Everything is strict arithmetic in a fixed order, so the result
 * does not depend on the renderer, on threads or on the machine (contract rule 6.13).
 *
 * Opaque and masked surfaces occlude; translucent ones, [Points] and [Lines] do not. Details smaller than two texels,
 * 1/64 of the radius of the scene with the default size, do not count.
 *
 * Cost of [of]: one small rendering without colours for each direction, which takes about as long as transforming all
 * vertices. Cost of [at]: some 20 ns for each direction on the outer side. Memory: 2 bytes for each texel of each map,
 * 16 MiB with the default numbers. Immutable and thread safe.
 *
 * Source: S. Zhukov, A. Iones and G. Kronin, "An Ambient Light Illumination Model", Rendering Techniques 1998; with
 * maps of distances, M. Pharr and S. Green, "Ambient Occlusion", GPU Gems, chapter 17, 2004.
 */
public class AmbientOcclusion private constructor(private val maps: List<DistanceMap>, texel: Double) :
    AmbientVisibility {
    /** How far points are moved along their normal, so that a surface does not occlude itself. World units. */
    private val offset = (OFFSET * texel).toFloat()

    override fun at(x: Float, y: Float, z: Float, normalX: Float, normalY: Float, normalZ: Float): Float {
        val px = x + offset * normalX
        val py = y + offset * normalY
        val pz = z + offset * normalZ
        var open = 0f
        var all = 0f
        for (map in maps) {
            val cosine = normalX * map.x + normalY * map.y + normalZ * map.z
            if (!(cosine > 0f)) continue
            all += cosine
            open += cosine * map.openness(px, py, pz)
        }
        return if (all > 0f) open / all else 1f
    }

    /** Returns [scene] with this occlusion, and with materials that it makes darker everywhere. */
    public fun on(scene: Scene): Scene = scene.withMaterials { it.asMetallicRoughness() }.withAmbientVisibility(this)

    override fun toString(): String = "AmbientOcclusion(${maps.size} directions)"

    public companion object {
        /** Number of directions if the caller does not choose. */
        public const val DEFAULT_DIRECTIONS: Int = 128

        /** Number of texels of a map's side if the caller does not choose. */
        public const val DEFAULT_SIZE: Int = 256

        /** Texels. */
        private const val OFFSET = 1.5

        /**
         * Returns why [scene] can have neither an [AmbientOcclusion] nor a [GroundShadow], or null if it can have both.
         * It cannot if it is empty, if its camera's projection is [Projection.Screen], or if its box reaches more than
         * 1e38 world units along an axis from its origin ([Scene.origin]), because shadows are computed in single
         * precision.
         */
        @JvmStatic
        public fun obstacle(scene: Scene): String? = Occluders.obstacle(scene)

        /**
         * Computes the occlusion in [scene]. See the class for cost and memory.
         *
         * @param directions number of directions on the whole sphere, 8..4096; fewer show edges of single shadows
         * @param size number of texels of a map's side, 16..4096
         * @param options [RenderOptions.threads] and [RenderOptions.executor] are used, the others are not
         * @param done called after each direction, by the thread that computed it; to show progress
         * @throws IllegalArgumentException if a number is out of range, or there is an [obstacle] in the scene
         */
        @JvmStatic
        @JvmOverloads
        @Throws(InterruptedException::class)
        public fun of(
            scene: Scene,
            directions: Int = DEFAULT_DIRECTIONS,
            size: Int = DEFAULT_SIZE,
            options: RenderOptions = RenderOptions(),
            done: Runnable = Runnable {},
        ): AmbientOcclusion {
            require(directions in 8..4096) { "directions must be in 8..4096: $directions" }
            require(size in 16..4096) { "size must be in 16..4096: $size" }
            val occluders = Occluders(scene)
            val maps = occluders.maps(SphereDirections.everywhere(directions), size, options, done)
            return AmbientOcclusion(maps, 2 * occluders.radius / size)
        }
    }
}

/**
 * Directions that are spread evenly: a spiral around the y axis, with turns of the golden angle.
 *
 * Source: R. Swinbank and R. J. Purser, "Fibonacci Grids", Quarterly Journal of the Royal Meteorological Society 132
 * (2006).
 */
internal object SphereDirections {
    /** Returns [count] unit vectors, as many in each part of the sphere. */
    fun everywhere(count: Int): List<Vector3d> = spiral(count) { 1.0 - 2.0 * it }

    /**
     * Returns [count] unit vectors that point up, and more of them the steeper they are: their number in a part of the
     * sphere is proportional to the seventh power of y.
     */
    fun above(count: Int): List<Vector3d> =
        spiral(count) { StrictMath.sqrt(StrictMath.sqrt(StrictMath.sqrt(1.0 - it))) }

    /** Returns the vectors whose y are those of [height] at evenly spaced places between 0 and 1. */
    private inline fun spiral(count: Int, height: (place: Double) -> Double): List<Vector3d> = List(count) { i ->
        val y = height((i + 0.5) / count)
        val level = StrictMath.sqrt(1.0 - y * y)
        Vector3d(level * StrictMath.cos(GOLDEN_ANGLE * i), y, level * StrictMath.sin(GOLDEN_ANGLE * i))
    }

    /** Radians. */
    private val GOLDEN_ANGLE = StrictMath.PI * (3.0 - StrictMath.sqrt(5.0))
}
