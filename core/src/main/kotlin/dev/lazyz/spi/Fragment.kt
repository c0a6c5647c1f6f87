package dev.lazyz.spi

/**
 * One primitive at one sample, with its attributes and, after shading, its colour.
 *
 * A renderer has one fragment per thread and reuses it: [moveTo] a sample, `Primitive.shade`, then read the colour. The
 * primitive sets the attributes at the sample; the [Shader] reads them and calls [setColor]. Attributes that the
 * surface does not have, or that its shading does not need, keep the default values given below. Not thread safe.
 */
public class Fragment {
    /** Column of the sample. */
    public var x: Int = 0
        private set

    /** Row of the sample. */
    public var y: Int = 0
        private set

    /**
     * Position in world space, relative to `Scene.origin`. Position in screen space (pixels) for primitives that were
     * defined there. Default 0.
     */
    @JvmField
    public var worldX: Float = 0f

    /** See [worldX]. */
    @JvmField
    public var worldY: Float = 0f

    /** See [worldX]. */
    @JvmField
    public var worldZ: Float = 0f

    /** Interpolated normal in world space, on the visible side of the face, not renormalised. Default 0. */
    @JvmField
    public var normalX: Float = 0f

    /** See [normalX]. */
    @JvmField
    public var normalY: Float = 0f

    /** See [normalX]. */
    @JvmField
    public var normalZ: Float = 0f

    /** Texture coordinate to the right, see `Texture`. Default 0. */
    @JvmField
    public var u: Float = 0f

    /** Texture coordinate downward, see `Texture`. Default 0. */
    @JvmField
    public var v: Float = 0f

    /** Texture coordinates of the second set, see [u] and [v]. Default 0. */
    @JvmField
    public var u2: Float = 0f

    /** See [u2]. */
    @JvmField
    public var v2: Float = 0f

    /**
     * How [u] changes from this sample to the next column, for filters of textures. Set if the material has a texture
     * with a `MipFilter`. If shading is once a pixel (`ShadingRate.PIXEL`), the step is to the next column of pixels,
     * and that of [dudy] to the next row of pixels. Default 0.
     */
    @JvmField
    public var dudx: Float = 0f

    /** How [v] changes from this sample to the next column, see [dudx]. */
    @JvmField
    public var dvdx: Float = 0f

    /** How [u] changes from this sample to the next row, see [dudx]. */
    @JvmField
    public var dudy: Float = 0f

    /** How [v] changes from this sample to the next row, see [dudx]. */
    @JvmField
    public var dvdy: Float = 0f

    /** As [dudx], for [u2]. */
    @JvmField
    public var du2dx: Float = 0f

    /** As [dvdx], for [v2]. */
    @JvmField
    public var dv2dx: Float = 0f

    /** As [dudy], for [u2]. */
    @JvmField
    public var du2dy: Float = 0f

    /** As [dvdy], for [v2]. */
    @JvmField
    public var dv2dy: Float = 0f

    /**
     * Interpolated tangent in world space, not renormalised: the direction in which [u] increases. Reversed together
     * with the normal. Default 0.
     */
    @JvmField
    public var tangentX: Float = 0f

    /** See [tangentX]. */
    @JvmField
    public var tangentY: Float = 0f

    /** See [tangentX]. */
    @JvmField
    public var tangentZ: Float = 0f

    /** Sign of the bitangent: cross(normal, tangent) times this. Reversed together with the normal. Default 0. */
    @JvmField
    public var tangentW: Float = 0f

    /** Interpolated vertex colour, linear light. Default 1. */
    @JvmField
    public var vertexRed: Float = 1f

    /** See [vertexRed]. */
    @JvmField
    public var vertexGreen: Float = 1f

    /** See [vertexRed]. */
    @JvmField
    public var vertexBlue: Float = 1f

    /** Interpolated vertex opacity, 0..1. Default 1. */
    @JvmField
    public var vertexAlpha: Float = 1f

    /** The colour set by the shader, linear light. Default 0. */
    public var red: Float = 0f
        private set

    /** See [red]. */
    public var green: Float = 0f
        private set

    /** See [red]. */
    public var blue: Float = 0f
        private set

    /** The opacity set by the shader, 0..1. Default 1. */
    public var alpha: Float = 1f
        private set

    /** How many samples wide and high a step of the derivatives is: 1, or a pixel (contract rule 6.12). */
    internal var footprintSide: Int = 1

