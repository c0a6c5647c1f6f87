package dev.lazyz.sections

import dev.lazyz.Rgba
import dev.lazyz.endIfInterrupted
import dev.lazyz.geometry.FillRule
import dev.lazyz.geometry.Vectors
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Surface
import java.util.function.UnaryOperator
import kotlin.math.floor
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Cuts a scene by planes, and closes meshes where they are cut. What remains is on the kept side of all [planes].
 *
 * ```
 * val half = Section(listOf(Section.Plane.x(0.5))).of(scene).scene
 * ```
 *
 * A mesh that is closed gets a cap on each plane: a [Polygon] of the contours in which the plane cuts it, with the
 * non-zero rule, so that cavities stay open and parts that overlap are one. If a model is divided into several meshes
 * that are closed only together, contours are joined over them. Contours that do not close get no cap and a warning. A
 * vertex on a plane counts as kept. Faces in a plane are kept if they show to the removed side, so a cut along the
 * surface of a solid leaves the solid, or nothing.
 *
 * Polygons are cut, and have no caps. Points are removed one by one, and lines are cut. Spheres and custom surfaces are
 * not cut, with a warning. New vertices get normals, texture coordinates and colours by linear interpolation. Materials
 * become two-sided, because a cut opens the view of inner walls.
 *
 * The list is not copied; do not change it. Immutable and thread safe.
 *
 * @property planes the planes; those of an earlier cut do not hinder a later one, and equal ones count once
 * @param capMaterial returns the material of a cap from that of its mesh; by default [darkened]
 */
