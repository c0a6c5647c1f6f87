package dev.lazyz.scenes.scenefile

import dev.lazyz.DepthTest
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightRig
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.images.RadianceImage
import dev.lazyz.scenes.json.JsonMembers
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.json.JsonText
import dev.lazyz.scenes.loading.FileReferences
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.EnvironmentMap
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import java.nio.file.Path
import org.joml.Vector3d

/**
 * Reads a whole scene file; docs/scene-file.md describes the format.
 *
 * @param models reads the model in a file that it refers to, of any format, or of one that its content tells
 */
internal class SceneFileReader(
    private val source: Source,
    private val models: (file: Path, format: SceneFormat?) -> LoadedScene,
) {
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
        val lights = LightReader(source, up)
        val materials = MaterialReader(source)
        members["materials"]?.let(materials::readNamed)
        val surfaces = SurfaceReader(source, models, materials, up)
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

    /** The alpha mode of a material that names none: glass would be opaque, and so no glass, otherwise. */
    fun usualAlphaMode(model: MetallicRoughness?): AlphaMode =
        if (model?.lobes?.transmission != null) AlphaMode.BLEND else AlphaMode.OPAQUE
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

/** Reads the lights, the environment and the tone mapping of a scene file. */
internal class LightReader(private val source: Source, private val up: UpAxis) {
    /** Returns the rig that [node] names, or null if it lists lights. */
    fun rig(node: JsonNode): LightRig? = if (node.isText) node.choice(SceneFileNames.lightRigs) else null

    fun light(node: JsonNode): Light {
        val kinds = arrayOf("ambient", "directional", "point", "spot")
        val (kind, value) = node.members(*kinds).one(*kinds)
        return when (kind) {
            "ambient" -> Light.Ambient(color(value.members("color")))
            "directional" -> {
                val members = value.members("direction", "color")
                value.checked { Light.Directional(vector(members.required("direction")), color(members)) }
            }
            "point" -> {
                val members = value.members("position", "color", "falloff", "range")
                value.checked {
                    Light.Point(vector(members.required("position")), color(members), falloff(value, members))
                }
            }
            else -> spot(value)
        }
    }

    private fun spot(node: JsonNode): Light {
        val members = node.members("position", "direction", "color", "innerAngle", "outerAngle", "falloff", "range")
        return node.checked {
            Light.Spot(
                vector(members.required("position")),
                vector(members.required("direction")),
                color(members),
                members["innerAngle"]?.double() ?: 0.0,
                members["outerAngle"]?.double() ?: DEFAULT_ANGLE,
                falloff(node, members),
            )
        }
    }

    private fun falloff(node: JsonNode, members: JsonMembers): Falloff {
        val range = members["range"]?.double()
        if (members["falloff"]?.choice(SceneFileNames.falloffs) == true) {
            return Falloff.inverseSquare(range ?: Double.POSITIVE_INFINITY)
        }
        if (range != null) node.fail("\"range\" is for lights with a falloff", "add \"falloff\": \"inverse-square\"")
        return Falloff.NONE
    }

    fun environment(node: JsonNode): Environment {
        val (kind, value) = node.members("studio", "picture").one("studio", "picture")
        if (kind == "studio") return node.checked { Environment.studio(value.float()) }
        val members = value.members("image", "intensity", "rotation")
        val map = surroundings(members.required("image"))
        val intensity = members["intensity"]?.float() ?: 1f
        return value.checked { Environment.of(map, intensity, members["rotation"]?.double() ?: 0.0) }
    }

    private fun surroundings(node: JsonNode): EnvironmentMap {
        val found = source.references.find(node.text())
        val file = found.file ?: node.fail("${node.text()} ${found.problem}", found.remedy)
        val bytes = FileReferences.read(file) ?: node.fail("${node.text()} cannot be read", "check its permissions")
        return RadianceImage.read(Source(bytes, "$file", null, source.loading), RenderOptions())
    }

    fun intensity(node: JsonNode): Float {
        val factor = node.float()
        if (!(factor >= 0f && factor.isFinite())) node.fail("must be 0 or more, and finite: $factor")
        return factor
    }

    fun toneMapping(node: JsonNode): ToneMapping {
        val members = node.members("curve", "exposure")
        val curve = members["curve"]?.choice(SceneFileNames.toneCurves) ?: ToneMapping.Curve.NONE
        return node.checked { ToneMapping(curve, members["exposure"]?.double() ?: 0.0) }
    }

    private fun color(members: JsonMembers): Rgba = members["color"]?.let(ColorReader::read) ?: Rgba.WHITE

    private fun vector(node: JsonNode): Vector3d = up.toWorld(Vector3d(node.doubles(3)))

    private companion object {
        const val DEFAULT_ANGLE = 45.0
    }
}
