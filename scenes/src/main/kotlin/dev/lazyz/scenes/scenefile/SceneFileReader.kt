package dev.lazyz.scenes.scenefile

import dev.lazyz.DepthTest
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightRig
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.json.JsonText
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.world.Camera
import dev.lazyz.world.FittedViewpoint.Fit
import dev.lazyz.world.Scene
import dev.lazyz.world.ToneMapping
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter

/** Reads a whole scene file; docs/scene-file.md describes the format. */
internal class SceneFileReader(private val source: Source) {
    fun read(): LoadedScene {
        val element = JsonText.parse(source)
        val root = JsonNode(source, "", element)

        // Check the version first: another version can have other keys
        if (element is Map<*, *> && "lazyz" !in element) missingVersion(root, element)
        if (element is Map<*, *>) version(root.named().getValue("lazyz"))
        val members =
            root.members(
                "lazyz", "size", "up", "background", "depth", "camera", "lights", "environment",
                "lightIntensity", "toneMapping", "picture", "materials", "surfaces",
            )

        // Read what surfaces and lights depend on first
        val up = members["up"]?.choice(SceneFileNames.upAxes) ?: UpAxis.Y
        val cameras = CameraReader(up)
        val lights = LightReader(up)
        val materials = MaterialReader(source)
        members["materials"]?.let(materials::readNamed)
        val surfaces = SurfaceReader(source, materials, up)
        val rig = members["lights"]?.let(lights::rig)
        val scene = Scene(
            surfaces = members["surfaces"]?.items().orEmpty().flatMap(surfaces::read),
            lights = if (rig == null) members["lights"]?.items().orEmpty().map(lights::light) else emptyList(),
            viewpoint = members["camera"]?.let(cameras::viewpoint) ?: Camera.fit(),
            background = members["background"]?.let(ColorReader::read) ?: Rgba.WHITE,
        )
        val size = members["size"]?.let(::size)
        val lit = if (rig == null) scene else rigged(members.required("lights"), scene, rig, size)
        val whole = lit.withEnvironment(members["environment"]?.let(lights::environment) ?: lit.environment)
            .withLightIntensity(members["lightIntensity"]?.let(lights::intensity) ?: 1f)
            .withToneMapping(members["toneMapping"]?.let(lights::toneMapping))
        val depth = members["depth"]?.let(::depth) ?: DepthRules()
        return LoadedScene(
            whole, source.warnings, size, depth,
            lightRig = rig, files = source.files, format = SceneFormat.SCENE,
            picture = members["picture"]?.let(::picture).orEmpty(),
        )
    }

    /** Returns [scene] in the light of [rig] for its camera, whose direction does not depend on the [size]. */
    private fun rigged(node: JsonNode, scene: Scene, rig: LightRig, size: ImageSize?): Scene = node.checked {
        rig.on(scene, scene.camera(size?.width ?: 1, size?.height ?: 1))
    }

    private fun missingVersion(root: JsonNode, element: Map<*, *>): Nothing {
        if ("asset" in element) root.fail("is glTF, not a scene file", "name it *.gltf")
        root.fail("is no scene file: \"lazyz\" is missing", "begin it with \"lazyz\": ${SceneFile.VERSION}")
    }

    private fun version(node: JsonNode) {
        val version = node.integer()
        if (version != SceneFile.VERSION) {
            node.fail("version $version is not supported", "this library reads version ${SceneFile.VERSION}")
        }
    }

    private fun depth(node: JsonNode): DepthRules {
        val members = node.members("convention", "test", "background")
        val convention = members["convention"]?.choice(SceneFileNames.conventions) ?: DepthConvention.SMALLER_IS_NEARER
        return node.checked {
            DepthRules(
                convention,
                members["test"]?.choice(SceneFileNames.depthTests) ?: convention.nearest,
                members["background"]?.integer() ?: convention.farthest,
            )
        }
    }

    /** Returns the words about a picture, which mean something. */
    private fun picture(node: JsonNode): Map<String, List<String>> {
        val words = node.named().mapValues { (_, value) -> value.itemsOrSelf() }
        var settings = PictureSettings()
        for ((name, values) in words) {
            for (value in values) {
                val word = value.word()
                if (word.length > LONGEST) value.fail("a value has at most $LONGEST characters")
                settings = value.checked { PictureDoor.SCENE_FILE.read(settings, listOf(name to word)) }
            }
        }
        node.checked { settings.check() }
        return words.mapValues { (_, values) -> values.map { it.word() } }
    }

    private fun size(node: JsonNode): ImageSize {
        val sides = node.integers()
        if (sides.size != 2) node.fail("needs 2 numbers, width and height, not ${sides.size}")
        return node.checked { ImageSize(sides[0], sides[1]) }
    }

    private companion object {
        /** Characters of the longest word about a picture that has a meaning, and more. */
        const val LONGEST = 100
    }
}

/** The names of the library's enum constants in scene files: lower case, with hyphens. */
internal object SceneFileNames {
    val projections: Map<String, Fit> = names(Fit.entries)
    val shadings: Map<String, Shading> = names(Shading.entries)
    val alphaModes: Map<String, AlphaMode> = names(AlphaMode.entries)
    val sides: Map<String, Sides> = names(Sides.entries)
    val filters: Map<String, Texture.Filter> = names(Texture.Filter.entries)
    val mipFilters: Map<String, MipFilter> = names(MipFilter.entries)
    val wraps: Map<String, Texture.Wrap> = names(Texture.Wrap.entries)
    val encodings: Map<String, Texture.Encoding> = names(Texture.Encoding.entries)
    val toneCurves: Map<String, ToneMapping.Curve> = names(ToneMapping.Curve.entries)
    val lightRigs: Map<String, LightRig> = names(LightRig.entries)
    val fillRules: Map<String, FillRule> = names(FillRule.entries)

    val conventions: Map<String, DepthConvention> = names(DepthConvention.entries)
    val depthTests: Map<String, DepthTest> = names(DepthTest.entries)

    val upAxes: Map<String, UpAxis> = UpAxis.entries.associateBy { it.id }

    const val INVERSE_SQUARE: String = "inverse-square"

    /** Whether a light decreases with the square of the distance. */
    val falloffs: Map<String, Boolean> = mapOf("none" to false, INVERSE_SQUARE to true)

    fun of(constant: Enum<*>): String = constant.name.lowercase().replace('_', '-')

    private fun <T : Enum<T>> names(constants: List<T>): Map<String, T> = constants.associateBy { of(it) }
}
