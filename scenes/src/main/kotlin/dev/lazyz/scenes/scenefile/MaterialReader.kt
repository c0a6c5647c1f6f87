package dev.lazyz.scenes.scenefile

import dev.lazyz.Rgba
import dev.lazyz.scenes.Tint
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.json.JsonMembers
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.writers.PngSink
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import java.io.ByteArrayOutputStream
import java.util.Base64

/** Reads materials and their maps. */
internal class MaterialReader(source: Source) {
    private val named = HashMap<String, Material>()
    private val textures = TextureMapReader(source)

    /** Reads the materials that surfaces can refer to by name. */
    fun readNamed(node: JsonNode) {
        for ((name, value) in node.named()) named[name] = material(value, name)
    }

    /** Reads a reference to a named material, or an inline material. */
    fun read(node: JsonNode): Material {
        if (!node.isText) return material(node, "")
        val name = node.text()
        return named[name] ?: node.fail(
            "there is no material \"$name\"",
            if (named.isEmpty()) "add it to \"materials\"" else "known: ${named.keys.sorted().joinToString()}",
        )
    }

    private fun material(node: JsonNode, name: String): Material {
        val members = node.members(
            "name", "baseColor", "texture", "shading", "specular", "shininess", "emission", "alphaMode", "alphaCutoff",
            "sides", "tint", "metallicRoughness", "normalMap", "occlusionMap", "emissionMap",
        )
        val plain = Material()
        val physical = members["metallicRoughness"]?.let(::model)
        return node.checked {
            Material(
                baseColor = members["baseColor"]?.let(ColorReader::read) ?: plain.baseColor,
                shading = members["shading"]?.choice(SceneFileNames.shadings) ?: plain.shading,
                specular = members["specular"]?.let(ColorReader::read) ?: plain.specular,
                shininess = members["shininess"]?.integer() ?: plain.shininess,
                emission = members["emission"]?.let(ColorReader::read) ?: plain.emission,
                alphaMode = members["alphaMode"]?.choice(SceneFileNames.alphaModes)
                    ?: SceneFileNames.usualAlphaMode(physical),
                alphaCutoff = members["alphaCutoff"]?.float() ?: plain.alphaCutoff,
                sides = members["sides"]?.choice(SceneFileNames.sides) ?: plain.sides,
                shader = members["tint"]?.integer()?.let(::Tint),
                name = members["name"]?.text() ?: name,
            ).withTextureMap(members["texture"]?.let { textures.read(it, Texture.Encoding.SRGB) })
                .withMetallicRoughness(physical)
                .withNormalMap(members["normalMap"]?.let(::normalMap))
                .withOcclusionMap(members["occlusionMap"]?.let(::occlusionMap))
                .withEmissionMap(members["emissionMap"]?.let { textures.read(it, Texture.Encoding.SRGB) })
        }
    }

    private fun model(node: JsonNode): MetallicRoughness {
        val members = node.members(
            "metallic", "roughness", "map", "specular", "sheen", "clearcoat", "transmission", "iridescence",
            "anisotropy",
        )
        val plain = MetallicRoughness()
        val map = members["map"]?.let { textures.read(it, Texture.Encoding.LINEAR) }
        return node.checked {
            MetallicRoughness(
                members["metallic"]?.float() ?: plain.metallic,
                members["roughness"]?.float() ?: plain.roughness,
                map,
                lobes(members),
            )
        }
    }

