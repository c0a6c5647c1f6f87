package dev.lazyz.spi

/**
 * Many fragments, as one array for each attribute of [Fragment]. Elements 0 until [size] are valid. A [BatchShader]
 * reads the attributes and writes the colours.
 *
 * A batch has at most [CAPACITY] fragments. They have one material, and can be at any samples and of any primitives of
 * the image. Attributes that a surface does not have are 0, or 1 for vertex colours. Renderers create their own
 * batches; call [of] to test a shader. Not thread safe.
 */
public class FragmentBatch internal constructor(capacity: Int) {
    /** Number of fragments, 1 to [CAPACITY]. */
    public var size: Int = 0
        internal set

    /** Columns of the samples. */
    @JvmField
    public val x: IntArray = IntArray(capacity)

    /** Rows of the samples. */
    @JvmField
    public val y: IntArray = IntArray(capacity)

    /**
     * Positions in world space, relative to `Scene.origin`; positions in screen space (pixels) for primitives that were
     * defined there.
     */
    @JvmField
    public val worldX: FloatArray = FloatArray(capacity)

    /** See [worldX]. */
    @JvmField
    public val worldY: FloatArray = FloatArray(capacity)

    /** See [worldX]. */
    @JvmField
    public val worldZ: FloatArray = FloatArray(capacity)

    /** Interpolated normals in world space, on the visible side of the face, not renormalised. */
    @JvmField
    public val normalX: FloatArray = FloatArray(capacity)

    /** See [normalX]. */
    @JvmField
    public val normalY: FloatArray = FloatArray(capacity)

    /** See [normalX]. */
    @JvmField
    public val normalZ: FloatArray = FloatArray(capacity)

    /** Texture coordinates to the right, see `Texture`. */
    @JvmField
    public val u: FloatArray = FloatArray(capacity)

    /** Texture coordinates downward, see `Texture`. */
    @JvmField
    public val v: FloatArray = FloatArray(capacity)

    /** Texture coordinates of the second set; see [Fragment.u2]. */
    @JvmField
    public val u2: FloatArray = FloatArray(capacity)

    /** See [u2]. */
    @JvmField
    public val v2: FloatArray = FloatArray(capacity)

    /** Derivatives of [u] by columns; see [Fragment.dudx]. */
    @JvmField
    public val dudx: FloatArray = FloatArray(capacity)

    /** Derivatives of [v] by columns. */
    @JvmField
    public val dvdx: FloatArray = FloatArray(capacity)

    /** Derivatives of [u] by rows. */
    @JvmField
    public val dudy: FloatArray = FloatArray(capacity)

    /** Derivatives of [v] by rows. */
    @JvmField
    public val dvdy: FloatArray = FloatArray(capacity)

    /** Derivatives of [u2] by columns. */
    @JvmField
    public val du2dx: FloatArray = FloatArray(capacity)

    /** Derivatives of [v2] by columns. */
    @JvmField
    public val dv2dx: FloatArray = FloatArray(capacity)

    /** Derivatives of [u2] by rows. */
    @JvmField
    public val du2dy: FloatArray = FloatArray(capacity)

    /** Derivatives of [v2] by rows. */
    @JvmField
    public val dv2dy: FloatArray = FloatArray(capacity)

    /** Interpolated tangents in world space; see [Fragment.tangentX]. */
    @JvmField
    public val tangentX: FloatArray = FloatArray(capacity)

    /** See [tangentX]. */
    @JvmField
    public val tangentY: FloatArray = FloatArray(capacity)

    /** See [tangentX]. */
    @JvmField
    public val tangentZ: FloatArray = FloatArray(capacity)

    /** Signs of the bitangents; see [Fragment.tangentW]. */
    @JvmField
    public val tangentW: FloatArray = FloatArray(capacity)

    /** Interpolated vertex colours, linear light. */
    @JvmField
    public val vertexRed: FloatArray = FloatArray(capacity)

    /** See [vertexRed]. */
    @JvmField
    public val vertexGreen: FloatArray = FloatArray(capacity)

    /** See [vertexRed]. */
    @JvmField
    public val vertexBlue: FloatArray = FloatArray(capacity)

    /** Interpolated vertex opacity, 0..1. */
    @JvmField
    public val vertexAlpha: FloatArray = FloatArray(capacity)

    /** The colour set by the shader, linear light. It is 0 unless the shader sets it. */
    @JvmField
    public val red: FloatArray = FloatArray(capacity)

