package dev.lazyz.scenes

import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.lighting.AmbientOcclusion
import dev.lazyz.lighting.GroundShadow
import dev.lazyz.lighting.Matcap
import dev.lazyz.spi.Shader
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.OcclusionMap
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureMap.UvTransform
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d

/** Small scenes for [GoldenTest], a feature each: what the built-in scenes, made to look good, do not show. */
internal object GoldenScenes {
    private val camera = Camera.perspective(
        Vector3d(0.4, 0.7, 6.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 40.0, 1.0, 20.0,
    )

    private val lights = listOf(
        Light.Ambient(Rgba(0.10f, 0.08f, 0.12f)),
        Light.Directional(Vector3d(-1.0, -2.0, -4.0), Rgba(0.6f, 0.5f, 0.4f)),
        Light.Point(Vector3d(1.5, 1.0, 2.5), Rgba(0.3f, 0.5f, 0.4f)),
    )

    /** Eight by eight texels, of all opacities from 0 to 1. */
    private val leaf = Texture(
        8, 8,
        IntArray(64) {
            (it * 4 + 3 shl 24) or (it * 37 and 255 shl 16) or (255 - it * 3 shl 8) or
                (it * 11 and 255)
        },
    )

    /** By id. */
    val all: Map<String, () -> Scene> = Shading.entries.associate { shading ->
        shading.name.lowercase() to { scene(shown(shining(shading))) }
    } + mapOf(
        "behind" to { scene(Shading.entries.flatMapIndexed { i, shading -> behind(shining(shading), 2 - i) }) },
        "one-sided" to {
            scene(
                shown(shining(Shading.GOURAUD, sides = Sides.FRONT)) +
                    behind(shining(Shading.PHONG, sides = Sides.FRONT), 0)
            )
        },
        "texture" to { scene(textured()) },
        "mask" to {
            scene(
                shown(shining(Shading.PHONG, leaf, AlphaMode.MASK)) +
                    behind(shining(Shading.GOURAUD, leaf, AlphaMode.MASK), 1) + wall(),
            )
        },
        "blend" to {
            scene(
                shown(shining(Shading.GOURAUD, leaf, AlphaMode.BLEND)) +
                    Shading.entries.flatMapIndexed { i, shading ->
                        behind(shining(shading, null, AlphaMode.BLEND), 2 - i)
                    } +
                    wall(),
            )
        },
        "metallic" to { scene(shown(metallic())).withEnvironment(Environment.studio(0.6f)) },
        "metallic-aces" to {
            scene(shown(metallic()) + behind(metallic(), 1)).withLights(lights + spot).withLightIntensity(1.25f)
                .withToneMapping(ToneMapping(ToneMapping.Curve.ACES, 0.5)).withEnvironment(Environment.NONE)
        },
        "trilinear" to { scene(floors(MipFilter.TRILINEAR)) },
        "anisotropic" to { scene(floors(MipFilter.ANISOTROPIC)) },
        "occluded" to { occluded(scene(shown(metallic()) + wall()).withEnvironment(Environment.USUAL)) },
        "on-ground" to { onGround(scene(shown(shining(Shading.BLINN_PHONG)))) },
        "mirrored" to { scene(mirrored()) },
        "normal-map" to { scene(bumpy()).withEnvironment(Environment.NONE) },
        "lobes" to { scene(lacquered()).withEnvironment(Environment.USUAL) },
        "glass" to {
            val pane = Lobes.Transmission(0.9f, null, 1f, null, Rgba(0.3f, 0.6f, 0.9f), 2f)
            val glass = Material(Rgba.WHITE, alphaMode = AlphaMode.BLEND)
                .withMetallicRoughness(MetallicRoughness(0f, 0.1f, null, Lobes(transmission = pane)))
            scene(shown(glass) + behind(glass, 0) + wall()).withEnvironment(Environment.USUAL)
        },
        "matcap" to { shadedBy { Matcap(smooth(leaf), it, tint = Rgba(0.9f, 1f, 0.8f)) } },
        "matcap-orthographic" to {
            val camera = Camera.orthographic(
                Vector3d(1.0, 2.0, 6.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 5.0, 1.0, 20.0,
            )
            shadedBy(camera) { Matcap(leaf, it) }
        },
    )

    private val spot = Light.Spot(
        Vector3d(0.0, 2.0, 4.0), Vector3d(0.0, -1.0, -2.0), Rgba(6f, 5f, 4f), 8.0, 25.0, Falloff.inverseSquare(9.0),
    )

    /** A mixture of plastic and metal, with all maps. */
    private fun metallic(): Material {
        val numbers = leaf.withEncoding(Texture.Encoding.LINEAR).withMipFilter(MipFilter.TRILINEAR)
        val map = TextureMap(numbers, transform = UvTransform(0.7, 0.9, 20.0, 0.1, 0.2))
        return shining(Shading.PHONG, leaf).withMetallicRoughness(MetallicRoughness(0.8f, 0.9f, map))
            .withOcclusionMap(OcclusionMap(map, 0.7f)).withEmissionMap(map)
    }

    /** A floor and a ball with a texture that is far too fine for most samples. */
    private fun floors(mipFilter: MipFilter): List<Surface> {
        val fine = Texture(64, 32, IntArray(64 * 32) { leaf.texel(it * 5 % 8, it / 64 * 3 % 8) or (0xFF shl 24) })
        val material = Material(texture = fine.withMipFilter(mipFilter), shading = Shading.FLAT)
        val positions = floatArrayOf(-4f, -1f, 4f, 4f, -1f, 4f, 4f, -0.6f, -8f, -4f, -0.6f, -8f)
        val floor = Mesh(
            positions, intArrayOf(0, 1, 2, 0, 2, 3), material,
            uvs = floatArrayOf(0f, 0f, 9f, 1f, 9f, 14f, 0f, 14f),
        )
        return listOf(floor, Sphere(Vector3d(0.3, 0.6, 0.0), 1.0, material))
    }

    private fun smooth(texture: Texture) =
        texture.withSampling(Texture.Filter.BILINEAR, Texture.Wrap.REPEAT, Texture.Wrap.REPEAT)

    private fun shadedBy(viewpoint: Camera = camera, shader: (Camera) -> Shader): Scene {
        val material = Material(shader = shader(viewpoint))
        return scene(shown(material) + behind(material, 1)).withViewpoint(viewpoint)
    }

    /** A relief under lights and in the studio, also on faces seen from behind. */
    private fun bumpy(): List<Surface> {
        val relief = smooth(leaf.withEncoding(Texture.Encoding.LINEAR))
        val transform = UvTransform(0.8, 1.1, 15.0, 0.2, 0.1)
        val map = NormalMap(TextureMap(relief, transform = transform), 0.7f)
        val plastic = shining(Shading.PHONG).withNormalMap(map)
        val metal = plastic.withMetallicRoughness(MetallicRoughness(0.6f, 0.4f))
        return (listOf(sheet(plastic)) + behind(metal, 1) + behind(plastic, -1)).map {
            (it as Mesh).withTangents(transform = transform)
        }
    }

    /** All lobes that reflect, with maps and without. */
    private fun lacquered(): List<Surface> {
        val map = TextureMap(smooth(leaf.withEncoding(Texture.Encoding.LINEAR)))
        val colors = TextureMap(smooth(leaf))
        val plastic = shining(Shading.PHONG).withNormalMap(NormalMap(map, 0.4f))
        fun of(lobes: Lobes) = plastic.withMetallicRoughness(MetallicRoughness(0.2f, 0.6f, null, lobes))
        val cloth = of(Lobes(sheen = Lobes.Sheen(Rgba(0.5f, 0.7f, 0.9f), 0.4f, colors, map)))
        val coat = of(Lobes(clearcoat = Lobes.Clearcoat(1f, 0.1f, null, map, NormalMap(map, 0.5f))))
        val film = Lobes.Iridescence(0.8f, 1.5f, 600f, 200f, null, map)
        val glossy = of(Lobes(Lobes.Specular(0.9f, Rgba(0.9f, 0.6f, 1f), 2f, map, colors), iridescence = film))
        return (listOf(sheet(coat)) + behind(cloth, 1) + behind(glossy, -1)).map { (it as Mesh).withTangents() } +
            Sphere(Vector3d(1.2, -0.9, 0.9), 0.6, coat.withNormalMap(null))
    }

    /** Two squares with a texture that is mirrored along one axis, or along both, and read far beyond its sides. */
    private fun mirrored(): List<Surface> = List(2) { i ->
        val wrap = listOf(Texture.Wrap.MIRROR, Texture.Wrap.REPEAT)
        val texture = leaf.withSampling(Texture.Filter.entries[i], Texture.Wrap.MIRROR, wrap[i], MipFilter.entries[i])
        square(i * 2.2 - 2.2, -1.0, 2.6f + i, texture)
    }

    private fun occluded(scene: Scene) = scene.withAmbientVisibility(AmbientOcclusion.of(scene, 48, 64))

    private fun onGround(scene: Scene): Scene {
        val shadow = GroundShadow.of(scene)
        val above = Camera.perspective(
            Vector3d(2.0, 5.0, 9.0), Vector3d(0.0, -1.0, 0.0), Vector3d(0.0, 1.0, 0.0), 50.0, 1.0, 30.0,
        )
        return scene.withSurfaces(scene.surfaces + shadow).withViewpoint(shadow.camera(above))
    }

    private fun scene(surfaces: List<Surface>) = Scene(surfaces, lights, camera, Rgba(0.2f, 0.3f, 0.5f))

    private fun shining(
        shading: Shading,
        texture: Texture? = null,
        alphaMode: AlphaMode = AlphaMode.OPAQUE,
        sides: Sides = Sides.BOTH,
    ) = Material(
        Rgba(0.7f, 0.5f, 0.3f, if (alphaMode == AlphaMode.BLEND) 0.6f else 1f), texture, shading,
        Rgba(0.5f, 0.6f, 0.7f), 9, Rgba(0.02f, 0.06f, 0.04f), alphaMode, alphaCutoff = 0.25f, sides = sides,
    )

    /** A sheet with a bump, a five-pointed star and a sphere, of one material. */
    private fun shown(material: Material): List<Surface> =
        listOf(sheet(material), star(material), Sphere(Vector3d(1.2, -0.9, 0.5), 0.6, material))

    /** A sheet of 6 x 6 vertices with normals of its own, texture coordinates, and vertex colours. */
    private fun sheet(material: Material): Mesh {
        val side = 6
        val positions = FloatArray(3 * side * side)
        val normals = FloatArray(positions.size)
        val uvs = FloatArray(2 * side * side)
        val colors = FloatArray(4 * side * side)
        for (i in 0 until side * side) {
            val x = i % side / 2.5 - 1
            val y = i / side / 2.5 - 1
            val bump = 1 / (1 + 2 * (x * x + y * y))
            floatArrayOf((2 * x).toFloat(), (2 * y).toFloat(), bump.toFloat()).copyInto(positions, 3 * i)
            val slope = 2 * bump * bump
            floatArrayOf((slope * x).toFloat(), (slope * y).toFloat(), 1f).copyInto(normals, 3 * i)
            floatArrayOf((x + 1).toFloat(), (1 - y).toFloat()).copyInto(uvs, 2 * i)
            floatArrayOf(1f - i % 3 * 0.3f, 0.4f + i % 5 * 0.15f, 1f, 1f - i % 4 * 0.2f).copyInto(colors, 4 * i)
        }
        val triangles = IntArray(6 * (side - 1) * (side - 1)) { i ->
            val cell = i / 6
            cell / (side - 1) * side + cell % (side - 1) + intArrayOf(0, 1, side, side, 1, side + 1)[i % 6]
        }
        return Mesh(positions, triangles, material, normals, uvs, colors)
    }

    private fun star(material: Material): Polygon {
        val places = listOf(0.0 to 1.0, 0.6 to -0.8, -0.95 to 0.3, 0.95 to 0.3, -0.6 to -0.8)
        val contour = places.mapIndexed { i, (x, y) ->
            val color = Rgba(1f, 0.2f * i, 0.5f, 0.7f)
            Vertex(x - 1.2, y + 0.9, 0.9 + 0.3 * x, (x + 1).toFloat(), (y + 1).toFloat(), color)
        }
        return Polygon(listOf(contour), material, FillRule.EVEN_ODD)
    }

    /** Two large triangles seen from behind, at height [row]: one with equal normals, one with different ones. */
    private fun behind(material: Material, row: Int): List<Surface> = listOf(0, 1).map { i ->
        val x = -2.1f + 2.1f * i
        val y = 0.8f * row - 0.4f
        val positions = floatArrayOf(x, y, 1f, x + 1f, y + 0.75f, 0.8f + 0.1f * i, x + 2f, y, 0.6f)
        val normals = FloatArray(9) { floatArrayOf(0.3f, -0.2f, 1f)[it % 3] + if (i == 1 && it == 3) 0.5f else 0f }
        val uvs = floatArrayOf(0f, 0f, 1f, 2f, 2f, 0f)
        val colors = FloatArray(12) { if (i == 0) floatArrayOf(0.9f, 0.5f, 0.7f, 0.8f)[it % 4] else 1f - it * 0.05f }
        Mesh(positions, intArrayOf(0, 1, 2), material, normals, uvs, colors)
    }

    /** Four squares side by side: both filters, both ways to go on beyond the texture, coordinates far and near. */
    private fun textured(): List<Surface> = List(4) { i ->
        val filter = Texture.Filter.entries[i % 2]
        val wrap = listOf(Texture.Wrap.REPEAT, Texture.Wrap.CLAMP)
        val texture = leaf.withSampling(filter, wrap[i / 2], wrap[1 - i / 2])
        square(i % 2 * 2.2 - 2.2, i / 2 * 2.0 - 2.0, 1.5f + i, texture)
    }

    /** A square with its lower left corner at ([x], [y]), and coordinates of the texture from -[reach] to [reach]. */
    private fun square(x: Double, y: Double, reach: Float, texture: Texture): Polygon {
        val contour = listOf(
            Vertex(x, y, 0.5, -reach, reach), Vertex(x + 2, y, 0.0, reach, reach),
            Vertex(x + 2, y + 1.8, -0.5, reach, -reach), Vertex(x, y + 1.8, 0.0, -reach, -reach),
        )
        return Polygon(
            listOf(contour),
            Material(Rgba(0.9f, 0.8f, 1f), texture, Shading.CONSTANT, emission = Rgba(0f, 0.1f, 0f)),
        )
    }

    /** An opaque wall behind everything. */
    private fun wall(): Surface {
        val positions = floatArrayOf(-3f, -3f, -1f, 3f, -3f, -1.5f, 3f, 0.5f, -1f, -3f, 0.5f, -2f)
        return Mesh(positions, intArrayOf(0, 1, 2, 0, 2, 3), Material(Rgba(0.8f, 0.8f, 0.2f), shading = Shading.FLAT))
    }
}