    private fun lobes(members: JsonMembers): Lobes? {
        val specular = members["specular"]?.let { node ->
            val m = node.members("strength", "color", "refraction", "strengthMap", "colorMap")
            val (strengths, colors) = numbers(m["strengthMap"]) to colors(m["colorMap"])
            node.checked {
                Lobes.Specular(
                    m["strength"]?.float() ?: 1f, m["color"]?.let(ColorReader::read) ?: Rgba.WHITE,
                    m["refraction"]?.float() ?: 1.5f, strengths, colors,
                )
            }
        }
        val sheen = members["sheen"]?.let { node ->
            val m = node.members("color", "roughness", "colorMap", "roughnessMap")
            val (colors, roughness) = colors(m["colorMap"]) to numbers(m["roughnessMap"])
            val color = ColorReader.read(m.required("color"))
            node.checked { Lobes.Sheen(color, m["roughness"]?.float() ?: 0f, colors, roughness) }
        }
        val clearcoat = members["clearcoat"]?.let { node ->
            val m = node.members("strength", "roughness", "strengthMap", "roughnessMap", "normalMap")
            val (strengths, roughness) = numbers(m["strengthMap"]) to numbers(m["roughnessMap"])
            val normals = m["normalMap"]?.let(::normalMap)
            node.checked {
                Lobes.Clearcoat(
                    m["strength"]?.float() ?: 1f, m["roughness"]?.float() ?: 0f, strengths, roughness, normals,
                )
            }
        }
        val transmission = members["transmission"]?.let { node ->
            val m = node.members(
                "strength", "strengthMap", "thickness", "thicknessMap", "attenuationColor", "attenuationDistance",
            )
            val (strengths, thickness) = numbers(m["strengthMap"]) to numbers(m["thicknessMap"])
            node.checked {
                Lobes.Transmission(
                    m["strength"]?.float() ?: 1f, strengths, m["thickness"]?.float() ?: 0f, thickness,
                    m["attenuationColor"]?.let(ColorReader::read) ?: Rgba.WHITE,
                    m["attenuationDistance"]?.float() ?: Float.POSITIVE_INFINITY,
                )
            }
        }
        val iridescence = members["iridescence"]?.let { node ->
            val m = node.members(
                "strength", "refraction", "thickness", "leastThickness", "strengthMap", "thicknessMap",
            )
            val (strengths, thickness) = numbers(m["strengthMap"]) to numbers(m["thicknessMap"])
            node.checked {
                Lobes.Iridescence(
                    m["strength"]?.float() ?: 1f, m["refraction"]?.float() ?: 1.3f, m["thickness"]?.float() ?: 400f,
                    m["leastThickness"]?.float() ?: 100f, strengths, thickness,
                )
            }
        }
        val anisotropy = members["anisotropy"]?.let { node ->
            val m = node.members("strength", "rotation", "map")
            val map = numbers(m["map"])
            node.checked { Lobes.Anisotropy(m["strength"]?.float() ?: 1f, m["rotation"]?.float() ?: 0f, map) }
        }
        return Lobes(specular, sheen, clearcoat, transmission, iridescence, anisotropy).takeIf { it != Lobes() }
    }

    private fun numbers(node: JsonNode?) = node?.let { textures.read(it, Texture.Encoding.LINEAR) }

    private fun colors(node: JsonNode?) = node?.let { textures.read(it, Texture.Encoding.SRGB) }

    private fun normalMap(node: JsonNode): NormalMap? {
        val members = node.members("map", "scale")
        val map = textures.read(members.required("map"), Texture.Encoding.LINEAR) ?: return null
        return node.checked { NormalMap(map, members["scale"]?.float() ?: 1f) }
    }

    private fun occlusionMap(node: JsonNode): OcclusionMap? {
        val members = node.members("map", "strength")
        val map = textures.read(members.required("map"), Texture.Encoding.LINEAR) ?: return null
        return node.checked { OcclusionMap(map, members["strength"]?.float() ?: 1f) }
    }
}

/** Reads textures and how they are laid on surfaces. An image that several of them use is read once. */
internal class TextureMapReader(private val source: Source) {
    private val pictures = HashMap<String, Texture?>()

