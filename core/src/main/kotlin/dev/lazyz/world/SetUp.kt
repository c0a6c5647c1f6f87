package dev.lazyz.world

import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.geometry.Vectors
import dev.lazyz.setup.LineStrokes
import dev.lazyz.setup.PointCloud
import dev.lazyz.setup.SphereSetUp
import dev.lazyz.setup.VertexStage
import dev.lazyz.setup.Viewport
import dev.lazyz.setup.planar.PlanarSetUp
import dev.lazyz.setup.planar.TriangleBatch
import dev.lazyz.shading.Lighting
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
 * @property lights light sources, in the order in which they are added up
 * @property origin the origin of shading, see [Scene.origin]; must be 0 for [Projection.Screen]
 * @throws IllegalArgumentException if [origin] is not finite, or is not 0 and the camera's projection is
 *   [Projection.Screen]
 */
public class SetUp @JvmOverloads constructor(
    public val raster: Raster,
    public val camera: Camera,
    public val lights: List<Light>,
    public val origin: Vector3dc = Vector3d(),
) {
    init {
        require(Vectors.isFinite(origin)) { "origin must be finite: $origin" }
        require(Vectors.isZero(origin) || camera.projection != Projection.Screen) {
            "origin must be 0 for a screen camera: $origin"
        }
    }

    private val near = camera.relativeTo(origin)
    private val viewport = Viewport.of(raster, near)
    private val lighting = Lighting(lights.map { it.relativeTo(origin) }, near)
    private val stage = VertexStage(near, viewport)
    private val planar = PlanarSetUp(stage, lighting)

    /**
     * Returns the triangles of [mesh] in order, each set up when the sequence reaches it. All vertices are transformed
     * when the iteration starts; this takes 128 bytes a vertex.
     */
    public fun mesh(mesh: Mesh): Sequence<Primitive> = planar.mesh(mesh.relativeTo(origin))

    /**
     * Returns the triangles of [mesh] as a batch, the first of them with submission index [first]; null if they must be
     * set up one by one.
     */
    internal fun batch(mesh: Mesh, first: Int): TriangleBatch? = planar.batch(mesh.relativeTo(origin), first)

    /** Returns [polygon] as a single primitive. */
    public fun polygon(polygon: Polygon): Primitive = planar.polygon(polygon.relativeTo(origin))

    /** Returns [sphere] as a single primitive. */
    public fun sphere(sphere: Sphere): Primitive =
        SphereSetUp.sphere(sphere.relativeTo(origin), near, viewport, lighting)

    /** Returns the points of [points] in order, each set up when the sequence reaches it; 32 bytes a point. */
    public fun points(points: Points): Sequence<Primitive> =
        PointCloud(points.relativeTo(origin), stage, lighting).primitives()

    /** Returns the segments of [lines] in order, each set up when the sequence reaches it; 96 bytes a segment. */
    public fun lines(lines: Lines): Sequence<Primitive> =
        LineStrokes(lines.relativeTo(origin), stage, lighting).primitives()

    override fun toString(): String = "SetUp($raster, $camera, ${lights.size} lights)"
}