    /** See [red]. */
    @JvmField
    public val green: FloatArray = FloatArray(capacity)

    /** See [red]. */
    @JvmField
    public val blue: FloatArray = FloatArray(capacity)

    /** The opacity set by the shader, 0..1. It is 1 unless the shader sets it. */
    @JvmField
    public val alpha: FloatArray = FloatArray(capacity)

    private val each = Fragment()
    private var scratch = emptyArray<FloatArray>()

    /**
     * Bits of the attributes that the fragments have, see [begin]; all other attributes have their default. Initially
     * COLOR, because the arrays of a new batch contain 0, which is not the default of a vertex colour.
     */
    internal var fields: Int = Attributes.COLOR
        private set

    /** Bytes of the arrays. */
    internal val bytes: Long get() = (32L + scratch.size) * Int.SIZE_BYTES * x.size

    /** Scratch memory of 4 numbers for a shader while it runs. */
    internal val texel: FloatArray get() = each.texel

    /** Scratch memory for a physically based material. */
    internal val surface: FloatArray get() = each.surface

    /** Returns [count] arrays as long as those of the attributes, with any contents, for a shader while it runs. */
    internal fun scratch(count: Int): Array<FloatArray> {
        if (scratch.size < count) scratch = Array(count) { FloatArray(x.size) }
        return scratch
    }

    /** Starts a batch whose fragments have the attributes [fields], a combination of the bits in [Attributes]. */
    internal fun begin(fields: Int) {
        size = 0
        val stale = this.fields and fields.inv()
        val staleFootprints = footprints(this.fields) and footprints(fields).inv()
        this.fields = fields
        if (stale and Attributes.WORLD != 0) for (array in listOf(worldX, worldY, worldZ)) array.fill(0f)
        if (stale and Attributes.NORMAL != 0) for (array in listOf(normalX, normalY, normalZ)) array.fill(0f)
        if (stale and Attributes.UV != 0) for (array in listOf(u, v)) array.fill(0f)
        if (stale and Attributes.UV2 != 0) for (array in listOf(u2, v2)) array.fill(0f)
        if (stale and Attributes.TANGENT != 0) {
            for (array in listOf(tangentX, tangentY, tangentZ, tangentW)) array.fill(0f)
        }
        if (staleFootprints and Attributes.UV != 0) for (array in listOf(dudx, dvdx, dudy, dvdy)) array.fill(0f)
        if (staleFootprints and Attributes.UV2 != 0) for (array in listOf(du2dx, dv2dx, du2dy, dv2dy)) array.fill(0f)
        if (stale and Attributes.COLOR != 0) {
            for (array in listOf(vertexRed, vertexGreen, vertexBlue, vertexAlpha)) array.fill(1f)
        }
    }

    /** Returns the sets of texture coordinates whose derivatives are written: of those that the fragments have. */
    private fun footprints(fields: Int): Int =
        if (fields and Attributes.FOOTPRINT == 0) 0 else fields and (Attributes.UV or Attributes.UV2)

    /** Assigns the samples of row [y] from column [x] on to the elements from [at] on, [count] of them. */
    internal fun place(at: Int, x: Int, y: Int, count: Int) {
        for (i in 0 until count) {
            this.x[at + i] = x + i
            this.y[at + i] = y
        }
    }

    /** Shades the fragments. Those whose colour [shader] does not set are opaque black. */
    internal fun shade(shader: Shader) {
        if (shader !is BatchShader) return shadeEach(shader)
        red.fill(0f, 0, size)
        green.fill(0f, 0, size)
        blue.fill(0f, 0, size)
        alpha.fill(1f, 0, size)
        shader.shade(this)
    }

    /** Calls [shader] for each fragment. */
    internal fun shadeEach(shader: Shader) {
        val fragment = each
        for (i in 0 until size) {
            moveTo(fragment, i)
            shader.shade(fragment)
            red[i] = fragment.red
            green[i] = fragment.green
            blue[i] = fragment.blue
            alpha[i] = fragment.alpha
        }
    }

    /** Copies sample and attributes of element [i] to [fragment]. */
    internal fun moveTo(fragment: Fragment, i: Int) {
        fragment.moveTo(x[i], y[i])
        fragment.worldX = worldX[i]
        fragment.worldY = worldY[i]
        fragment.worldZ = worldZ[i]
        fragment.normalX = normalX[i]
        fragment.normalY = normalY[i]
        fragment.normalZ = normalZ[i]
        fragment.u = u[i]
        fragment.v = v[i]
        fragment.vertexRed = vertexRed[i]
        fragment.vertexGreen = vertexGreen[i]
        fragment.vertexBlue = vertexBlue[i]
        fragment.vertexAlpha = vertexAlpha[i]
        if (fields and SELDOM != 0) moveSeldom(fragment, i)
    }

