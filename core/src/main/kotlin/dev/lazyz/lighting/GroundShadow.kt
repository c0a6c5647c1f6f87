package dev.lazyz.lighting

import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Vectors
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Surface
import kotlin.math.abs
import org.joml.Vector3dc

/**
 * The soft shadow of a scene on level ground below it: a square just below the lowest point that darkens the background
 * where the scene hides the sky, and is not visible otherwise. [on] adds it to the scene as its last surface, with a
 * camera between whose planes it is.
 *
 * ```
 * val seen = scene.withViewpoint(scene.camera(640, 480))
 * val picture = GroundShadow.of(seen).on(seen)
 * ```
 *
 * The shadow is blended with the background of the raster, so it needs no renderer that blends. In front of a
 * transparent background, it is black with the alpha of the shadow. It has a depth and a submission index like all
 * surfaces. Seen from below, it is not drawn. Toward the border of the whole picture it fades to nothing, from 12
 * percent of the shorter side on, so that no hard edge is seen on a page of the same colour. Cameras that fit a scene
 * ignore it. Compute it for the scene as it stands up: a scene that contains it cannot be rotated.
 *
 * The same surfaces as in [AmbientOcclusion] hide the sky. The arithmetic is strict, too.
 *
 * Cost: as that of an [AmbientOcclusion] with 64 directions; a sample of the ground costs about as much as a texture.
 * Memory: 256 KiB. Immutable and thread safe.
 *
 * @property strength how dark the deepest shadow is: 0 for no shadow, 1 for black
 */
public class GroundShadow private constructor(
    private val grid: ShadowGrid,
    private val center: Vector3dc,
    public val strength: Float,
) : Surface {
    /** Null: cameras that fit a scene, and its box, ignore the shadow. */
    override val bounds: Box? get() = null

    /**
     * Returns [camera] with a near and a far plane between which the shadow is, as far as it is before the camera. The
     * picture of the scene stays the same, its depths change.
     */
    public fun camera(camera: Camera): Camera {
        val middle = Vectors.dot(Vectors.minus(center, camera.eye), camera.toWorldDirection(0.0, 0.0, -1.0))
        val radius = StrictMath.sqrt(2.0) * grid.reach
        val isPerspective = camera.projection is Projection.Perspective
        val nearest = if (isPerspective) maxOf(middle - radius, camera.near * NEAREST) else middle - radius
        return camera.withPlanes(minOf(camera.near, nearest), maxOf(camera.far, middle + radius))
    }

    /**
     * Returns [scene] with this shadow as its last surface. If its viewpoint is a camera, its planes are moved as
     * [camera] does.
     */
    public fun on(scene: Scene): Scene {
        val viewpoint = scene.viewpoint
        val moved = if (viewpoint is Camera) scene.withViewpoint(camera(viewpoint)) else scene
        return moved.withSurfaces(scene.surfaces + this)
    }

    override fun primitives(setUp: SetUp): Sequence<Primitive> {
        val r = grid.reach
        val corners = floatArrayOf(-r, 0f, r, r, 0f, r, r, 0f, -r, -r, 0f, -r)
        val material = Material(shader = GroundShader(grid, strength, setUp.raster), sides = Sides.FRONT)
        return setUp.mesh(Mesh(corners, intArrayOf(0, 1, 2, 0, 2, 3), material, origin = center))
    }

    override fun toString(): String = "GroundShadow($strength)"

    public companion object {
        /** The strength if the caller does not choose. */
        public const val DEFAULT_STRENGTH: Float = 0.6f

        /** Number of directions from which light comes. */
        public const val DIRECTIONS: Int = 64

        private const val SIZE = 256

        /** How far the shadow can reach beyond the scene, as a multiple of the scene's height. */
        private const val SPREAD = 0.6

        /** How far below the scene the ground is, as a part of the radius of the scene. */
        private const val GAP = 0.001

        /** The least height that counts there, as a part of half of the scene's width. */
        private const val LEAST_SHARE = 0.2

        /** How near to the eye the near plane may come, compared with that of the camera. */
        private const val NEAREST = 0.125

        /**
         * Computes the shadow of [scene].
         *
         * @param strength how dark the deepest shadow is, 0..1
         * @param options [RenderOptions.threads] and [RenderOptions.executor] are used, the others are not
         * @param done called after each of the [DIRECTIONS], by the thread that computed it; to show progress
         * @throws IllegalArgumentException if [strength] is out of range, or there is a problem with the scene, see
         *   [AmbientOcclusion.obstacle]
         */
        @JvmStatic
        @JvmOverloads
        @Throws(InterruptedException::class)
        public fun of(
            scene: Scene,
            strength: Float = DEFAULT_STRENGTH,
            options: RenderOptions = RenderOptions(),
            done: Runnable = Runnable {},
        ): GroundShadow {
            require(strength in 0f..1f) { "strength of a shadow must be in 0..1: $strength" }
            val occluders = Occluders(scene)
            val box = occluders.box
            val center = box.center.also { it.y = box.minY }
            val halfX = (box.maxX - box.minX) / 2
            val halfZ = (box.maxZ - box.minZ) / 2
            val spread = SPREAD * maxOf(box.maxY - box.minY, LEAST_SHARE * maxOf(halfX, halfZ))
            val maps = occluders.maps(SphereDirections.above(DIRECTIONS), SIZE, options, done)
            val grid = ShadowGrid(maps, Vectors.minus(center, occluders.origin), halfX, halfZ, spread)

            // A floor of the scene itself is visible
            center.y -= GAP * occluders.radius
            return GroundShadow(grid, center, strength)
        }
    }
}

