package dev.lazyz.scenes.gltf.document

/** An object that can have extensions. */
internal abstract class ExtensibleJson(json: GltfObject?) {
    private val extensions: Map<*, *>? = json?.extensions()

    /** Returns the object of the extension [name], or null. */
    fun extension(name: String): Map<*, *>? = extensions?.get(name) as? Map<*, *>
}

/**
 * A glTF file, with the objects and properties that this reader uses (section 5 of the specification). Each may be
 * missing, also where the specification requires it; a list is empty then, and can contain null.
 */
internal class ModelJson(json: GltfObject) : ExtensibleJson(json) {
    val scene: Int? = json.whole("scene")
    val scenes: List<SceneJson?> = json.all("scenes", ::SceneJson)
    val nodes: List<NodeJson?> = json.all("nodes", ::NodeJson)
    val meshes: List<MeshJson?> = json.all("meshes", ::MeshJson)
    val skins: List<SkinJson?> = json.all("skins", ::SkinJson)
    val animations: List<AnimationJson?> = json.all("animations", ::AnimationJson)
    val cameras: List<CameraJson?> = json.all("cameras", ::CameraJson)
    val materials: List<MaterialJson?> = json.all("materials", ::MaterialJson)
    val textures: List<TextureJson?> = json.all("textures", ::TextureJson)
    val samplers: List<SamplerJson?> = json.all("samplers", ::SamplerJson)
    val images: List<ImageJson?> = json.all("images", ::ImageJson)
    val accessors: List<AccessorJson?> = json.all("accessors", ::AccessorJson)
    val bufferViews: List<BufferViewJson?> = json.all("bufferViews", ::BufferViewJson)
    val buffers: List<BufferJson?> = json.all("buffers", ::BufferJson)
    val extensionsUsed: List<String> = json.texts("extensionsUsed")
    val extensionsRequired: List<String> = json.texts("extensionsRequired")

    /** The names of the variants of the model. */
    val variants: List<String?> =
        json.extension(VARIANTS) { extension -> extension.all("variants") { it.text("name").orEmpty() } }.orEmpty()
}

/** The extension by which materials have variants. */
internal const val VARIANTS: String = "KHR_materials_variants"

internal class SceneJson(json: GltfObject) {
    val nodes: List<Int?> = json.references("nodes").orEmpty()
}

internal class NodeJson(json: GltfObject) : ExtensibleJson(json) {
    val name: String? = json.text("name")
    val children: List<Int?> = json.references("children").orEmpty()
    val matrix: FloatArray? = json.floats("matrix", 16)
    val translation: FloatArray? = json.floats("translation", 3)
    val rotation: FloatArray? = json.fractions("rotation", 4, least = -1.0)
    val scale: FloatArray? = json.floats("scale", 3)
    val mesh: Int? = json.whole("mesh")
    val skin: Int? = json.whole("skin")
    val camera: Int? = json.whole("camera")
    val weights: List<Float?>? = json.numbers("weights")
}

internal class MeshJson(json: GltfObject) {
    val name: String? = json.text("name")
    val primitives: List<PrimitiveJson?> = json.all("primitives", ::PrimitiveJson)
    val weights: List<Float?>? = json.numbers("weights")
}

internal class PrimitiveJson(json: GltfObject) : ExtensibleJson(json) {
    val mode: Int? = json.code("mode", 0, 1, 2, 3, 4, 5, 6)
    val attributes: Map<String, Int?> = json.referencesByName("attributes").orEmpty()
    val indices: Int? = json.whole("indices")
    val material: Int? = json.whole("material")
    val variants: List<VariantJson?> = json.extension(VARIANTS) { it.all("mappings", ::VariantJson) }.orEmpty()
    val targets: List<Map<String, Int?>?> = json.listOfReferencesByName("targets").orEmpty()
}

/** Which material a primitive has in some variants of the model. */
internal class VariantJson(json: GltfObject) {
    val material: Int? = json.whole("material")
    val variants: List<Int?> = json.references("variants").orEmpty()
}

internal class SkinJson(json: GltfObject) {
    val joints: List<Int?> = json.references("joints").orEmpty()
    val inverseBindMatrices: Int? = json.whole("inverseBindMatrices")
}

