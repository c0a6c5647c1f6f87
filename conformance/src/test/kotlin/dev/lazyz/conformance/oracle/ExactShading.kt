package dev.lazyz.conformance.oracle

import dev.lazyz.Raster
import dev.lazyz.world.AlphaMode
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Material
import dev.lazyz.world.Mesh
import dev.lazyz.world.Polygon
import dev.lazyz.world.Scene
import dev.lazyz.world.Shading
import dev.lazyz.world.Sides
import dev.lazyz.world.Sphere
import dev.lazyz.world.Surface
import org.joml.Vector3d

/** The colours that the contract permits at a sample. */
internal fun interface ExactColor {
    /**
     * Returns red, green, blue, linear, and alpha: the exact values, and those that rounding may give; empty if
     * undefined.
     */
    fun at(x: Int, y: Int): List<DoubleArray>
}

/**
 * The colours of a scene's primitives from contract rules 3.6, 5.5, 6.5 and 6.6 alone, in double precision.
 *
 * It uses nothing of set-up: it projects, clips, interpolates, lights and reads textures itself. Where the last bits
 * decide, the result is undefined or has several correct values: normals across the face, grazing light, borders of
 * texels.
 */
internal class ExactShading(scene: Scene, private val raster: Raster) {
    private val camera: Camera = scene.camera(raster.width, raster.height)
    private val light = ExactLight(camera, scene.lights.ifEmpty { Light.studio(camera) })

    /** The colours of each primitive. */
    val primitives: List<ExactColor> = scene.surfaces.flatMap(::colors)

    private fun colors(surface: Surface): List<ExactColor> = when (surface) {
        is Mesh -> (0 until surface.triangleCount).map { triangle ->
            face(listOf((0 until 3).map { corner(surface, surface.triangles[3 * triangle + it]) }), surface)
        }
        is Polygon -> listOf(face(surface.contours.filter { it.isNotEmpty() }.map { it.map(::corner) }, surface))
        else -> listOf(sphere(surface as Sphere))
    }

    private fun corner(mesh: Mesh, i: Int): Corner {
        val n = DoubleArray(Corner.SIZE)
        for (k in 0 until 3) n[Corner.WORLD + k] = mesh.positions[3 * i + k].toDouble()
        for (k in 0 until 3) n[Corner.NORMAL + k] = (mesh.normals?.get(3 * i + k) ?: 0f).toDouble()
        for (k in 0 until 2) n[Corner.UV + k] = (mesh.uvs?.get(2 * i + k) ?: 0f).toDouble()
        for (k in 0 until 4) n[Corner.COLOR + k] = (mesh.colors?.get(4 * i + k) ?: 1f).toDouble()
        return Corner(n)
    }

    private fun corner(vertex: dev.lazyz.world.Vertex): Corner {
        val color = vertex.color
        val n = DoubleArray(Corner.SIZE)
        doubleArrayOf(vertex.x, vertex.y, vertex.z).copyInto(n, Corner.WORLD)
        doubleArrayOf(vertex.u.toDouble(), vertex.v.toDouble()).copyInto(n, Corner.UV)
        doubleArrayOf(*ExactLight.parts(color), color.alpha.toDouble()).copyInto(n, Corner.COLOR)
        return Corner(n)
    }

    private fun face(contours: List<List<Corner>>, surface: Surface): ExactColor {
        val material = if (surface is Mesh) surface.material else (surface as Polygon).material
        val corners = contours.flatten()
        val open = ExactColor { _, _ -> emptyList() }
        if (corners.size < 3 || corners.any { !it.world.isFinite }) return open

        // The visible side
        val across = newell(contours)
        val side = across.dot(light.toViewer(corners[0].world))
        if (!(Math.abs(side) > 1e-9 * across.length())) return open
        if (side < 0 && material.sides == Sides.FRONT) return ExactColor { x, y -> error("($x, $y) shows the back") }
        val seen = Vector3d(across).normalize(if (side > 0) 1.0 else -1.0)

        // Turn the normals to it; if they are across the face, either way
        val hasNormals = surface is Mesh && surface.normals != null && material.shading != Shading.FLAT
        val along = corners.sumOf { it.normal.dot(seen) }
        val turned = when {
            !hasNormals -> listOf(contours.map { list -> list.map { it.with(Corner.NORMAL, seen.x, seen.y, seen.z) } })
            Math.abs(along) < 1e-9 -> listOf(contours.turned(1.0), contours.turned(-1.0))
            else -> listOf(contours.turned(if (along > 0) 1.0 else -1.0))
        }
        val variants = turned.flatMap { ways -> GRAZES.map { Variant(ways, material, it) } }
        if (variants.any { it.face == null || it.face.isOpen }) return open
        return ExactColor { x, y -> variants.flatMap { it.at(x, y) } }
    }

    private fun List<List<Corner>>.turned(sign: Double) = map { contour ->
        contour.map { it.with(Corner.NORMAL, sign * it.normal.x, sign * it.normal.y, sign * it.normal.z) }
    }