/**
 * The colour of ground with the shadows of [grid], each multiplied by [strength], in front of the background of
 * [raster]. Toward the border of the raster, the shadows fade to nothing.
 */
internal class GroundShader(private val grid: ShadowGrid, private val strength: Float, private val raster: Raster) :
    Shader {
    private val background = raster.background
    private val side = minOf(raster.width, raster.height)

    override fun shade(fragment: Fragment) {
        val shadow = strength * grid.at(fragment.worldX, fragment.worldZ) * fading(fragment.x, fragment.y)

        // Black with the alpha of the shadow, over the background
        val seen = background.alpha * (1f - shadow)
        val alpha = shadow + seen
        val part = if (alpha > 0f) seen / alpha else 0f
        fragment.setColor(background.red * part, background.green * part, background.blue * part, alpha)
    }

    /** Returns 0 at the border of the raster, and 1 far enough from it. */
    private fun fading(x: Int, y: Int): Float {
        val columns = minOf(x, raster.width - 1 - x)
        val rows = minOf(y, raster.height - 1 - y)
        return fading(columns.toFloat() / side) * fading(rows.toFloat() / side)
    }

    private fun fading(distance: Float): Float {
        val part = minOf(maxOf((distance - BORDER) / (INNER - BORDER), 0f), 1f)
        return part * part * (3f - 2f * part)
    }

    private companion object {
        /** Where shadows end, as a part of the shorter side of the raster: inside the outermost pixels. */
        const val BORDER = 0.02f

        /** Distance from the border from which shadows are not faded, same unit: the margin of a product's picture. */
        const val INNER = 0.12f
    }
}

/**
 * How dark level ground is around a scene, on a square grid: the part of the [maps] from which no light arrives. It is
 * blurred so that the edges of single shadows do not show, and fades toward the border. Immutable and thread safe.
 * Memory: 4 bytes a node.
 *
 * @param maps the light
 * @param center middle of the grid, relative to the origin of the [maps], world units
 * @param halfX half of the extent of the scene along x, world units; [halfZ] is the same along z
 * @param spread by how much the grid is larger than the scene on each side, world units
 */
internal class ShadowGrid(
    private val maps: List<DistanceMap>,
    center: Vector3dc,
    halfX: Double,
    halfZ: Double,
    spread: Double,
) {
    private val centerX = center.x().toFloat()
    private val centerZ = center.z().toFloat()

    /** Half of the side of the grid, world units. */
    val reach: Float = (maxOf(halfX, halfZ) + spread).toFloat()
    private val shadows: FloatArray

    init {
        val y = center.y().toFloat()
        val raw = FloatArray(NODES * NODES)
        for (row in 0 until NODES) {
            val z = reach * place(row)
            for (column in 0 until NODES) {
                val x = reach * place(column)
                val fading = fading(x, halfX, spread) * fading(z, halfZ, spread)
                if (fading > 0f) raw[row * NODES + column] = fading * hidden(centerX + x, y, centerZ + z)
            }
        }
        shadows = blurred(blurred(raw))
    }

    /** Returns 1 from -[half] to [half], and 0 from [spread] beyond it. */
    private fun fading(place: Float, half: Double, spread: Double): Float {
        val beyond = ((abs(place) - half) / spread).toFloat()
        if (!(beyond < 1f)) return 0f
        val part = maxOf(beyond, 0f)
        return (1f - part * part) * (1f - part * part)
    }

    private fun hidden(x: Float, y: Float, z: Float): Float {
        var open = 0f
        for (map in maps) open += map.openness(x, y, z)
        return 1f - open / maps.size
    }

    /** Returns where a node is, -1..1. */
    private fun place(number: Int): Float = (2 * number + 1 - NODES) / (NODES - 1f)

    /** Returns the grid blurred along its rows and transposed. */
    private fun blurred(values: FloatArray): FloatArray {
        val result = FloatArray(NODES * NODES)
        for (row in 0 until NODES) {
            for (column in 0 until NODES) {
                var sum = 0f
                for (k in -RADIUS..RADIUS) {
                    val at = minOf(maxOf(column + k, 0), NODES - 1)
                    sum += WEIGHTS[k + RADIUS] * values[row * NODES + at]
                }
                result[column * NODES + row] = sum
            }
        }
        return result
    }

    /** Returns how dark the ground is at a point, 0..1; 0 beyond the grid. */
    fun at(x: Float, z: Float): Float {
        val column = ((x - centerX) / reach + 1f) * HALF
        val row = ((z - centerZ) / reach + 1f) * HALF
        return interpolated(column, row, NODES, outside = 0f) { shadows[it] }
    }

    private companion object {
        /** Nodes of a side. */
        const val NODES = 256
        const val HALF = (NODES - 1) / 2f

        /** Weights of the blur, nodes to each side: a sum of 1. */
        const val RADIUS = 4
        val WEIGHTS = floatArrayOf(1f, 8f, 28f, 56f, 70f, 56f, 28f, 8f, 1f).map { it / 256f }.toFloatArray()
    }
}