internal class AnimationJson(json: GltfObject) {
    val channels: List<ChannelJson?> = json.all("channels", ::ChannelJson)
    val samplers: List<KeyframesJson?> = json.all("samplers", ::KeyframesJson)
}

internal class ChannelJson(json: GltfObject) {
    val sampler: Int? = json.whole("sampler")
    val target: TargetJson? = json.one("target", ::TargetJson)
}

internal class TargetJson(json: GltfObject) {
    val node: Int? = json.whole("node")
    val path: String? = json.word("path", "translation", "rotation", "scale", "weights")
}

internal class KeyframesJson(json: GltfObject) {
    val input: Int? = json.whole("input")
    val output: Int? = json.whole("output")
    val interpolation: String? = json.word("interpolation", "LINEAR", "STEP", "CUBICSPLINE")
}

internal class CameraJson(json: GltfObject) {
    val name: String? = json.text("name")
    val perspective: PerspectiveJson? = json.one("perspective", ::PerspectiveJson)
    val orthographic: OrthographicJson? = json.one("orthographic", ::OrthographicJson)
}

internal class PerspectiveJson(json: GltfObject) {
    val yfov: Float? = json.number("yfov", above = 0f)
    val znear: Float? = json.number("znear", above = 0f)
    val zfar: Float? = json.number("zfar", above = 0f)
}

internal class OrthographicJson(json: GltfObject) {
    val ymag: Float? = json.number("ymag")
    val znear: Float? = json.number("znear", least = 0f)
    val zfar: Float? = json.number("zfar", above = 0f)
}

/** Without [json], the default material. */
internal class MaterialJson(json: GltfObject?) : ExtensibleJson(json) {
    val name: String? = json?.text("name")
    val pbrMetallicRoughness: MetallicRoughnessJson? = json?.one("pbrMetallicRoughness", ::MetallicRoughnessJson)
    val normalTexture: NormalTextureJson? = json?.one("normalTexture", ::NormalTextureJson)
    val occlusionTexture: OcclusionTextureJson? = json?.one("occlusionTexture", ::OcclusionTextureJson)
    val emissiveTexture: TextureInfoJson? = json?.one("emissiveTexture", ::TextureInfoJson)
    val emissiveFactor: FloatArray? = json?.fractions("emissiveFactor", 3)
    val alphaMode: String? = json?.word("alphaMode", "OPAQUE", "MASK", "BLEND")
    val alphaCutoff: Float? = json?.number("alphaCutoff", least = 0f)
    val doubleSided: Boolean? = json?.flag("doubleSided")
    val specular: SpecularJson? = json?.extension(LobeExtensions.SPECULAR, ::SpecularJson)
    val glossiness: GlossinessJson? = json?.extension(SpecularGlossiness.NAME, ::GlossinessJson)
        ?.takeIf { it.isTextured && pbrMetallicRoughness?.metallicRoughnessTexture == null }
    val sheen: SheenJson? = json?.extension(LobeExtensions.SHEEN, ::SheenJson)
    val clearcoat: ClearcoatJson? = json?.extension(LobeExtensions.CLEARCOAT, ::ClearcoatJson)
    val transmission: TransmissionJson? = json?.extension(LobeExtensions.TRANSMISSION, ::TransmissionJson)
    val iridescence: IridescenceJson? = json?.extension(LobeExtensions.IRIDESCENCE, ::IridescenceJson)
    val anisotropy: AnisotropyJson? = json?.extension(LobeExtensions.ANISOTROPY, ::AnisotropyJson)
    val volume: VolumeJson? = json?.extension(LobeExtensions.VOLUME, ::VolumeJson)
}

/** The extensions of materials that are lobes. */
internal object LobeExtensions {
    const val SPECULAR: String = "KHR_materials_specular"
    const val SHEEN: String = "KHR_materials_sheen"
    const val CLEARCOAT: String = "KHR_materials_clearcoat"
    const val TRANSMISSION: String = "KHR_materials_transmission"
    const val VOLUME: String = "KHR_materials_volume"
    const val IRIDESCENCE: String = "KHR_materials_iridescence"
    const val ANISOTROPY: String = "KHR_materials_anisotropy"
    const val REFRACTION: String = "KHR_materials_ior"
    val all: List<String> =
        listOf(SPECULAR, SHEEN, CLEARCOAT, TRANSMISSION, VOLUME, IRIDESCENCE, ANISOTROPY, REFRACTION)
}

