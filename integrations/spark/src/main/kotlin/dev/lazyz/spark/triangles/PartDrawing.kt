package dev.lazyz.spark.triangles

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Surface
import java.io.Serializable
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * What all tasks of a picture know: the scene without its triangles, the camera and the raster.
 *
 * @param bandRows rows of a band
 */
internal class PictureSetUp(
    private val scene: TriangleScene,
    private val camera: SerializableCamera,
    val width: Int,
    val height: Int,
    private val bandRows: Int,
) : Serializable {
    /** Number of bands. */
    val bands: Int get() = (height + bandRows - 1) / bandRows

    /** Returns the samples of a band. */
    fun region(band: Int): Region = Region(0, band * bandRows, width, minOf((band + 1) * bandRows, height))

    /** Returns the bands that [region] reaches. */
    fun bands(region: Region): IntRange = region.rowStart / bandRows..(region.rowEnd - 1) / bandRows

    /** Returns what draws triangles. */
    fun drawing(): PartDrawing = PartDrawing(this, scene, camera.camera())

    companion object {
        /** Samples of a band, at 12 bytes each. */
        private const val BAND = 1 shl 20

        /** Returns the rows of a band of a picture. */
        fun bandRows(width: Int, height: Int): Int = (BAND / width).coerceIn(1, height)
    }
}

/**
 * Draws some of the triangles of a picture. Used by one thread.
 */
internal class PartDrawing(
    private val setUp: PictureSetUp,
    private val scene: TriangleScene,
    private val camera: Camera,
) {
    private val options = RenderOptions(threads = 1)
    private val renderer = TiledRenderer(options)
    private val counters = Counters.Builder()

    /** The raster of the whole picture. */
    val raster: Raster = Raster(setUp.width, setUp.height, scene.scene(NOTHING).background)
    private val reach = ScreenReach(raster, camera)

    /** The work so far. */
    fun work(): Counters = counters.build()

    /** Returns triangles that can be drawn band by band. */
    fun part(chunk: TriangleChunk): Part = Part(chunk)

    /** Some triangles, set up for the picture. */
    inner class Part(private val chunk: TriangleChunk) {
        private val mesh: Mesh
        private val frame: Frame

        init {
            val own = scene.scene(chunk.mesh()).withViewpoint(camera)
            val surface = own.surfaces.singleOrNull() as? Mesh
            require(surface != null && surface.triangleCount == chunk.size) { otherSurfaces(own) }
            mesh = surface
            frame = own.frame(raster, options)
            require(!frame.hasTranslucency) { TRANSLUCENT }
        }

        /** Where the triangles are, or null if they cover no sample. */
        val region: Region? = region(0, 3 * chunk.size)

        private fun region(from: Int, until: Int): Region? {
            reach.clear()
            val origin = mesh.origin
            for (i in from until until) {
                val at = 3 * mesh.triangles[i]
                reach.add(
                    origin.x() + mesh.positions[at],
                    origin.y() + mesh.positions[at + 1],
                    origin.z() + mesh.positions[at + 2],
                )
            }
            return reach.region()
        }

        /** Draws the samples of a band that the triangles can cover. */
        fun draw(into: BandSamples, isShaded: Boolean) {
            val seen = region?.intersect(into.region) ?: return
            val test = raster.depthTest
            val seenFrame = frame.within(seen)
            val work = renderer.render(if (isShaded) seenFrame else seenFrame.unshaded()) { y, argb, depth, primitive ->
                for (i in 0 until seen.width) {
                    if (primitive[i] == DepthTest.BACKGROUND) continue
                    into.add(seen.columnStart + i, y, test.key(depth[i], chunk.index(primitive[i])), argb[i])
                }
            }
            counters.add(if (isShaded) work else work.toBuilder().apply { shadingCalls = 0 }.build())
        }

        /** Returns the triangles that can cover samples of each band, by the number of the band. */
        fun byBand(): Map<Int, TriangleChunk> {
            val bands = Array(chunk.size) { region(3 * it, 3 * it + 3)?.let(setUp::bands) ?: IntRange.EMPTY }
            val counts = IntArray(setUp.bands)
            for (range in bands) for (band in range) counts[band]++
            val numbers = counts.indices.filter { counts[it] > 0 }.associateWith { IntArray(counts[it]) }
            counts.fill(0)
            for ((triangle, range) in bands.withIndex()) {
                for (band in range) numbers.getValue(band)[counts[band]++] = triangle
            }
            return numbers.mapValues { (_, some) -> chunk.select(some) }
        }
    }

    companion object {
        /** What is wrong with translucent triangles, and what to do. */
        const val TRANSLUCENT: String = "translucent triangles must be blended in one place, and parts cannot be " +
            "merged: make the material opaque, or render the whole scene with DistributedPicture (sort-first)"

        /** What is wrong with a scene that has other surfaces. */
        fun otherSurfaces(scene: Scene): String = "the scene must have the given triangles as its only surface: $scene"

        private val NOTHING = Mesh(FloatArray(0), IntArray(0))
    }
}

/** The values of a camera, on their way to an executor. */
internal class SerializableCamera(camera: Camera) : Serializable {
    private val eye = values(camera.eye)
    private val target = values(camera.target)
    private val up = values(camera.up)
    private val near = camera.near
    private val far = camera.far
    private val fieldOfView = (camera.projection as? Projection.Perspective)?.verticalFieldOfView
    private val height = (camera.projection as? Projection.Orthographic)?.height

    /** Returns the camera. */
    fun camera(): Camera = when {
        fieldOfView != null -> Camera.perspective(vector(eye), vector(target), vector(up), fieldOfView, near, far)
        height != null -> Camera.orthographic(vector(eye), vector(target), vector(up), height, near, far)
        else -> Camera.screen(near, far)
    }

    private companion object {
        fun values(v: Vector3dc) = doubleArrayOf(v.x(), v.y(), v.z())

        fun vector(v: DoubleArray) = Vector3d(v[0], v[1], v[2])
    }
}

/**
 * Makes the scene around triangles: their material, the axis that points up, lights, a background, a viewpoint. It is
 * sent to all executors, and called with some of the triangles at a time; so its result must be the same for all, apart
 * from them. In Kotlin and Java it can be a lambda:
 *
 * ```
 * TriangleScene { triangles -> Scene(listOf(triangles)).withUpAxis(UpAxis.Z) }
 * ```
 *
 * The scene must have this one surface, which may have another material and another axis up, but not other triangles.
 * It must be opaque.
 */
public fun interface TriangleScene : Serializable {
    /** Returns the scene of some [triangles]. */
    public fun scene(triangles: Surface): Scene
}
