package dev.lazyz.world.material

import dev.lazyz.Rgba
import dev.lazyz.world.material.Material.NormalMap

/**
 * What a physically based material reflects and lets through besides its metallic-roughness model (contract rule 6.16):
 * the extensions of glTF 2.0 with the same names. Immutable and thread safe. Each costs time at every shaded sample.
 *
 * @property specular how a dielectric reflects; null for glass or plastic, which have the index of refraction 1.5
 * @property sheen the shine of fibres, above all others but the clear coat; null for none
 * @property clearcoat a transparent layer above all others; null for none
 * @property iridescence a thin film that colours reflections; null for none
 * @property transmission light that passes; it has an effect with [Material.AlphaMode.BLEND] only; null for none
 * @property anisotropy highlights that are longer in one direction; null for round ones
 */
public class Lobes @JvmOverloads constructor(
    public val specular: Specular? = null,
    public val sheen: Sheen? = null,
    public val clearcoat: Clearcoat? = null,
    public val transmission: Transmission? = null,
    public val iridescence: Iridescence? = null,
    public val anisotropy: Anisotropy? = null,
) {
    private val parts get() = listOfNotNull(specular, sheen, clearcoat, transmission, iridescence, anisotropy)

    /** All maps. */
    internal val maps: List<TextureMap> get() = parts.flatMap { it.maps }

    /** Returns these lobes with what [change] makes of each map. */
    internal fun mapped(change: (TextureMap) -> TextureMap?): Lobes = Lobes(
        specular?.run { Specular(strength, color, refraction, strengthMap?.let(change), colorMap?.let(change)) },
        sheen?.run { Sheen(color, roughness, colorMap?.let(change), roughnessMap?.let(change)) },
        clearcoat?.run {
            val normals = normalMap?.let { normals -> change(normals.map)?.let { NormalMap(it, normals.scale) } }
            Clearcoat(strength, roughness, strengthMap?.let(change), roughnessMap?.let(change), normals)
        },
        transmission?.run {
            Transmission(
                strength, strengthMap?.let(change), thickness, thicknessMap?.let(change), attenuationColor,
                attenuationDistance,
            )
        },
        iridescence?.run {
            Iridescence(
                strength, refraction, thickness, leastThickness, strengthMap?.let(change), thicknessMap?.let(change),
            )
        },
        anisotropy?.run { Anisotropy(strength, rotation, map?.let(change)) },
    )

    override fun equals(other: Any?): Boolean = other is Lobes && parts == other.parts

    override fun hashCode(): Int = parts.hashCode()

    override fun toString(): String = "Lobes(${parts.joinToString()})"

    /** One of the lobes, equal to another of its kind with the same properties. */
    public abstract class Lobe internal constructor() {
        /** All properties, maps too, in the order of the constructor. */
        internal abstract val properties: List<Any?>

        internal val maps: List<TextureMap>
            get() = properties.mapNotNull { if (it is NormalMap) it.map else it as? TextureMap }

        override fun equals(other: Any?): Boolean =
            other is Lobe && javaClass == other.javaClass && properties == other.properties

        override fun hashCode(): Int = properties.hashCode()

        override fun toString(): String = javaClass.simpleName + properties.joinToString(", ", "(", ")")
    }

    /**
     * The reflection of a dielectric: `KHR_materials_specular` and `KHR_materials_ior`.
     *
     * @property strength factor of the reflection, 0..1
     * @property color factor of the reflection at normal incidence, linear light
     * @property refraction the index of refraction, at least 1; 0 for a reflection of [color] at every angle
     * @property strengthMap its alpha multiplies [strength]; or null
     * @property colorMap multiplies [color]; or null
     * @throws IllegalArgumentException if a number is out of range
     */
    public class Specular @JvmOverloads constructor(
        public val strength: Float = 1f,
        public val color: Rgba = Rgba.WHITE,
        public val refraction: Float = 1.5f,
        public val strengthMap: TextureMap? = null,
        public val colorMap: TextureMap? = null,
    ) : Lobe() {
        init {
            requireFraction("strength", strength)
            require(refraction == 0f || (refraction >= 1f && refraction.isFinite())) {
                "refraction must be 0, or 1 or more: $refraction"
            }
        }

        override val properties: List<Any?> get() = listOf(strength, color, refraction, strengthMap, colorMap)
    }

    /**
     * The shine of cloth at grazing angles: `KHR_materials_sheen`.
     *
     * @property color factor of the shine, linear light
     * @property roughness 0 for a narrow rim, 1 for an even shine
     * @property colorMap multiplies [color]; or null
     * @property roughnessMap its alpha multiplies [roughness]; or null
     * @throws IllegalArgumentException if [roughness] is not in 0..1
     */
    public class Sheen @JvmOverloads constructor(
        public val color: Rgba,
        public val roughness: Float = 0f,
        public val colorMap: TextureMap? = null,
        public val roughnessMap: TextureMap? = null,
    ) : Lobe() {
        init {
            requireFraction("roughness", roughness)
        }

        override val properties: List<Any?> get() = listOf(color, roughness, colorMap, roughnessMap)
    }

    /**
     * A layer of lacquer with the index of refraction 1.5: `KHR_materials_clearcoat`.
     *
     * @property strength the part of the surface that has the layer, 0..1
     * @property roughness its own roughness, 0..1
     * @property strengthMap its red multiplies [strength]; or null
     * @property roughnessMap its green multiplies [roughness]; or null
     * @property normalMap changes the normals of the layer, which are those of the surface without its normal map
     * @throws IllegalArgumentException if a number is not in 0..1
     */
    public class Clearcoat @JvmOverloads constructor(
        public val strength: Float = 1f,
        public val roughness: Float = 0f,
        public val strengthMap: TextureMap? = null,
        public val roughnessMap: TextureMap? = null,
        public val normalMap: NormalMap? = null,
    ) : Lobe() {
        init {
            requireFraction("strength", strength)
            requireFraction("roughness", roughness)
        }

        override val properties: List<Any?> get() = listOf(strength, roughness, strengthMap, roughnessMap, normalMap)
    }

    /**
     * Coloured glass: `KHR_materials_transmission` and `KHR_materials_volume`, without refraction. What is behind is
     * shown as behind a translucent surface: less bright, by a factor between the least and the mean of red, green and
     * blue that pass. The colour of the glass comes from the light of the surroundings.
     *
     * @property strength the part of the light that is not reflected and passes, 0..1
     * @property strengthMap its red multiplies [strength]; or null
     * @property thickness length of the way through the glass, in units of the scene, 0 or more
     * @property thicknessMap its green multiplies [thickness]; or null
     * @property attenuationColor what is left of white light after [attenuationDistance]
     * @property attenuationDistance above 0; infinite for clear glass
     * @throws IllegalArgumentException if a number is out of range
     */
    public class Transmission @JvmOverloads constructor(
        public val strength: Float = 1f,
        public val strengthMap: TextureMap? = null,
        public val thickness: Float = 0f,
        public val thicknessMap: TextureMap? = null,
        public val attenuationColor: Rgba = Rgba.WHITE,
        public val attenuationDistance: Float = Float.POSITIVE_INFINITY,
    ) : Lobe() {
        init {
            requireFraction("strength", strength)
            require(thickness >= 0f && thickness.isFinite()) { "thickness must be 0 or more: $thickness" }
            require(attenuationDistance > 0f) { "attenuationDistance must be above 0: $attenuationDistance" }
        }

        override val properties: List<Any?>
            get() = listOf(
                strength, strengthMap, thickness, thicknessMap, attenuationColor, attenuationDistance,
            )
    }

    /**
     * A thin film, as on soap bubbles and beetles, below all other lobes: `KHR_materials_iridescence`.
     *
     * @property strength the part of the surface that has the film, 0..1
     * @property refraction the index of refraction of the film, at least 1
     * @property thickness thickness of the film in nanometres, 0 or more
     * @property leastThickness the thickness where [thicknessMap] is 0, in nanometres, 0 or more
     * @property strengthMap its red multiplies [strength]; or null
     * @property thicknessMap its green says how far the thickness is from [leastThickness] to [thickness]; or null
     * @throws IllegalArgumentException if a number is out of range
     */
    public class Iridescence @JvmOverloads constructor(
        public val strength: Float = 1f,
        public val refraction: Float = 1.3f,
        public val thickness: Float = 400f,
        public val leastThickness: Float = 100f,
        public val strengthMap: TextureMap? = null,
        public val thicknessMap: TextureMap? = null,
    ) : Lobe() {
        init {
            requireFraction("strength", strength)
            require(refraction >= 1f && refraction.isFinite()) { "refraction must be 1 or more: $refraction" }
            for (it in listOf(thickness, leastThickness)) {
                require(it >= 0f && it.isFinite()) { "a thickness must be 0 or more: $it" }
            }
        }

        override val properties: List<Any?>
            get() = listOf(strength, refraction, thickness, leastThickness, strengthMap, thicknessMap)
    }

    /**
     * Highlights that are longer along a direction of the surface, as on brushed metal: `KHR_materials_anisotropy`. It
     * has an effect on meshes with tangents only.
     *
     * @property strength 0 for round highlights, 1 for the longest ones
     * @property rotation the direction, in degrees from the tangent toward the bitangent
     * @property map its red and green are a direction, as in a normal map, that is rotated by [rotation]; its blue
     *   multiplies [strength]; or null
     * @throws IllegalArgumentException if a number is out of range
     */
    public class Anisotropy @JvmOverloads constructor(
        public val strength: Float = 1f,
        public val rotation: Float = 0f,
        public val map: TextureMap? = null,
    ) : Lobe() {
        init {
            requireFraction("strength", strength)
            require(rotation.isFinite()) { "rotation must be finite: $rotation" }
        }

        override val properties: List<Any?> get() = listOf(strength, rotation, map)
    }

    private companion object {
        fun requireFraction(name: String, value: Float) = require(value in 0f..1f) { "$name must be in 0..1: $value" }
    }
}
