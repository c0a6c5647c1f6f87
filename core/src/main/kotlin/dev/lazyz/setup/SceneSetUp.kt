package dev.lazyz.setup

import dev.lazyz.Checkpoint
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Workers
import dev.lazyz.geometry.Vectors
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.Lighting
import dev.lazyz.spi.Shader
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.SceneLight
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3dc

/**
 * The set-up of a scene: hands each kind of surface to its stage.
 *
 * @throws IllegalArgumentException if [origin] is not finite, or is not 0 and the camera's projection is
 *   [Projection.Screen]
 */
internal class SceneSetUp(
    override val raster: Raster,
    override val camera: Camera,
    light: SceneLight,
    override val origin: Vector3dc,
    override val workers: Workers,
    override val checkpoint: Checkpoint,
) : SetUp() {
    override val lights: List<Light> = light.classical

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

    override fun mesh(mesh: Mesh): Sequence<Primitive> = planar.mesh(mesh.relativeTo(origin), checkpoint)

    /**
     * Returns the triangles of [mesh] as a batch, the first of them with submission index [first]; null if they must be
     * set up one by one.
     */
    fun batch(mesh: Mesh, first: Int): TriangleBatch? = planar.batch(mesh.relativeTo(origin), first, checkpoint)

    override fun polygon(polygon: Polygon): Primitive = planar.polygon(polygon.relativeTo(origin))

    override fun sphere(sphere: Sphere): Primitive =
        SphereStage.sphere(sphere.relativeTo(origin), near, rays, lighting)

    override fun points(points: Points): Sequence<Primitive> =
        PointCloud(points.relativeTo(origin), stage, lighting).primitives()

    override fun lines(lines: Lines): Sequence<Primitive> =
        LineStrokes(lines.relativeTo(origin), stage, lighting).primitives()

    override fun project(point: Vector3dc): ScreenPoint? {
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

    override fun ray(x: Int, y: Int): Ray {
        val px = rays.px(x)
        val py = rays.py(y)
        if (rays.isPerspective) return Ray(camera.eye, camera.toWorldDirection(px, py, -1.0))
        val offset = camera.toWorldDirection(px, py, 0.0)
        return Ray(offset.add(camera.eye), camera.toWorldDirection(0.0, 0.0, -1.0))
    }

    override fun depth(distance: Double): Int = rays.depthAt(distance)

    override fun shader(material: Material): Shader = SphereStage.shader(material, lighting)
}
