package dev.lazyz.conformance.slow

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface

/**
 * A renderer that shares nothing with the library but the description of a scene: double precision, a ray through each
 * sample, tried with every triangle, point and line. What it computes is from the specification of glTF 2.0 and its
 * extensions, and from textbooks, not from the contract. It does not know light at vertices, spheres and polygons.
 *
 * @param side samples of a pixel in each direction
 * @param filter how textures are read: by their texels, so that the mean of many samples is the truth, or by mip levels
 */
internal class SlowRenderer(
    private val scene: Scene,
    private val width: Int,
    private val height: Int,
    private val side: Int,
    private val filter: Filter = Filter.TEXELS,
) {
    enum class Filter { TEXELS, LEVELS }
    private val camera = scene.camera(width, height)
    private val isPerspective = camera.projection is Projection.Perspective
    private val backward = (camera.eye.slow() - camera.target.slow()).unit()
    private val right = camera.up.slow().cross(backward).unit()
    private val upward = backward.cross(right)
    private val light = SlowLight(scene, right, backward)
    private val levels = HashMap<Pair<Texture, Int>, Level>()
    private val faces = scene.surfaces.filterIsInstance<Mesh>().associateWith { mesh ->
        List(mesh.triangleCount) { Face(mesh, IntArray(3) { k -> mesh.triangles[3 * it + k] }) }
    }

    /** Something that a ray meets. [uv] are the coordinates of another ray on the same plane. */
    private class Hit(
        val depth: Double,
        val point: Vec,
        val material: Material,
        val color: DoubleArray,
        val normal: Vec?,
        val tangent: DoubleArray?,
        val uv: (set: Int, x: Double, y: Double) -> DoubleArray,
    )

    /** The colour of a pixel, linear. */
    fun pixel(column: Int, row: Int): DoubleArray {
        val sum = DoubleArray(3)
        for (j in 0 until side) {
            for (i in 0 until side) {
                val color = sample(column + (i + 0.5) / side, row + (j + 0.5) / side)
                for (k in 0 until 3) sum[k] += color[k] / (side * side)
            }
        }
        return sum
    }

    /** The material in front at (x, y), or null. */
    fun front(x: Double, y: Double): Material? = hits(x, y).lastOrNull()?.material

    /** All that the ray through (x, y) meets, from back to front; pixels from the upper left corner. */
    private fun hits(x: Double, y: Double): List<Hit> =
        scene.surfaces.flatMap { hits(it, x, y) }.sortedByDescending { it.depth }

    private fun sample(x: Double, y: Double): DoubleArray {
        var color = parts(scene.background)
        for (hit in hits(x, y)) {
            val (own, alpha, passed) = shaded(hit, x, y)
            color = DoubleArray(3) { (own[it] + passed[it] * color[it]) * alpha + color[it] * (1 - alpha) }
        }
        return DoubleArray(3) { color[it].coerceIn(0.0, 1.0) }
    }

    /** The ray through (x, y): a point on it and its direction, which goes 1 along the line of sight. */
    private fun ray(x: Double, y: Double): Pair<Vec, Vec> {
        val tall = camera.halfHeight()
        val across = right * ((2 * x / width - 1) * tall * width / height) + upward * ((1 - 2 * y / height) * tall)
        val eye = camera.eye.slow()
        return if (isPerspective) eye to across - backward else eye + across to backward * -1.0
    }

    /** The place of a point in the picture, and its depth. */
    private fun place(point: Vec): Vec {
        val from = point - camera.eye.slow()
        val depth = -(from dot backward)
        val tall = camera.halfHeight() * if (isPerspective) depth else 1.0
        return Vec(
            ((from dot right) / (tall * width / height) + 1) / 2 * width,
            (1 - (from dot upward) / tall) / 2 * height,
            depth,
        )
    }

    private fun hits(surface: Surface, x: Double, y: Double): List<Hit> = when (surface) {
        is Mesh -> ray(x, y).let { (from, along) -> faces.getValue(surface).mapNotNull { it.hit(from, along) } }
        is Points -> (0 until surface.pointCount).mapNotNull { point(surface, it, x, y) }
        is Lines -> (0 until surface.segmentCount).mapNotNull { segment(surface, it, x, y) }
        else -> error("the slow renderer does not know $surface")
    }.filter { it.depth > camera.near && it.depth < camera.far }

    private inner class Face(private val mesh: Mesh, private val corners: IntArray) {
        private val a = vertex(mesh.positions, corners[0]) + mesh.origin.slow()
        private val b = vertex(mesh.positions, corners[1]) + mesh.origin.slow()
        private val c = vertex(mesh.positions, corners[2]) + mesh.origin.slow()
        private val normal = (b - a).cross(c - a)
        private val area = normal dot normal

        /** Where a ray meets the plane: the distance, and the weights of the corners. */
        private fun meet(from: Vec, along: Vec): DoubleArray {
            val distance = ((a - from) dot normal) / (along dot normal)
            val p = from + along * distance
            val wa = ((c - b).cross(p - b) dot normal) / area
            val wb = ((a - c).cross(p - c) dot normal) / area
            return doubleArrayOf(distance, wa, wb, 1 - wa - wb)
        }

        private fun mean(values: FloatArray, size: Int, weights: DoubleArray) = DoubleArray(size) { k ->
            (0 until 3).sumOf { weights[it + 1] * values[size * corners[it] + k] }
        }

        fun hit(from: Vec, along: Vec): Hit? {
            val met = meet(from, along)
            if (!(met[1] >= 0 && met[2] >= 0 && met[3] >= 0)) return null
            val toViewer = if ((normal dot along) > 0) normal * -1.0 else normal
            var shown = mesh.normals?.let { mean(it, 3, met).let { (nx, ny, nz) -> Vec(nx, ny, nz) } } ?: toViewer
            val side = if ((shown dot toViewer) < 0) -1.0 else 1.0
            shown *= side
            val color = mesh.colors?.let { mean(it, 4, met) } ?: WHITE
            val tangent = mesh.tangents?.let { all -> mean(all, 4, met).also { t -> for (k in 0..3) t[k] *= side } }
            return Hit(met[0], from + along * met[0], mesh.material, color, shown.unit(), tangent) { set, x, y ->
                val (start, way) = ray(x, y)
                mean(checkNotNull(if (set == 0) mesh.uvs else mesh.uvs2), 2, meet(start, way))
            }
        }
    }

    private fun point(points: Points, number: Int, x: Double, y: Double): Hit? {
        val at = place(vertex(points.positions, number) + points.origin.slow())
        val half = maxOf(points.size, 1.0) / 2
        if (!(Math.abs(at.x - x) < half && Math.abs(at.y - y) < half)) return null
        val color = points.colors?.let { colors -> DoubleArray(4) { colors[4 * number + it].toDouble() } }
        return flat(at.z, points.material, color)
    }

    private fun segment(lines: Lines, number: Int, x: Double, y: Double): Hit? {
        val ends = IntArray(2) { lines.segments[2 * number + it] }
        val (p, q) = ends.map { place(vertex(lines.positions, it) + lines.origin.slow()) }
        val (dx, dy) = q.x - p.x to q.y - p.y
        val length = Math.hypot(dx, dy)
        val along = ((x - p.x) * dx + (y - p.y) * dy) / length
        val across = ((x - p.x) * dy - (y - p.y) * dx) / length
        val half = maxOf(lines.width, 1.0) / 2
        if (Math.abs(across) > half || along < -half || along > length + half) return null

        // The part of the segment in space: under perspective, 1 / depth is linear in the picture
        val seen = (along / length).coerceIn(0.0, 1.0)
        val part = if (isPerspective) seen * p.z / (q.z + seen * (p.z - q.z)) else seen
        val color = lines.colors?.let { colors ->
            DoubleArray(4) { (1 - part) * colors[4 * ends[0] + it] + part * colors[4 * ends[1] + it] }
        }
        return flat(p.z + part * (q.z - p.z), lines.material, color)
    }

    /** A point or a line: its own colour, without light. */
    private fun flat(depth: Double, material: Material, color: DoubleArray?): Hit =
        Hit(depth, Vec(0.0, 0.0, 0.0), material, color ?: WHITE, null, null) { _, _, _ -> error("no coordinates") }

    /** The colour of a hit, its opacity, and what passes glass. */
    private fun shaded(hit: Hit, x: Double, y: Double): Triple<DoubleArray, Double, DoubleArray> {
        fun read(map: TextureMap?): DoubleArray? = map?.takeIf { hit.normal != null }?.let { at(it, hit, x, y) }
        val base = parts(hit.material.baseColor)
        val texel = read(hit.material.textureMap)
        for (k in 0 until 4) base[k] *= hit.color[k] * (texel?.get(k) ?: 1.0)
        val alpha = when (hit.material.alphaMode) {
            AlphaMode.OPAQUE -> 1.0
            AlphaMode.MASK -> if (base[3] >= hit.material.alphaCutoff) 1.0 else 0.0
            AlphaMode.BLEND -> base[3].coerceIn(0.0, 1.0)
        }
        val emission = parts(hit.material.emission)
        read(hit.material.emissionMap)?.let { for (k in 0 until 3) emission[k] *= it[k] }
        val model = hit.material.metallicRoughness
        val isDark = hit.normal == null || hit.material.shading == Shading.CONSTANT
        if (isDark || alpha == 0.0) return Triple(DoubleArray(3) { base[it] + emission[it] }, alpha, DoubleArray(3))
        val v = if (isPerspective) (camera.eye.slow() - hit.point).unit() else backward
        val normal = bumped(hit, read(hit.material.normalMap?.map))
        if (model == null) {
            val occlusion = hit.material.occlusionMap?.let { 1 + it.strength * (read(it.map)!![0] - 1) } ?: 1.0
            val place = SlowLight.Place(hit.point, normal)
            return Triple(light.classical(hit.material, base, place, v, occlusion, emission), alpha, DoubleArray(3))
        }
        val parameters = read(model.map)
        val surface = SlowLight.Surface(
            base, model.metallic * (parameters?.get(2) ?: 1.0), model.roughness * (parameters?.get(1) ?: 1.0),
            normal, hit.normal!!, along(hit), model.lobes,
        )
        return Triple(light.of(surface, hit.point, v, emission), alpha, light.passed(surface, v))
    }

    /** The tangent and the bitangent, or null. */
    private fun tangents(hit: Hit): Pair<Vec, Vec>? {
        val n = hit.normal!!
        val (x, y, z, w) = hit.tangent ?: return null
        val t = Vec(x, y, z).let { it - n * (it dot n) }.unit()
        return t to n.cross(t) * Math.signum(w)
    }

    /** The direction of anisotropy: the tangent, turned toward the bitangent. */
    private fun along(hit: Hit): Vec? {
        val angle = Math.toRadians(hit.material.metallicRoughness!!.lobes?.anisotropy?.rotation?.toDouble() ?: 0.0)
        return tangents(hit)?.let { (t, b) -> t * Math.cos(angle) + b * Math.sin(angle) }
    }

    /** The normal with that of a normal map, whose colours are [texel]. */
    private fun bumped(hit: Hit, texel: DoubleArray?): Vec {
        val n = hit.normal!!
        if (texel == null) return n
        val (t, b) = tangents(hit)!!
        val scale = hit.material.normalMap!!.scale.toDouble()
        val (x, y, z) = DoubleArray(3) { 2 * texel[it] - 1 }
        return (t * (x * scale) + b * (y * scale) + n * z).unit()
    }

    private fun at(map: TextureMap, hit: Hit, x: Double, y: Double): DoubleArray {
        fun uv(x: Double, y: Double) = turned(map.transform, hit.uv(map.uvSet, x, y))
        val (u, v) = uv(x, y)
        val texture = map.texture
        if (filter == Filter.TEXELS) return level(texture, 0).at(u, v)

        // The longest way in the texture, in texels, that a step of one sample in any direction makes
        val step = 1.0 / side
        val longest = (0 until 64).maxOf {
            val (dx, dy) = Math.cos(Math.PI * it / 64) * step / 2 to Math.sin(Math.PI * it / 64) * step / 2
            val (to, from) = uv(x + dx, y + dy) to uv(x - dx, y - dy)
            Math.hypot((to[0] - from[0]) * texture.width, (to[1] - from[1]) * texture.height)
        }
        val last = 31 - Integer.numberOfLeadingZeros(maxOf(texture.width, texture.height))
        val number = (Math.log(longest) / Math.log(2.0)).coerceIn(0.0, last.toDouble())
        val part = number - Math.floor(number)
        val near = level(texture, number.toInt()).at(u, v)
        val far = level(texture, minOf(number.toInt() + 1, last)).at(u, v)
        return DoubleArray(4) { near[it] * (1 - part) + far[it] * part }
    }

    /** `KHR_texture_transform`: scale, then a rotation counter-clockwise where v points down, then the offset. */
    private fun turned(transform: TextureMap.UvTransform, uv: DoubleArray): DoubleArray {
        val (u, v) = uv[0] * transform.scaleU to uv[1] * transform.scaleV
        val (c, s) = Math.toRadians(transform.rotation).let { Math.cos(it) to Math.sin(it) }
        return doubleArrayOf(c * u + s * v + transform.offsetU, c * v - s * u + transform.offsetV)
    }

    private fun level(texture: Texture, number: Int) = levels.getOrPut(texture to number) { Level(texture, number) }

    /** A mip level, each texel the mean of a square of the image, whose sides are powers of two. */
    private class Level(private val texture: Texture, number: Int) {
        private val width = maxOf(texture.width shr number, 1)
        private val height = maxOf(texture.height shr number, 1)
        private val texels = Array(width * height) { mean(it % width, it / width) }

        private fun mean(x: Int, y: Int): DoubleArray {
            val (w, h) = texture.width / width to texture.height / height
            val sum = DoubleArray(4)
            for (i in 0 until w * h) {
                val argb = texture.texel(x * w + i % w, y * h + i / w)
                for (k in 0 until 3) {
                    val code = (argb ushr (16 - 8 * k) and 0xFF) / 255.0
                    sum[k] += (if (texture.encoding == Texture.Encoding.SRGB) linear(code) else code) / (w * h)
                }
                sum[3] += (argb ushr 24) / 255.0 / (w * h)
            }
            return sum
        }

        fun at(u: Double, v: Double): DoubleArray {
            if (texture.filter == Texture.Filter.NEAREST) return texel(Math.floor(u * width), Math.floor(v * height))
            val (x, y) = u * width - 0.5 to v * height - 0.5
            val (fx, fy) = x - Math.floor(x) to y - Math.floor(y)
            val corners = (0 until 4).map { texel(Math.floor(x) + it % 2, Math.floor(y) + it / 2) }
            return DoubleArray(4) {
                (corners[0][it] * (1 - fx) + corners[1][it] * fx) * (1 - fy) +
                    (corners[2][it] * (1 - fx) + corners[3][it] * fx) * fy
            }
        }

        private fun texel(x: Double, y: Double): DoubleArray =
            texels[index(y, height, texture.wrapV) * width + index(x, width, texture.wrapU)]

        private fun index(at: Double, size: Int, wrap: Texture.Wrap): Int = when (wrap) {
            Texture.Wrap.CLAMP -> at.coerceIn(0.0, size - 1.0)
            Texture.Wrap.REPEAT -> at - size * Math.floor(at / size)
            Texture.Wrap.MIRROR -> Math.abs(at + 0.5 - 2 * size * Math.round((at + 0.5) / (2 * size))) - 0.5
        }.toInt()
    }

    companion object {
        private val WHITE = DoubleArray(4) { 1.0 }

        fun parts(color: Rgba): DoubleArray =
            doubleArrayOf(color.red.toDouble(), color.green.toDouble(), color.blue.toDouble(), color.alpha.toDouble())

        private fun vertex(positions: FloatArray, number: Int): Vec {
            val (x, y, z) = DoubleArray(3) { positions[3 * number + it].toDouble() }
            return Vec(x, y, z)
        }

        /** The curve of sRGB (IEC 61966-2-1), 0..1, and its inverse. */
        fun linear(code: Double): Double = if (code <= 0.04045) code / 12.92 else Math.pow((code + 0.055) / 1.055, 2.4)

        fun encoded(light: Double): Double =
            if (light <= 0.0031308) light * 12.92 else 1.055 * Math.pow(light, 1 / 2.4) - 0.055
    }
}
