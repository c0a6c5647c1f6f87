package dev.lazyz.conformance.oracle

import dev.lazyz.Raster
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.joml.Vector3dc

/** The colours that the contract permits at a sample. */
internal fun interface ExactColor {
    /**
     * Returns red, green, blue, linear, and alpha: the exact values, and those that rounding may give; empty if
     * undefined.
     */
    fun at(x: Int, y: Int): List<DoubleArray>
}

/**
 * The colours of a scene's primitives from contract rules 3.6, 5.5, 6.5, 6.6, 6.8, 6.9, 6.11 and 6.13 alone, in
 * double precision.
 *
 * It uses nothing of set-up: it projects, clips, interpolates, lights and reads textures itself. Where the last bits
 * decide, the result is undefined or has several correct values: normals across the face, grazing light, borders of
 * texels. It does not know points, lines, mip filters, and ambient light and the studio on metallic-roughness
 * materials.
 */
internal class ExactShading(scene: Scene, private val raster: Raster) {
    private val camera: Camera = scene.camera(raster.width, raster.height)
    private val light = ExactLight(
        camera,
        scene.lights.ifEmpty { Light.studio(camera) },
        scene.lights,
        scene.lightIntensity.toDouble(),
        scene.ambientVisibility,
        scene.environment?.takeIf { it.map != null }?.let { ExactEnvironment(it, scene.lightIntensity.toDouble()) },
    )
    private val toneMapping = ExactToneMapping(scene.effectiveToneMapping)

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
        for (k in 0 until 2) n[Corner.UV2 + k] = (mesh.uvs2?.get(2 * i + k) ?: 0f).toDouble()
        for (k in 0 until 4) n[Corner.TANGENT + k] = (mesh.tangents?.get(4 * i + k) ?: 0f).toDouble()
        return Corner(n)
    }

    private fun corner(vertex: dev.lazyz.world.surface.Polygon.Vertex): Corner {
        val color = vertex.color
        val n = DoubleArray(Corner.SIZE)
        doubleArrayOf(vertex.x, vertex.y, vertex.z).copyInto(n, Corner.WORLD)
        doubleArrayOf(vertex.u.toDouble(), vertex.v.toDouble()).copyInto(n, Corner.UV)
        doubleArrayOf(*ExactLight.parts(color), color.alpha.toDouble()).copyInto(n, Corner.COLOR)
        return Corner(n)
    }

    private fun face(contours: List<List<Corner>>, surface: Surface): ExactColor {
        val material = checkNotNull(materialOf(surface))
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
        val isFlat = material.shading == Shading.FLAT && ExactLight.isAtVertices(material)
        val hasNormals = surface is Mesh && surface.normals != null && !isFlat
        val along = corners.sumOf { it.normal.dot(seen) }
        val turned = when {
            !hasNormals -> {
                val ways = contours.turned(if (side > 0) 1.0 else -1.0)
                listOf(ways.map { list -> list.map { it.with(Corner.NORMAL, seen.x, seen.y, seen.z) } })
            }
            Math.abs(along) < 1e-9 -> listOf(contours.turned(1.0), contours.turned(-1.0))
            else -> listOf(contours.turned(if (along > 0) 1.0 else -1.0))
        }
        val variants = turned.flatMap { ways -> GRAZES.map { Variant(ways, material, it) } }
        if (variants.any { it.face == null || it.face.isOpen }) return open
        return ExactColor { x, y -> variants.flatMap { it.at(x, y) } }
    }

    /** Multiplies normals and tangents by [sign]. */
    private fun List<List<Corner>>.turned(sign: Double) = map { contour ->
        contour.map { corner ->
            val numbers = TURNED.associateWith { sign * corner.n[it] }
            Corner(DoubleArray(Corner.SIZE) { numbers[it] ?: corner.n[it] })
        }
    }

    /** One way to round. */
    private inner class Variant(
        contours: List<List<Corner>>,
        private val material: Material,
        private val graze: Double,
    ) {
        private val isLit = ExactLight.isAtVertices(material)
        val face: ExactFace? = (if (isLit) lit(contours) else contours)?.let { ExactFace(raster, camera, it) }

        /** Light at the vertices, or at their centre. */
        private fun lit(contours: List<List<Corner>>): List<List<Corner>>? {
            val all = contours.flatten()
            val mean = Vector3d()
            for (corner in all) mean.add(corner.world.div(all.size.toDouble()))
            return contours.map { contour ->
                contour.map { corner ->
                    val point = if (material.shading == Shading.FLAT) mean else corner.world
                    val place = ExactLight.Place(point, corner.normal)
                    val sum = light.at(material, emission(material), 1.0, place, false, graze) ?: return null
                    val c = base(material, corner)
                    for (k in 0 until 3) c[k] = c[k] * sum.factor[k] + sum.summand[k]
                    corner.with(Corner.COLOR, *c)
                }
            }
        }

        fun at(x: Int, y: Int): List<DoubleArray> {
            val sample = checkNotNull(face).at(x, y)
            return colors(material, sample, isLit, material.shading == Shading.PHONG, graze) { set, coordinate ->
                face.isSame((if (set == 0) Corner.UV else Corner.UV2) + coordinate)
            }
        }
    }

    /** The colours of a sample. [isLit] if its colour is already lit, otherwise this function lights it. */
    private fun colors(
        material: Material,
        sample: Corner,
        isLit: Boolean,
        isPhong: Boolean,
        graze: Double,
        isSame: (set: Int, coordinate: Int) -> Boolean,
    ): List<DoubleArray> {
        val maps = ExactMaps(material, sample, isSame)
        return maps.texels().map { texels ->
            val own = if (isLit) sample.n.copyOfRange(Corner.COLOR, Corner.COLOR + 4) else base(material, sample)
            for (k in 0 until 4) own[k] *= texels.color[k]
            val shown = when {
                isLit -> own
                material.shading == Shading.CONSTANT -> sum(own, emission(material))
                else -> {
                    val normal = maps.normal(texels) ?: return emptyList()
                    val place = ExactLight.Place(sample.world, normal)
                    val stretch = (maps.stretch() ?: return emptyList()).value
                    lit(material, own, texels, place, stretch, sample.normal, isPhong, graze) ?: return emptyList()
                }
            }
            val isAdded = material.emissionMap != null && !ExactLight.hasLobes(material)
            val emitted = if (isAdded) ExactLight.parts(material.emission) else DoubleArray(3)
            val light = DoubleArray(3) { shown[it] + emitted[it] * texels.emission[it] }
            val alpha = if (material.alphaMode == AlphaMode.BLEND) own[3] else 1.0
            doubleArrayOf(*toneMapping.of(light), alpha)
        }
    }

    /** The surface's [own] colour with light; null where rounding decides. */
    private fun lit(
        material: Material,
        own: DoubleArray,
        texels: ExactMaps.Texels,
        place: ExactLight.Place,
        stretch: ExactLight.Stretch?,
        ownNormal: Vector3dc,
        isPhong: Boolean,
        graze: Double,
    ): DoubleArray? {
        val occlusion = 1 + (material.occlusionMap?.strength ?: 0f) * (texels.occlusion - 1)
        val model = material.metallicRoughness
        if (model != null) {
            val (metallic, roughness) = model.metallic * texels.metallic to model.roughness * texels.roughness
            val lobes = model.lobes
            val reflected = light.reflected(
                own, metallic, roughness, lobes?.specular, stretch, place, occlusion, graze,
            ) ?: return null
            if (lobes == null) return sum(reflected, emission(material))
            val emitted = ExactLight.parts(material.emission)
            val below = DoubleArray(3) { reflected[it] + emitted[it] * texels.emission[it] }
            val coat = lobes.clearcoat ?: return below
            return light.coated(below, coat, ExactLight.Place(place.point, ownNormal), place.normal, occlusion, graze)
        }
        val sum = light.at(material, emission(material), occlusion, place, isPhong, graze) ?: return null
        return DoubleArray(3) { own[it] * sum.factor[it] + sum.summand[it] }
    }

    private fun sum(a: DoubleArray, b: DoubleArray) = DoubleArray(3) { a[it] + b[it] }

    /** What light at a point begins with: nothing if a map adds it later. */
    private fun emission(material: Material): DoubleArray =
        if (material.emissionMap == null) ExactLight.parts(material.emission) else DoubleArray(3)

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
        val white = Corner(DoubleArray(Corner.SIZE)).with(Corner.COLOR, 1.0, 1.0, 1.0, 1.0)
        val turned = Vector3d(normal).mul(if (isInside) -1.0 else 1.0)
        val sample = white.with(Corner.WORLD, point.x, point.y, point.z)
            .with(Corner.NORMAL, turned.x, turned.y, turned.z).with(Corner.UV, u, v)
        val isPhong = sphere.material.shading != Shading.BLINN_PHONG
        GRAZES.flatMap { colors(sphere.material, sample, false, isPhong, it) { set, _ -> set == 1 } }
    }

    companion object {
        private val GRAZES = listOf(0.0, 2e-6, -2e-6)

        /** The attributes that are reversed on back faces. */
        private val TURNED = (Corner.NORMAL until Corner.NORMAL + 3) + (Corner.TANGENT until Corner.TANGENT + 4)

        /** Returns the material of a surface that the oracle knows, otherwise null. */
        fun materialOf(surface: Surface): Material? = when (surface) {
            is Mesh -> surface.material
            is Polygon -> surface.material
            is Sphere -> surface.material
            else -> null
        }

        /** The contours' common normal: the sum of the cross products of adjacent vertices. */
        private fun newell(contours: List<List<Corner>>): Vector3d {
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