    /** One way to round. */
    private inner class Variant(
        contours: List<List<Corner>>,
        private val material: Material,
        private val graze: Double,
    ) {
        private val isLit = ExactLight.isAtVertices(material.shading)
        val face: ExactFace? = (if (isLit) lit(contours) else contours)?.let { ExactFace(raster, camera, it) }

        /** Light at the vertices, or at their centre. */
        private fun lit(contours: List<List<Corner>>): List<List<Corner>>? {
            val all = contours.flatten()
            val mean = Vector3d()
            for (corner in all) mean.add(corner.world.div(all.size.toDouble()))
            return contours.map { contour ->
                contour.map { corner ->
                    val point = if (material.shading == Shading.FLAT) mean else corner.world
                    val sum = light.at(material, point, corner.normal, false, graze) ?: return null
                    val c = base(material, corner)
                    for (k in 0 until 3) c[k] = c[k] * sum.factor[k] + sum.summand[k]
                    corner.with(Corner.COLOR, *c)
                }
            }
        }

        fun at(x: Int, y: Int): List<DoubleArray> {
            val sample = checkNotNull(face).at(x, y)
            val isSame = listOf(Corner.UV, Corner.UV + 1).map { face.isSame(it) }
            return colors(material, sample, isLit, material.shading == Shading.PHONG, graze, isSame)
        }
    }

    /** The colours of a sample. [isLit] if its colour is already lit, otherwise this function lights it. */
    private fun colors(
        material: Material,
        sample: Corner,
        isLit: Boolean,
        isPhong: Boolean,
        graze: Double,
        isSame: List<Boolean>,
    ): List<DoubleArray> {
        val own = if (isLit) sample.n.copyOfRange(Corner.COLOR, Corner.SIZE) else base(material, sample)
        val factor = doubleArrayOf(1.0, 1.0, 1.0)
        val summand = if (isLit) DoubleArray(3) else ExactLight.parts(material.emission)
        val sum = if (isLit || material.shading == Shading.CONSTANT) {
            ExactLight.Sum(factor, summand)
        } else {
            light.at(material, sample.world, sample.normal, isPhong, graze) ?: return emptyList()
        }
        return texels(material, sample, isSame).map { texel ->
            DoubleArray(4) { k ->
                if (k < 3) own[k] * texel[k] * sum.factor[k] + sum.summand[k] else alpha(material, own[3] * texel[3])
            }
        }
    }

    private fun alpha(material: Material, alpha: Double) = if (material.alphaMode == AlphaMode.BLEND) alpha else 1.0

    /** The texture at the sample first, then around it, within the error of coordinates in single precision. */
    private fun texels(material: Material, sample: Corner, isSame: List<Boolean>): List<DoubleArray> {
        val texture = material.texture ?: return listOf(doubleArrayOf(1.0, 1.0, 1.0, 1.0))
        val exact = ExactTexture(texture)
        val (us, vs) = (0 until 2).map { k ->
            val rounded = sample.n[Corner.UV + k].toFloat()
            val off = maxOf(Math.ulp(rounded).toDouble(), 1e-6)
            if (isSame[k]) listOf(0.0 + rounded) else listOf(0.0 + rounded, rounded - off, rounded + off)
        }
        return us.flatMap { u -> vs.map { v -> exact.at(u, v) } }
    }

    private fun base(material: Material, corner: Corner): DoubleArray {
        val color = doubleArrayOf(*ExactLight.parts(material.baseColor), material.baseColor.alpha.toDouble())
        return DoubleArray(4) { color[it] * corner.n[Corner.COLOR + it] }
    }

    /** A sphere's colours, at the nearer intersection of the ray, or at the farther one if the nearer is clipped. */
    private fun sphere(sphere: Sphere): ExactColor = ExactColor { x, y ->
        val ray = ExactRay(raster, camera, x, y)
        val hits = ray.cut(sphere) ?: return@ExactColor emptyList()
        val isInside = hits[0] < camera.near
        val point = ray.at(if (isInside) hits[1] else hits[0])
        val normal = Vector3d(point).sub(sphere.center).normalize()
        if (Math.abs(normal.y) > 0.9999 || Math.abs(normal.x) < 1e-6) return@ExactColor emptyList()
        val u = 0.5 + Math.atan2(normal.x, normal.z) / (2 * Math.PI)
        val v = Math.acos(normal.y) / Math.PI
        val n = DoubleArray(Corner.SIZE) { 1.0 }
        val turned = Vector3d(normal).mul(if (isInside) -1.0 else 1.0)
        val sample = Corner(n).with(Corner.WORLD, point.x, point.y, point.z)
            .with(Corner.NORMAL, turned.x, turned.y, turned.z).with(Corner.UV, u, v)
        val isPhong = sphere.material.shading != Shading.BLINN_PHONG
        GRAZES.flatMap { colors(sphere.material, sample, false, isPhong, it, listOf(false, false)) }
    }

    private companion object {
        val GRAZES = listOf(0.0, 2e-6, -2e-6)

        /** The contours' common normal: the sum of the cross products of adjacent vertices. */
        fun newell(contours: List<List<Corner>>): Vector3d {
            val sum = Vector3d()
            for (contour in contours) {
                val origin = contour[0].world
                for (i in contour.indices) {
                    val a = contour[i].world.sub(origin)
                    val b = contour[(i + 1) % contour.size].world.sub(origin)
                    sum.add(a.cross(b))
                }
            }
            return sum
        }
    }
}
