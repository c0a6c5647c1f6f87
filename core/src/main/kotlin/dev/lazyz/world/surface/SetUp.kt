package dev.lazyz.world.surface

import dev.lazyz.Checkpoint
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Workers
import dev.lazyz.geometry.Vectors
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.LineStrokes
import dev.lazyz.setup.MeshStage
import dev.lazyz.setup.PointCloud
import dev.lazyz.setup.SampleRays
import dev.lazyz.setup.SphereStage
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.VertexStage
import dev.lazyz.setup.Viewport
import dev.lazyz.shading.Lighting
import dev.lazyz.spi.Shader
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.SceneLight
import dev.lazyz.world.material.Material
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Converts surfaces to primitives: transforms, clips, projects and snaps them, and computes their linear forms.
 *
 * All rounding happens here, once, before rendering. A custom [Surface] calls these functions from
 * [Surface.primitives]. Immutable and thread safe.
 *
 * @property raster the samples to cover
 * @property camera the camera
 * @property origin the origin of shading, see [Scene.origin]; must be 0 for [Projection.Screen]
 * @throws IllegalArgumentException if [origin] is not finite, or is not 0 and the camera's projection is
 *   [Projection.Screen]
 */
public class SetUp internal constructor(
    public val raster: Raster,
    public val camera: Camera,
    light: SceneLight,
    public val origin: Vector3dc,
    internal val workers: Workers,
    internal val checkpoint: Checkpoint,
) {
    /** Creates a set-up without environment and tone mapping. The list is not copied; do not change it. */
    @JvmOverloads
    public constructor(raster: Raster, camera: Camera, lights: List<Light>, origin: Vector3dc = Vector3d()) :
        this(raster, camera, SceneLight(lights), origin, Workers.ALL, Checkpoint.NONE)

    /** Light sources, in the order in which they are added up. */
    public val lights: List<Light> = light.classical

    init {
        require(Vectors.isFinite(origin)) { "origin must be finite: $origin" }
        require(Vectors.isZero(origin) || camera.projection != Projection.Screen) {
            "origin must be 0 for a screen camera: $origin"
        }
    }

    private val near = camera.relativeTo(origin)
    private val viewport = Viewport.of(raster, near)
    private val lighting = Lighting(light.relativeTo(origin), near)
    private val stage = VertexStage(near, viewport)
    private val planar = MeshStage(stage, lighting, workers)
    private val rays by lazy { SampleRays(near, viewport) }

    /**
     * Returns the triangles of [mesh] in order, each set up when the sequence reaches it. All vertices are transformed
     * when the iteration starts; this takes 128 bytes a vertex.
     */
    public fun mesh(mesh: Mesh): Sequence<Primitive> = planar.mesh(mesh.relativeTo(origin), checkpoint)

    /**
     * Returns the triangles of [mesh] as a batch, the first of them with submission index [first]; null if they must be
     * set up one by one.
     */
    internal fun batch(mesh: Mesh, first: Int): TriangleBatch? =
        planar.batch(mesh.relativeTo(origin), first, checkpoint)

    /** Returns [polygon] as a single primitive. */
    public fun polygon(polygon: Polygon): Primitive = planar.polygon(polygon.relativeTo(origin))

    /** Returns [sphere] as a single primitive. */
    public fun sphere(sphere: Sphere): Primitive =
        SphereStage.sphere(sphere.relativeTo(origin), near, rays, lighting)

    /** Returns the points of [points] in order, each set up when the sequence reaches it; 32 bytes a point. */
    public fun points(points: Points): Sequence<Primitive> =
        PointCloud(points.relativeTo(origin), stage, lighting).primitives()

    /** Returns the segments of [lines] in order, each set up when the sequence reaches it; 96 bytes a segment. */
    public fun lines(lines: Lines): Sequence<Primitive> =
        LineStrokes(lines.relativeTo(origin), stage, lighting).primitives()

    /**
     * Returns where [point] of world space is on the raster, or null if it is not between the near and the far plane,
     * or more than 2^19 pixels from the raster's origin. It may be outside the raster.
     */
    public fun project(point: Vector3dc): ScreenPoint? {
        val p = Vectors.minus(point, origin)
        var projected: ScreenPoint? = null
        stage.toClip(p.x, p.y, p.z) { x, y, z, w ->
            val isBetweenPlanes = w > 0.0 && z >= viewport.near * w && z <= w
            val isInGuardBand = StrictMath.abs(x) <= viewport.guardX(ScreenGrid.GUARD) * w &&
                StrictMath.abs(y) <= viewport.guardY(ScreenGrid.GUARD) * w
            if (isBetweenPlanes && isInGuardBand) {
                val steps = ScreenGrid.STEPS.toDouble()
                projected =
                    ScreenPoint(viewport.gridX(x, w) / steps, viewport.gridY(y, w) / steps, viewport.depth(z, w))
            }
        }
        return projected
    }

    /**
     * Returns the ray from the camera through the sample at column [x] and row [y], in world space. A point at distance
     * t, see [Ray.at], has the depth [depth] (t).
     */
    public fun ray(x: Int, y: Int): Ray {
        val px = rays.px(x)
        val py = rays.py(y)
        if (rays.isPerspective) return Ray(camera.eye, camera.toWorldDirection(px, py, -1.0))
        val offset = camera.toWorldDirection(px, py, 0.0)
        return Ray(offset.add(camera.eye), camera.toWorldDirection(0.0, 0.0, -1.0))
    }

    /**
     * Returns the depth of a point whose distance from the camera along the line of sight is [distance], world units;
     * it must be from the near to the far plane.
     */
    public fun depth(distance: Double): Int = rays.depthAt(distance)

    /**
     * Returns the shader for [material] and the [lights]; the material's own shader if it has one. A custom primitive
     * sets the attributes of a fragment and then calls it; a custom shader may call it and change the colour. Light is
     * evaluated at each sample: FLAT and GOURAUD count as PHONG.
     */
    public fun shader(material: Material): Shader = SphereStage.shader(material, lighting)

    override fun toString(): String = "SetUp($raster, $camera, ${lights.size} lights)"

    /**
     * A ray through a sample, in world space. Immutable.
     *
     * @property origin where it starts: the camera's eye for perspective, otherwise a point in the plane of the eye
     * @property direction its direction, of such a length that its component along the line of sight is 1
     */
    public class Ray internal constructor(public val origin: Vector3dc, public val direction: Vector3dc) {
        /** Returns the point at [distance] from the camera along the line of sight, world units. A new vector. */
        public fun at(distance: Double): Vector3d = Vector3d(
            origin.x() + direction.x() * distance,
            origin.y() + direction.y() * distance,
            origin.z() + direction.z() * distance,
        )

        override fun toString(): String = "Ray($origin, $direction)"
    }

    /**
     * A point on the raster. Immutable.
     *
     * @property x column position, pixels, a multiple of 1/256; the sample of column 0 is at 0.5
     * @property y row position, pixels, a multiple of 1/256; the sample of row 0 is at 0.5
     * @property depth depth, 0..2^31-1
     */
    public class ScreenPoint internal constructor(public val x: Double, public val y: Double, public val depth: Int) {
        override fun toString(): String = "ScreenPoint($x, $y, depth $depth)"
    }
}