public class Section @JvmOverloads constructor(
    public val planes: List<Plane>,
    private val capMaterial: UnaryOperator<Material> = UnaryOperator { darkened(it) },
) {
    /** The planes without those that are there already. Adding 0 makes -0 equal to 0. */
    private val distinctPlanes =
        planes.distinctBy { listOf(it.normal.x() + 0.0, it.normal.y() + 0.0, it.normal.z() + 0.0, it.distance + 0.0) }

    /**
     * Cuts [scene]. Caps come after all surfaces, in submission order. Lights and viewpoint are unchanged; a rule such
     * as `Camera.fit` shows what remains. Cost: linear in the size of the scene, for each plane.
     *
     * @throws InterruptedException if the calling thread is interrupted
     */
    @Throws(InterruptedException::class)
    public fun of(scene: Scene): Section.Cut {
        val warnings = ArrayList<String>()
        val meshes = scene.surfaces.filterIsInstance<Mesh>()
        val caps = distinctPlanes.flatMap { caps(meshes, it, warnings) }
        val kept = scene.surfaces.mapNotNull { surface ->
            distinctPlanes.fold(surface as Surface?) { rest, plane -> rest?.let { cut(it, plane) } }
        }
        val whole = scene.surfaces.count { it !is Mesh && it !is Polygon && it !is Points && it !is Lines }
        if (whole > 0) warnings += "$whole spheres or custom surfaces cannot be cut, and are shown whole"
        val shown = if (planes.isEmpty()) kept else kept.map(::twoSided)
        return Section.Cut(scene.withSurfaces(shown + caps), warnings)
    }

    /** Inner walls, of which some show their backs, can be seen now. */
    private fun twoSided(surface: Surface): Surface = if (surface.material?.sides == Sides.FRONT) {
        surface.withMaterials { it.withSides(Sides.BOTH) }
    } else {
        surface
    }

    private fun cut(surface: Surface, plane: Plane): Surface? {
        endIfInterrupted()
        return when (surface) {
            is Mesh -> MeshCut(surface, plane).kept()
            is Polygon -> cut(surface, plane)
            is Points -> SparseCut.of(surface, plane)
            is Lines -> SparseCut.of(surface, plane)
            else -> surface
        }
    }

    private fun cut(polygon: Polygon, plane: Plane): Polygon? {
        // A polygon with a vertex that is not finite covers nothing, and must not become one that does
        if (!polygon.contours.all { contour -> contour.all { it.isFinite } }) return polygon
        if (polygon.contours.all { contour -> contour.all { plane.height(it.x, it.y, it.z) <= 0.0 } }) return polygon
        val contours = ContourCut.of(polygon.contours, polygon.fillRule, plane).filter { it.size >= 3 }
        if (contours.isEmpty()) return null
        return Polygon(contours, polygon.material, polygon.fillRule, polygon.name, polygon.isCap)
    }

    /** Returns the caps of [meshes] on [plane], cut by the other planes. */
    private fun caps(meshes: List<Mesh>, plane: Plane, warnings: MutableList<String>): List<Polygon> {
        val caps = ArrayList<Polygon?>()
        var open = 0

        // What is open, by origin: meshes far from that of the world have others, and have no contours in common
        class Rest(val mesh: Mesh, val contours: Contours)
        val rests = LinkedHashMap<Vector3dc, Rest>()
        for (mesh in meshes) {
            val contours = Contours()
            MeshCut(mesh, plane).addSegments(contours)
            caps += cap(contours, mesh, plane)
            if (contours.openSegments.isEmpty()) continue
            rests.getOrPut(mesh.origin) { Rest(mesh, Contours()) }.contours.addAll(contours.openSegments)
        }
        for (rest in rests.values) {
            caps += cap(rest.contours, rest.mesh, plane)
            open += rest.contours.openCount
        }
        if (open > 0) {
            val word = if (open == 1) "1 contour does" else "$open contours do"
            warnings += "$word not close where the plane $plane cuts the model: no cap there, because the mesh is open"
        }
        return caps.filterNotNull()
    }

    /** Returns the cap in [contours], which begin in [mesh] and get the material made of its own, and its name. */
    private fun cap(contours: Contours, mesh: Mesh, plane: Plane): Polygon? {
        val origin = mesh.origin
        val loops = contours.loops().map { loop ->
            List(loop.size / 3) {
                Vertex(origin.x() + loop[3 * it], origin.y() + loop[3 * it + 1], origin.z() + loop[3 * it + 2])
            }
        }
        val whole = Polygon(loops, capMaterial.apply(mesh.material), FillRule.NON_ZERO, mesh.name, isCap = true)
        if (loops.isEmpty()) return null
        val others = distinctPlanes.filter { it !== plane }
        return others.fold(whole as Polygon?) { rest, other -> rest?.let { cut(it, other) } }
    }

    override fun toString(): String = "Section($planes)"

    /**
     * A scene that was cut, see [Section].
     *
     * @property scene what remains, with caps
     * @property warnings what could not be cut or capped, in words; empty if everything could
     */
    public class Cut internal constructor(public val scene: Scene, public val warnings: List<String>) {
        override fun toString(): String = "Cut($scene, ${warnings.size} warnings)"
    }

    /**
     * A plane that cuts a scene. What is on the side that [normal] points to is removed: all points p whose product
     * with the normal, at unit length, is greater than [distance]. Immutable.
     *
     * @param normal points to the removed side, of any length
     * @property distance distance of the plane from the world's origin along the normal, world units
     * @throws IllegalArgumentException if the normal is zero, or a number is not finite
     */
    public class Plane(normal: Vector3dc, public val distance: Double) {
        /** Points to the removed side; unit length. */
        public val normal: Vector3dc

        init {
            require(distance.isFinite()) { "distance must be finite: $distance" }
            this.normal = Vectors.unit(normal, "normal")
        }

        /** Returns the distance of ([x], [y], [z]) from the plane, world units, above 0 on the removed side. */
        internal fun height(x: Double, y: Double, z: Double): Double {
            val height = normal.x() * x + normal.y() * y + normal.z() * z - distance
            val size = StrictMath.abs(normal.x() * x) + StrictMath.abs(normal.y() * y) + StrictMath.abs(normal.z() * z)

            // What differs from 0 only by rounding is on the plane
            return if (StrictMath.abs(height) <= ROUNDING * (size + StrictMath.abs(distance))) 0.0 else height
        }

        override fun toString(): String = "${normal.x()},${normal.y()},${normal.z()},$distance"

        public companion object {
            /** More than the rounding error of a height, as a part of its terms. */
            private const val ROUNDING = 1e-13

            /** Returns the plane [x] that removes what has a greater x. */
            @JvmStatic
            public fun x(x: Double): Plane = Plane(Vector3d(1.0, 0.0, 0.0), x)

            /** Returns the plane [y] that removes what has a greater y. */
            @JvmStatic
            public fun y(y: Double): Plane = Plane(Vector3d(0.0, 1.0, 0.0), y)

            /** Returns the plane [z] that removes what has a greater z. */
            @JvmStatic
            public fun z(z: Double): Plane = Plane(Vector3d(0.0, 0.0, 1.0), z)
        }

        /** Returns the same plane, which removes the other side. */
        public fun reversed(): Plane =
            Plane(Vector3d(-normal.x(), -normal.y(), -normal.z()), -distance)
    }

    /**
     * Colours a surface with parallel stripes, as caps in technical drawings. The stripes are where planes with the
     * normal (1, 1, 1) meet the surface: on a plane along two axes of the world, they are at 45 degrees. Light has no
     * effect.
     *
     * @property period distance of two such planes times the square root of 3: distance of the stripes along an axis,
     *   world units, above 0
     * @property share width of a stripe, as a part of the period, 0..1
     * @property stripe colour of the stripes
     * @property ground colour between them
     * @throws IllegalArgumentException if a number is out of range
     */
    public class Hatching(
        public val period: Double,
        public val share: Double,
        public val stripe: Rgba,
        public val ground: Rgba,
    ) : Shader {
        init {
            require(period > 0.0 && period.isFinite()) { "period must be positive: $period" }
            require(share in 0.0..1.0) { "share must be in 0..1: $share" }
        }

        override fun shade(fragment: Fragment) {
            val place = (fragment.worldX.toDouble() + fragment.worldY + fragment.worldZ) / period
            val color = if (place - floor(place) < share) stripe else ground
            fragment.setColor(color.red, color.green, color.blue, color.alpha)
        }

        /** Returns a material with these stripes. */
        public fun material(): Material = Material(ground, shader = this)

        override fun toString(): String = "Hatching($period, $share, $stripe, $ground)"
    }

    public companion object {
        /** The part of the light that remains in [darkened]. */
        private const val DARK = 0.6f

        /** Returns the default material of caps: base colour times mean texture colour of [material], darker. */
        @JvmStatic
        public fun darkened(material: Material): Material {
            val base = material.baseColor.scaled(DARK)
            val mean = material.texture?.meanColor ?: return capColor(material, base)
            return capColor(material, Rgba(base.red * mean.red, base.green * mean.green, base.blue * mean.blue))
        }

        /** Returns [material] in another [color], without what does not fit a cap: maps, one-sidedness, shaders. */
        @JvmStatic
        public fun capColor(material: Material, color: Rgba): Material =
            Material(color, shading = material.shading, name = material.name).withMetallicRoughness(
                material.metallicRoughness?.let { MetallicRoughness(it.metallic, it.roughness) },
            )
    }
}
