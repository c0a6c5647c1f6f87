package dev.lazyz.setup

import dev.lazyz.EmptyPrimitive
import dev.lazyz.Primitive
import dev.lazyz.geometry.Vectors
import dev.lazyz.shading.AttributedPrimitive
import dev.lazyz.shading.Lighting
import dev.lazyz.shading.MaskedPrimitive
import dev.lazyz.shading.MaterialShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.spi.Spans
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Sphere
import kotlin.math.floor
import org.joml.Vector3d

/**
 * A sphere on the raster. For each sample, the ray through it is intersected with the sphere (contract rule 2.6).
 *
 * In camera space, t is the distance from the eye along the line of sight. The ray through a sample is `t (px, py, -1)`
 * for perspective and `(px, py, -t)` otherwise. The intersection is a quadratic equation in t, with the discriminant
 * `|d|^2 r^2 - |d x c|^2`. Unlike the textbook's `b^2 - ac`, it has no cancellation for small distant spheres.
 *
 * A sphere that intersects the near plane is cut open there, and shows its inside.
 */
internal class SpherePrimitive private constructor(
    private val sphere: Sphere,
    private val camera: Camera,
    private val rays: SampleRays,
    private val cx: Double,
    private val cy: Double,
    private val cz: Double,
    override val shader: Shader,
) : AttributedPrimitive {
    private val width = rays.width
    private val height = rays.height
    private val radius = sphere.radius
    private val isPerspective = rays.isPerspective

    /** Whether the whole sphere is between the planes, so that a row has at most one span. */
    private val isWhole = -cz - radius >= camera.near && -cz + radius <= camera.far

    override val rowStart: Int
    override val rowEnd: Int
    override val columnStart: Int
    override val columnEnd: Int
    override val leastDepth: Int
    override val greatestDepth: Int
    override val isTranslucent: Boolean get() = sphere.material.isTranslucent

    init {
        val depths = intArrayOf(
            rays.depthAt(maxOf(-cz - radius, camera.near)),
            rays.depthAt(minOf(-cz + radius, camera.far)),
        )
        leastDepth = maxOf(depths.min() - 1, 0)
        greatestDepth = depths.max() + 1
        if (isWhole) {
            val rows = extent(cy)
            val columns = extent(cx)
            rowStart = clamp(rays.rowAt(rows[1]) - 1.5, height)
            rowEnd = clamp(rays.rowAt(rows[0]) + 1.5, height)
            columnStart = clamp(rays.columnAt(columns[0]) - 1.5, width)
            columnEnd = clamp(rays.columnAt(columns[1]) + 1.5, width)
        } else {
            rowStart = 0
            rowEnd = height
            columnStart = 0
            columnEnd = width
        }
    }

    override fun spans(y: Int, spans: Spans) {
        if (y < rowStart || y >= rowEnd) return
        if (isWhole) {
            // One span: search for its ends from outside
            var start = columnStart
            var end = columnEnd
            val ends = columns(y)
            if (ends != null) {
                start = maxOf(start, clamp(ends[0] - 1.5, width))
                end = minOf(end, clamp(ends[1] + 1.5, width))
            }
            while (start < end && hit(start, y).isNaN()) start++
            while (start < end && hit(end - 1, y).isNaN()) end--
            if (start < end) spans.add(start, end)
            return
        }

        // Clipped by a plane: any number of spans
        for (x in columnStart until columnEnd) if (!hit(x, y).isNaN()) spans.add(x, x + 1)
    }

    override fun depth(x: Int, y: Int): Int = rays.depthAt(distance(x, y))

    override fun attributes(fragment: Fragment) {
        val t = distance(fragment.x, fragment.y)
        val scale = if (isPerspective) t else 1.0
        val x = rays.px(fragment.x) * scale
        val y = rays.py(fragment.y) * scale
        val eye = camera.eye
        val position = camera.toWorldDirection(x, y, -t)
        fragment.worldX = (eye.x() + position.x).toFloat()
        fragment.worldY = (eye.y() + position.y).toFloat()
        fragment.worldZ = (eye.z() + position.z).toFloat()

        // The normal points outward; on the inside it is reversed
        val normal = camera.toWorldDirection((x - cx) / radius, (y - cy) / radius, (-t - cz) / radius)
        val sign = if (nearRoot(fragment.x, fragment.y) < camera.near) -1.0 else 1.0
        fragment.normalX = (sign * normal.x).toFloat()
        fragment.normalY = (sign * normal.y).toFloat()
        fragment.normalZ = (sign * normal.z).toFloat()
        fragment.u = (0.5 + StrictMath.atan2(normal.x, normal.z) / (2.0 * StrictMath.PI)).toFloat()
        fragment.v = (StrictMath.acos(normal.y.coerceIn(-1.0, 1.0)) / StrictMath.PI).toFloat()
        if (sphere.material.usesFootprint) footprint(fragment, scale, normal)
    }

    /**
     * Sets the derivatives of the texture coordinates. When the ray turns to the next sample, or pixel (contract
     * rule 6.12), the point moves in the tangent plane.
     *
     * @param scale distance of the point for perspective, otherwise 1
     * @param normal the outward normal, world space
     */
    private fun footprint(fragment: Fragment, scale: Double, normal: Vector3d) {
        val ray = if (isPerspective) {
            camera.toWorldDirection(rays.px(fragment.x), rays.py(fragment.y), -1.0)
        } else {
            camera.toWorldDirection(0.0, 0.0, -1.0)
        }
        val step = scale * fragment.footprintSide
        slopes(camera.toWorldDirection(rays.columnStep * step, 0.0, 0.0), ray, normal) { u, v ->
            fragment.dudx = u
            fragment.dvdx = v
        }
        slopes(camera.toWorldDirection(0.0, rays.rowStep * step, 0.0), ray, normal) { u, v ->
            fragment.dudy = u
            fragment.dvdy = v
        }
    }

    /**
     * Passes the change of the texture coordinates to [use], if the point moves by [step] and then along [ray] to the
     * tangent plane.
     */
    private inline fun slopes(step: Vector3d, ray: Vector3d, normal: Vector3d, use: (u: Float, v: Float) -> Unit) {
        val along = Vectors.dot(step, normal) / Vectors.dot(ray, normal)
        val x = (step.x - along * ray.x) / radius
        val y = (step.y - along * ray.y) / radius
        val z = (step.z - along * ray.z) / radius
        val aroundAxis = normal.x * normal.x + normal.z * normal.z
        use(
            ((normal.z * x - normal.x * z) / aroundAxis / (2.0 * StrictMath.PI)).toFloat(),
            (-y / StrictMath.sqrt(aroundAxis) / StrictMath.PI).toFloat(),
        )
    }

    /** A quarter of the discriminant of the intersection; negative if the ray misses the sphere. */
    private fun discriminant(px: Double, py: Double): Double {
        if (!isPerspective) return radius * radius - (px - cx) * (px - cx) - (py - cy) * (py - cy)
        val crossX = py * cz + cy
        val crossY = px * cz + cx
        val crossZ = px * cy - py * cx
        return (px * px + py * py + 1.0) * (radius * radius) - (crossX * crossX + crossY * crossY + crossZ * crossZ)
    }

    /** One of the two distances at which the ray intersects the sphere. A ray that misses counts as touching it. */
    private fun root(x: Int, y: Int, sign: Double): Double {
        val px = rays.px(x)
        val py = rays.py(y)
        val offset = sign * StrictMath.sqrt(maxOf(discriminant(px, py), 0.0))
        return if (isPerspective) (px * cx + py * cy - cz + offset) / (px * px + py * py + 1.0) else -cz + offset
    }

    private fun nearRoot(x: Int, y: Int): Double = root(x, y, -1.0)

    /** Distance of the visible point at a covered sample, world units along the line of sight. */
    private fun distance(x: Int, y: Int): Double {
        val near = nearRoot(x, y)
        return if (near >= camera.near) near else root(x, y, 1.0)
    }

    /** Distance of the visible point at any sample; NaN if it is not covered. */
    private fun hit(x: Int, y: Int): Double {
        if (!(discriminant(rays.px(x), rays.py(y)) >= 0.0)) return Double.NaN
        val near = nearRoot(x, y)
        if (near >= camera.near) return if (near <= camera.far) near else Double.NaN
        if (sphere.material.sides == Sides.FRONT) return Double.NaN
        val far = root(x, y, 1.0)
        return if (far >= camera.near && far <= camera.far) far else Double.NaN
    }

    /** Minimum and maximum px (or py) of a whole sphere, given the x (or y) of its centre in camera space. */
    private fun extent(c: Double): DoubleArray {
        if (!isPerspective) return doubleArrayOf(c - radius, c + radius)
        val a = cz * cz - radius * radius
        val spread = radius * StrictMath.sqrt(maxOf(c * c + a, 0.0))
        return doubleArrayOf((-c * cz - spread) / a, (-c * cz + spread) / a)
    }

    /**
     * Returns the approximate columns at which row [y] enters and leaves a whole sphere; null if rounding makes them
     * NaN or infinite.
     */
    private fun columns(y: Int): DoubleArray? {
        val py = rays.py(y)
        val middle: Double
        val half: Double
        if (isPerspective) {
            val a = cy * cy + cz * cz - radius * radius
            val b = cx * (py * cy - cz)
            val crossX = py * cz + cy
            val g = (py * py + 1.0) * (radius * radius - cx * cx) - crossX * crossX
            middle = b / a
            half = StrictMath.sqrt(b * b + a * g) / a
        } else {
            middle = cx
            half = StrictMath.sqrt(radius * radius - (py - cy) * (py - cy))
        }
        if (!half.isFinite()) return null
        return doubleArrayOf(rays.columnAt(middle - half), rays.columnAt(middle + half))
    }

    /** Rounds a position down to a column or row of the raster; NaN gives 0. */
    private fun clamp(position: Double, size: Int): Int =
        floor(position).coerceIn(0.0, size.toDouble()).toInt()

    override fun toString(): String = "SpherePrimitive($sphere)"

    companion object {
        /** Sets up a sphere. Returns null if it is degenerate or not between the near and the far plane. */
        fun of(sphere: Sphere, camera: Camera, rays: SampleRays, shader: Shader): SpherePrimitive? {
            val center = sphere.center
            val eye = camera.eye
            val x = center.x() - eye.x()
            val y = center.y() - eye.y()
            val z = center.z() - eye.z()
            val cx = camera.right.x * x + camera.right.y * y + camera.right.z * z
            val cy = camera.upward.x * x + camera.upward.y * y + camera.upward.z * z
            val cz = camera.backward.x * x + camera.backward.y * y + camera.backward.z * z
            val isInRange = -cz + sphere.radius >= camera.near && -cz - sphere.radius <= camera.far
            if (!(isInRange && sphere.radius > 0.0 && cx.isFinite() && cy.isFinite())) return null
            return SpherePrimitive(sphere, camera, rays, cx, cy, cz, shader)
        }
    }
}

/** Converts spheres to primitives. */
internal object SphereStage {
    fun sphere(sphere: Sphere, camera: Camera, rays: SampleRays, lighting: Lighting): Primitive {
        val material = lit(sphere.material)
        val shader = MaterialShader(material, lighting, isPrelit = false)
        val primitive = SpherePrimitive.of(sphere, camera, rays, material.shader ?: shader) ?: return EmptyPrimitive
        if (material.alphaMode != AlphaMode.MASK) return primitive
        return MaskedPrimitive(primitive, shader, material.alphaCutoff)
    }

    /** Returns the shader for samples of [material] that are lit one by one. */
    fun shader(material: Material, lighting: Lighting): Shader =
        material.shader ?: MaterialShader(lit(material), lighting, isPrelit = false)

    /** A sphere has no faces or vertices that could be lit during set-up. */
    private fun lit(material: Material): Material = when (material.shading) {
        Shading.FLAT, Shading.GOURAUD -> material.withShading(Shading.PHONG)
        else -> material
    }
}
