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
 * Turns surfaces into primitives: transform, clip, project, snap, and set up linear forms.
 *
 * Everything that rounds happens here, once, before any renderer. A [Surface] of one's own calls these functions from
 * [Surface.primitives]. Immutable and thread safe.
 *
 * @property raster the samples to cover
 * @property camera the point of view
 * @property lights sources of light, in the order in which they are summed
 * @property origin where shading has its origin, see [Scene.origin]; that of the world for [Projection.Screen]
 * @throws IllegalArgumentException if [origin] is not finite, or the camera's projection is [Projection.Screen] and it is
 *   not 0
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
            "a screen camera has no origin but the world's: $origin"
        }
    }

    private val near = camera.relativeTo(origin)
    private val viewport = Viewport.of(raster, near)
    private val lighting = Lighting(lights.map { it.relativeTo(origin) }, near)
    private val stage = VertexStage(near, viewport)
    private val planar = PlanarSetUp(stage, lighting)

    /**
     * Returns the triangles of [mesh] in order, set up one at a time as the sequence is walked. The vertices are
     * transformed once, when the walk begins: 128 bytes a vertex.
     */
    public fun mesh(mesh: Mesh): Sequence<Primitive> = planar.mesh(mesh.relativeTo(origin))

    /**
     * Returns the triangles of [mesh], of which the first has the submission index [first], as a batch; or null if they
     * have to be set up one by one.
     */
    internal fun batch(mesh: Mesh, first: Int): TriangleBatch? = planar.batch(mesh.relativeTo(origin), first)

    /** Returns [polygon] as one primitive. */
    public fun polygon(polygon: Polygon): Primitive = planar.polygon(polygon.relativeTo(origin))

    /** Returns [sphere] as one primitive. */
    public fun sphere(sphere: Sphere): Primitive =
        SphereSetUp.sphere(sphere.relativeTo(origin), near, viewport, lighting)

    /** Returns the points of [points] in order, set up one at a time as the sequence is walked; 32 bytes a point. */
    public fun points(points: Points): Sequence<Primitive> =
        PointCloud(points.relativeTo(origin), stage, lighting).primitives()

    /** Returns the segments of [lines] in order, set up one at a time as the sequence is walked; 96 bytes a segment. */
    public fun lines(lines: Lines): Sequence<Primitive> =
        LineStrokes(lines.relativeTo(origin), stage, lighting).primitives()

    override fun toString(): String = "SetUp($raster, $camera, ${lights.size} lights)"
}
