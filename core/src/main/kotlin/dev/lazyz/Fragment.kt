package dev.lazyz

/**
 * One primitive at one sample, on its way to a colour.
 *
 * A renderer owns a fragment per thread and reuses it: [moveTo] a sample, [Primitive.shade], then read the colour. The
 * primitive fills in the attributes at the sample; the [Shader] reads them and calls [setColor]. Attributes that a
 * surface or its shading does not have keep the values given below. Not thread safe.
 */
public class Fragment {
    /** Column of the sample. */
    public var x: Int = 0
        private set

    /** Row of the sample. */
    public var y: Int = 0
        private set

    /**
     * Position in world space, relative to `Scene.origin`; or in screen space for primitives that were given there; 0
     * without.
     */
    @JvmField
    public var worldX: Float = 0f

    /** See [worldX]. */
    @JvmField
    public var worldY: Float = 0f

    /** See [worldX]. */
    @JvmField
    public var worldZ: Float = 0f

    /** Interpolated normal in world space, turned to the viewer, not renormalised; 0 without. */
    @JvmField
    public var normalX: Float = 0f

    /** See [normalX]. */
    @JvmField
    public var normalY: Float = 0f

    /** See [normalX]. */
    @JvmField
    public var normalZ: Float = 0f

    /** Texture coordinate to the right, see `Texture`; 0 without. */
    @JvmField
    public var u: Float = 0f

    /** Texture coordinate downward, see `Texture`; 0 without. */
    @JvmField
    public var v: Float = 0f

    /** Interpolated vertex colour, linear light; 1 without. */
    @JvmField
    public var vertexRed: Float = 1f

    /** See [vertexRed]. */
    @JvmField
    public var vertexGreen: Float = 1f

    /** See [vertexRed]. */
    @JvmField
    public var vertexBlue: Float = 1f

    /** Interpolated opacity, 0..1; 1 without. */
    @JvmField
    public var vertexAlpha: Float = 1f

    /** The shader's answer, linear light. */
    public var red: Float = 0f
        private set

    /** See [red]. */
    public var green: Float = 0f
        private set

    /** See [red]. */
    public var blue: Float = 0f
        private set

    /** The shader's answer: opacity, 0..1. */
    public var alpha: Float = 1f
        private set

    /** Room for a texture's answer, so that shading allocates nothing. */
    internal val texel: FloatArray = FloatArray(4)

    /** Room for the lights' answer. */
    internal val light: FloatArray = FloatArray(6)

    /** This fragment as a batch, for shaders that want one. */
    internal val alone: FragmentBatch by lazy(LazyThreadSafetyMode.NONE) { FragmentBatch(1) }

    /** Goes to a sample and forgets all attributes, so that nothing of another primitive can show through. */
    public fun moveTo(x: Int, y: Int) {
        this.x = x
        this.y = y
        worldX = 0f
        worldY = 0f
        worldZ = 0f
        normalX = 0f
        normalY = 0f
        normalZ = 0f
        u = 0f
        v = 0f
        vertexRed = 1f
        vertexGreen = 1f
        vertexBlue = 1f
        vertexAlpha = 1f
    }

    /** Sets the colour, linear light with straight alpha; [alpha] is 1 when it is left out. */
    @JvmOverloads
    public fun setColor(red: Float, green: Float, blue: Float, alpha: Float = 1f) {
        this.red = red
        this.green = green
        this.blue = blue
        this.alpha = alpha
    }

    /** Packs the colour to 8-bit sRGB, `0xAARRGGBB`. */
    public fun toArgb(): Int = Srgb.pack(red, green, blue, alpha)

    override fun toString(): String = "Fragment($x, $y, color=($red, $green, $blue, $alpha))"
}

/**
 * Gives a fragment its colour: a pure function of the fragment's sample and attributes.
 *
 * Called from any thread, any number of times for a sample, in any order; it must not keep the fragment, nor state of
 * its own that a result depends on. Use only arithmetic that is the same on every machine: `+ - * /` and `sqrt`, and
 * [StrictMath] for the rest; no `Math.sin`, `pow`, `fma` (contract rule 6.3).
 */
public fun interface Shader {
    /** Reads the attributes of [fragment] and calls [Fragment.setColor]. */
    public fun shade(fragment: Fragment)
}
