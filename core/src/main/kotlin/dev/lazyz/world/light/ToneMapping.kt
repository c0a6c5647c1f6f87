package dev.lazyz.world.light

/**
 * Exposure and tone mapping: converts the light of a surface to what the picture shows (contract rule 6.11). Applied to
 * the colours of built-in shading, before blending; not to the background and not to the colours of custom shaders.
 * Immutable and thread safe.
 *
 * @property curve the tone curve
 * @property exposure in stops (EV): light is first multiplied by 2 to this power; 0 keeps it, -20..20
 * @throws IllegalArgumentException if [exposure] is out of range
 */
public class ToneMapping @JvmOverloads constructor(
    public val curve: ToneMapping.Curve = ToneMapping.Curve.NONE,
    public val exposure: Double = 0.0,
) {
    init {
        require(exposure in -MAX_EXPOSURE..MAX_EXPOSURE) { "exposure must be in -20..20: $exposure" }
    }

    override fun equals(other: Any?): Boolean =
        other is ToneMapping && curve == other.curve && exposure.compareTo(other.exposure) == 0

    override fun hashCode(): Int = curve.hashCode() * 31 + exposure.hashCode()

    override fun toString(): String = "ToneMapping($curve, $exposure EV)"

    /** How light that exceeds what a screen can show is compressed. */
    public enum class Curve {
        /** No compression: components above 1 are clamped when the colour is packed. */
        NONE,

        /** A film-like curve for each component: dark colours become darker, bright ones approach white. */
        ACES,

        /** The Khronos PBR Neutral tone mapper: keeps colours, and compresses only what is almost white or brighter. */
        NEUTRAL,
    }

    public companion object {
        /** The largest [exposure]; its opposite is the smallest. */
        public const val MAX_EXPOSURE: Double = 20.0

        /** Colours stay as they are. */
        @JvmField
        public val NONE: ToneMapping = ToneMapping()
    }
}