    /**
     * Returns the map that [node] describes: the name of a file, or an object. Null, with a warning, if its file is
     * missing or cannot be read.
     *
     * @param plain the meaning of the codes if the file does not say
     */
    fun read(node: JsonNode, plain: Texture.Encoding): TextureMap? {
        if (node.isText) return picture(node)?.let { TextureMap(it.withEncoding(plain)) }
        val members = node.members("image", "filter", "mipFilter", "wrap", "name", "encoding", "uvSet", "transform")
        val picture = picture(members.required("image")) ?: return null
        val filter = members["filter"]?.choice(SceneFileNames.filters) ?: Texture.Filter.BILINEAR
        val mipFilter = members["mipFilter"]?.choice(SceneFileNames.mipFilters) ?: MipFilter.ANISOTROPIC
        val (wrapU, wrapV) = members["wrap"]?.let(::wraps) ?: (Texture.Wrap.REPEAT to Texture.Wrap.REPEAT)
        val name = members["name"]?.text() ?: picture.name
        val encoding = members["encoding"]?.choice(SceneFileNames.encodings) ?: plain
        val texture = picture.withSampling(filter, wrapU, wrapV, mipFilter).withName(name).withEncoding(encoding)
        val transform = members["transform"]?.let(::transform) ?: UvTransform.IDENTITY
        return node.checked { TextureMap(texture, members["uvSet"]?.integer() ?: 0, transform) }
    }

    private fun transform(node: JsonNode): UvTransform {
        val members = node.members("scale", "rotation", "offset")
        val scale = members["scale"]?.doubles(2) ?: doubleArrayOf(1.0, 1.0)
        val offset = members["offset"]?.doubles(2) ?: doubleArrayOf(0.0, 0.0)
        val rotation = members["rotation"]?.double() ?: 0.0
        return node.checked { UvTransform(scale[0], scale[1], rotation, offset[0], offset[1]) }
    }

    private fun wraps(node: JsonNode): Pair<Texture.Wrap, Texture.Wrap> {
        if (node.isText) return node.choice(SceneFileNames.wraps).let { it to it }
        val items = node.items()
        if (items.size != 2) node.fail("needs 2 names, across and down, not ${items.size}")
        return items[0].choice(SceneFileNames.wraps) to items[1].choice(SceneFileNames.wraps)
    }

    /** Returns the image, or null with a warning if its file is missing or cannot be read. */
    private fun picture(node: JsonNode): Texture? {
        val reference = node.text()
        if (reference !in pictures) {
            val isEmbedded = EmbeddedImage.isEmbedded(reference)
            pictures[reference] =
                if (isEmbedded) EmbeddedImage.read(source, node) else TextureFiles.find(source, reference)
        }
        return pictures[reference]
    }
}

/** An image within a scene file: a PNG as a `data:` URI (RFC 2397) that keeps every texel unchanged. */
internal object EmbeddedImage {
    fun isEmbedded(reference: String): Boolean = reference.startsWith("data:")

    fun write(texture: Texture): String {
        val bytes = ByteArrayOutputStream()
        val row = IntArray(texture.width)
        PngSink(bytes, texture.width, texture.height).use { sink ->
            for (y in 0 until texture.height) {
                for (x in row.indices) row[x] = texture.texel(x, y)
                sink.row(y, row, row, row)
            }
        }
        return Html.pngUri(bytes.toByteArray())
    }

    fun read(source: Source, node: JsonNode): Texture {
        val reference = node.text()
        if (!reference.startsWith(Html.PNG_URI)) {
            node.fail("embedded picture is not a PNG in base64: ${reference.take(40)}", "begin it with ${Html.PNG_URI}")
        }
        val bytes = try {
            Base64.getDecoder().decode(reference.substring(Html.PNG_URI.length))
        } catch (e: IllegalArgumentException) {
            node.fail("embedded picture is not base64: ${e.message}", "embed it again")
        }
        return TextureFiles.decode(source, bytes, "") ?: node.fail("embedded picture is not a PNG", "embed it again")
    }
}