/** What [SpecularGlossiness] does not convert: the reflection of a material with textures. */
internal class GlossinessJson(json: GltfObject) {
    val specularFactor: FloatArray? = json.fractions("specularFactor", 3)
    val factor: Float? = json.fraction("glossinessFactor")
    val texture: TextureInfoJson? = json.one("specularGlossinessTexture", ::TextureInfoJson)
    val isTextured: Boolean = texture != null || json.one("diffuseTexture", ::TextureInfoJson) != null
}

internal class SpecularJson(json: GltfObject) {
    val factor: Float? = json.fraction("specularFactor")
    val texture: TextureInfoJson? = json.one("specularTexture", ::TextureInfoJson)
    val colorFactor: FloatArray? = json.floats("specularColorFactor", 3)
    val colorTexture: TextureInfoJson? = json.one("specularColorTexture", ::TextureInfoJson)
}

internal class SheenJson(json: GltfObject) {
    val colorFactor: FloatArray? = json.fractions("sheenColorFactor", 3)
    val colorTexture: TextureInfoJson? = json.one("sheenColorTexture", ::TextureInfoJson)
    val roughnessFactor: Float? = json.fraction("sheenRoughnessFactor")
    val roughnessTexture: TextureInfoJson? = json.one("sheenRoughnessTexture", ::TextureInfoJson)
}

internal class ClearcoatJson(json: GltfObject) {
    val factor: Float? = json.fraction("clearcoatFactor")
    val texture: TextureInfoJson? = json.one("clearcoatTexture", ::TextureInfoJson)
    val roughnessFactor: Float? = json.fraction("clearcoatRoughnessFactor")
    val roughnessTexture: TextureInfoJson? = json.one("clearcoatRoughnessTexture", ::TextureInfoJson)
    val normalTexture: NormalTextureJson? = json.one("clearcoatNormalTexture", ::NormalTextureJson)
}

internal class TransmissionJson(json: GltfObject) {
    val factor: Float? = json.fraction("transmissionFactor")
    val texture: TextureInfoJson? = json.one("transmissionTexture", ::TextureInfoJson)
}

internal class IridescenceJson(json: GltfObject) {
    val factor: Float? = json.fraction("iridescenceFactor")
    val texture: TextureInfoJson? = json.one("iridescenceTexture", ::TextureInfoJson)
    val refraction: Float? = json.number("iridescenceIor", least = 1f)
    val minimum: Float? = json.number("iridescenceThicknessMinimum", least = 0f)
    val maximum: Float? = json.number("iridescenceThicknessMaximum", least = 0f)
    val thicknessTexture: TextureInfoJson? = json.one("iridescenceThicknessTexture", ::TextureInfoJson)
}

internal class AnisotropyJson(json: GltfObject) {
    val strength: Float? = json.fraction("anisotropyStrength")
    val rotation: Float? = json.number("anisotropyRotation")
    val texture: TextureInfoJson? = json.one("anisotropyTexture", ::TextureInfoJson)
}

internal class VolumeJson(json: GltfObject) {
    val thicknessFactor: Float? = json.number("thicknessFactor", least = 0f)
    val thicknessTexture: TextureInfoJson? = json.one("thicknessTexture", ::TextureInfoJson)
    val attenuationDistance: Float? = json.number("attenuationDistance", above = 0f)
    val attenuationColor: FloatArray? = json.fractions("attenuationColor", 3)
}

internal class MetallicRoughnessJson(json: GltfObject) {
    val baseColorFactor: FloatArray? = json.fractions("baseColorFactor", 4)
    val baseColorTexture: TextureInfoJson? = json.one("baseColorTexture", ::TextureInfoJson)
    val metallicFactor: Float? = json.fraction("metallicFactor")
    val roughnessFactor: Float? = json.fraction("roughnessFactor")
    val metallicRoughnessTexture: TextureInfoJson? = json.one("metallicRoughnessTexture", ::TextureInfoJson)
}