    private fun moveSeldom(fragment: Fragment, i: Int) {
        fragment.u2 = u2[i]
        fragment.v2 = v2[i]
        fragment.dudx = dudx[i]
        fragment.dvdx = dvdx[i]
        fragment.dudy = dudy[i]
        fragment.dvdy = dvdy[i]
        fragment.du2dx = du2dx[i]
        fragment.dv2dx = dv2dx[i]
        fragment.du2dy = du2dy[i]
        fragment.dv2dy = dv2dy[i]
        fragment.tangentX = tangentX[i]
        fragment.tangentY = tangentY[i]
        fragment.tangentZ = tangentZ[i]
        fragment.tangentW = tangentW[i]
    }

    /** Shades the single [fragment] as a batch of size 1, and copies the colour back to it. */
    internal fun shade(fragment: Fragment, shader: BatchShader) {
        size = 0
        add(fragment)
        shade(shader)
        fragment.setColor(red[0], green[0], blue[0], alpha[0])
    }

    /** Appends [fragment], with all of its attributes. */
    internal fun add(fragment: Fragment) {
        val i = size++
        x[i] = fragment.x
        y[i] = fragment.y
        worldX[i] = fragment.worldX
        worldY[i] = fragment.worldY
        worldZ[i] = fragment.worldZ
        normalX[i] = fragment.normalX
        normalY[i] = fragment.normalY
        normalZ[i] = fragment.normalZ
        u[i] = fragment.u
        v[i] = fragment.v
        vertexRed[i] = fragment.vertexRed
        vertexGreen[i] = fragment.vertexGreen
        vertexBlue[i] = fragment.vertexBlue
        vertexAlpha[i] = fragment.vertexAlpha
        u2[i] = fragment.u2
        v2[i] = fragment.v2
        dudx[i] = fragment.dudx
        dvdx[i] = fragment.dvdx
        dudy[i] = fragment.dudy
        dvdy[i] = fragment.dvdy
        du2dx[i] = fragment.du2dx
        dv2dx[i] = fragment.dv2dx
        du2dy[i] = fragment.du2dy
        dv2dy[i] = fragment.dv2dy
        tangentX[i] = fragment.tangentX
        tangentY[i] = fragment.tangentY
        tangentZ[i] = fragment.tangentZ
        tangentW[i] = fragment.tangentW
    }

    /** Returns the packed colour of element [i], `0xAARRGGBB`. */
    internal fun toArgb(i: Int): Int = Srgb.pack(red[i], green[i], blue[i], alpha[i])

    override fun toString(): String = "FragmentBatch($size fragments)"

    public companion object {
        /** Maximum number of fragments in a batch. */
        public const val CAPACITY: Int = 256

        /**
         * Returns a batch of [size] fragments to call a [BatchShader] with, for example in a test. All samples are (0,
         * 0). Attributes have their defaults (positions, normals and texture coordinates 0, vertex colours 1) until the
         * caller writes to the arrays. Colours are black with alpha 1 until the shader sets them.
         *
         * ```
         * val batch = FragmentBatch.of(3)
         * for (i in 0 until batch.size) batch.u[i] = i / 2f
         * stripes.shade(batch)
         * check(batch.red[2] == 1f)
         * ```
         *
         * @throws IllegalArgumentException if [size] is not in 1..[CAPACITY]
         */
        @JvmStatic
        public fun of(size: Int): FragmentBatch {
            require(size in 1..CAPACITY) { "size must be in 1..$CAPACITY: $size" }
            val batch = FragmentBatch(CAPACITY)
            batch.begin(0)
            batch.fields = SELDOM
            batch.size = size
            batch.alpha.fill(1f)
            return batch
        }

        /**
         * Unused elements after the last fragment of a full batch: the maximum number of lanes of a vector, minus one.
         */
        internal const val SPARE: Int = 64 - 1

        /** Attributes that few materials use. */
        private const val SELDOM = Attributes.UV2 or Attributes.TANGENT or Attributes.FOOTPRINT

        /** Length of an array that is written in whole vectors. */
        internal const val ROOM: Int = CAPACITY + SPARE
    }
}