    /** How far the place of the attributes is right of the sample, in grid units of 1/256 (contract rule 6.12). */
    internal var gridRight: Int = 0

    /** How far it is below the sample, see [gridRight]. */
    internal var gridDown: Int = 0

    /**
     * Scratch array for the result of a texture lookup (red, green, blue, alpha), so that shading does not allocate.
     */
    internal val texel: FloatArray = FloatArray(4)

    /** Scratch array for the light at a sample. */
    internal val light: FloatArray = FloatArray(6)

    /** Scratch array for a physically based material at a sample. */
    internal val surface: FloatArray = FloatArray(37)

    /** A batch of one fragment, for a [BatchShader] that is called with this fragment. */
    internal val singleBatch: FragmentBatch by lazy(LazyThreadSafetyMode.NONE) { FragmentBatch(1) }

    /**
     * Moves to column [x], row [y], and resets all attributes and the colour to their defaults, so that no value of
     * another primitive or sample remains.
     */
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
        u2 = 0f
        v2 = 0f
        dudx = 0f
        dvdx = 0f
        dudy = 0f
        dvdy = 0f
        du2dx = 0f
        dv2dx = 0f
        du2dy = 0f
        dv2dy = 0f
        tangentX = 0f
        tangentY = 0f
        tangentZ = 0f
        tangentW = 0f
        vertexRed = 1f
        vertexGreen = 1f
        vertexBlue = 1f
        vertexAlpha = 1f
        setColor(0f, 0f, 0f)
    }

    /** Sets the colour in linear light with straight alpha. [alpha] defaults to 1. */
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
 * Computes the colour of a fragment: a pure function of the fragment's sample and attributes.
 *
 * A shader can be called from any thread, any number of times for a sample, in any order. It must not keep a reference
 * to the fragment, and its result must not depend on mutable state. Use only arithmetic that gives the same result on
 * every machine: `+ - * /`, `sqrt`, and [StrictMath] for the rest; no `Math.sin`, `pow`, `fma` (contract rule 6.3).
 */
public fun interface Shader {
    /** Reads the attributes of [fragment] and calls [Fragment.setColor]. Without a call, the colour is opaque black. */
    public fun shade(fragment: Fragment)
}

/**
 * A [Shader] that colours many fragments per call, in loops that the JVM can vectorise. It is faster than a plain
 * shader if the computation is long, and as fast otherwise. Keep loops short, with few arrays in each: compilers do not
 * vectorise long loops.
 *
 * The colour of a fragment must depend only on the attributes of that fragment, not on its index in the batch or on
 * other fragments. Each renderer fills batches differently, and some shade fragments one by one. Must be thread safe,
 * like all shaders. Use only the arithmetic of contract rule 6.3.
 *
 * ```
 * val stripes = BatchShader { batch ->
 *     for (i in 0 until batch.size) {
 *         batch.red[i] = batch.u[i] * batch.vertexRed[i]
 *         batch.green[i] = batch.v[i]
 *         batch.blue[i] = 0.5f
 *     }
 * }
 * ```
 */
public fun interface BatchShader : Shader {
    /**
     * Reads the attributes of the first [FragmentBatch.size] elements of [batch], and writes their colours. It must not
     * write to other arrays. A colour that is not written is opaque black.
     */
    public fun shade(batch: FragmentBatch)

    /** Shades one fragment, as a batch of one. */
    override fun shade(fragment: Fragment) {
        fragment.singleBatch.shade(fragment, this)
    }
}

/** The attributes that a shader can read, as bit flags. */
internal object Attributes {
    /** Position in world space: x, y, z. */
    const val WORLD: Int = 1

    /** Normal: x, y, z. */
    const val NORMAL: Int = 2

    /** Texture coordinates: u, v. */
    const val UV: Int = 4

    /** Vertex colour: red, green, blue, alpha. */
    const val COLOR: Int = 8

    /** Texture coordinates of the second set: u2, v2. */
    const val UV2: Int = 16

    /** Tangent: x, y, z and handedness. */
    const val TANGENT: Int = 32

    /** Derivatives of the texture coordinates that the fragment has, see [Fragment.dudx]. */
    const val FOOTPRINT: Int = 64

    /** All of them. */
    const val ALL: Int = WORLD or NORMAL or UV or COLOR or UV2 or TANGENT or FOOTPRINT
}