/** Which texture a material uses, and how. */
internal open class TextureInfoJson(json: GltfObject) : ExtensibleJson(json) {
    val index: Int? = json.whole("index")
    val texCoord: Int? = json.whole("texCoord", 0..Int.MAX_VALUE)
}

internal class NormalTextureJson(json: GltfObject) : TextureInfoJson(json) {
    val scale: Float? = json.number("scale")
}

internal class OcclusionTextureJson(json: GltfObject) : TextureInfoJson(json) {
    val strength: Float? = json.fraction("strength")
}

internal class TextureJson(json: GltfObject) : ExtensibleJson(json) {
    val source: Int? = json.whole("source")
    val sampler: Int? = json.whole("sampler")
}

internal class SamplerJson(json: GltfObject) {
    val magFilter: Int? = json.code("magFilter", NEAREST, LINEAR)
    val wrapS: Int? = json.code("wrapS", CLAMP_TO_EDGE, MIRRORED_REPEAT, REPEAT)
    val wrapT: Int? = json.code("wrapT", CLAMP_TO_EDGE, MIRRORED_REPEAT, REPEAT)

    companion object {
        const val NEAREST = 9728
        const val CLAMP_TO_EDGE = 33071
        const val MIRRORED_REPEAT = 33648
        private const val LINEAR = 9729
        private const val REPEAT = 10497
    }
}

internal class ImageJson(json: GltfObject) {
    val name: String? = json.text("name")
    val uri: String? = json.text("uri")
    val bufferView: Int? = json.whole("bufferView")
}

internal class AccessorJson(json: GltfObject) {
    val bufferView: Int? = json.whole("bufferView")
    val byteOffset: Int? = json.whole("byteOffset", 0..Int.MAX_VALUE)
    val componentType: Int? = json.code("componentType", *ComponentType.all)
    val normalized: Boolean? = json.flag("normalized")
    val count: Int? = json.whole("count", 1..Int.MAX_VALUE)
    val type: String? = json.word("type", *ElementType.names)
    val sparse: SparseJson? = json.one("sparse", ::SparseJson)
}

internal class SparseJson(json: GltfObject) {
    val count: Int? = json.whole("count", 1..Int.MAX_VALUE)
    val indices: SparsePartJson? = json.one("indices", ::SparsePartJson)
    val values: SparsePartJson? = json.one("values", ::SparsePartJson)
}

/** The places of sparse elements, whose [componentType] is given, or their values. */
internal class SparsePartJson(json: GltfObject) {
    val bufferView: Int? = json.whole("bufferView")
    val byteOffset: Int? = json.whole("byteOffset", 0..Int.MAX_VALUE)
    val componentType: Int? = json.code(
        "componentType", ComponentType.UNSIGNED_BYTE, ComponentType.UNSIGNED_SHORT, ComponentType.UNSIGNED_INT,
    )
}

internal class BufferViewJson(json: GltfObject) : ExtensibleJson(json) {
    val buffer: Int? = json.whole("buffer")
    val byteOffset: Int? = json.whole("byteOffset", 0..Int.MAX_VALUE)
    val byteLength: Int? = json.whole("byteLength", 1..Int.MAX_VALUE)
    val byteStride: Int? = json.whole("byteStride", 4..252)
}

internal class BufferJson(json: GltfObject) {
    val uri: String? = json.text("uri")
    val byteLength: Int? = json.whole("byteLength", 1..Int.MAX_VALUE)
}

/** Access to the values of extensions, which are nested maps. */
internal object ExtensionValues {
    /** Returns a number in an extension's object, or [missing] if there is no finite number. */
    fun number(extension: Map<*, *>, name: String, missing: Double): Double =
        (extension[name] as? Number)?.toDouble()?.takeIf { it.isFinite() } ?: missing

    /** Returns a pair of numbers in an extension's object. [missing] replaces each that is not a finite number. */
    fun pair(extension: Map<*, *>, name: String, missing: Double): List<Double> =
        List(2) {
            ((extension[name] as? List<*>)?.getOrNull(it) as? Number)?.toDouble()?.takeIf { n -> n.isFinite() }
                ?: missing
        }
}
