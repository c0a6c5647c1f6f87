package dev.lazyz

/**
 * Fragments on their way to a colour, many at a time: each attribute of [Fragment] as an array, of which the first [size]
 * elements count. What a [BatchShader] reads and fills in.
 *
 * A batch has room for [CAPACITY] fragments, of one material, from anywhere in the picture and from any of its primitives.
 * Attributes that a surface does not have are 0, or 1 for vertex colours. Renderers make their own batches; make one with
 * [of] to try a shader on its own. Not thread safe.
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

    /** Positions in world space, or in screen space for primitives that were given there. */
    @JvmField
    public val worldX: FloatArray = FloatArray(capacity)

    /** See [worldX]. */
    @JvmField
    public val worldY: FloatArray = FloatArray(capacity)

    /** See [worldX]. */
    @JvmField
    public val worldZ: FloatArray = FloatArray(capacity)

    /** Interpolated normals in world space, turned to the viewer, not renormalised. */
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

    /** Interpolated vertex colours, linear light. */
    @JvmField
    public val vertexRed: FloatArray = FloatArray(capacity)

    /** See [vertexRed]. */
    @JvmField
    public val vertexGreen: FloatArray = FloatArray(capacity)

    /** See [vertexRed]. */
    @JvmField
    public val vertexBlue: FloatArray = FloatArray(capacity)

    /** Interpolated opacity, 0..1. */
    @JvmField
    public val vertexAlpha: FloatArray = FloatArray(capacity)

    /** The shader's answer, linear light. */
    @JvmField
    public val red: FloatArray = FloatArray(capacity)

    /** See [red]. */
    @JvmField
    public val green: FloatArray = FloatArray(capacity)

    /** See [red]. */
    @JvmField
    public val blue: FloatArray = FloatArray(capacity)

    /** The shader's answer: opacity, 0..1. It is 1 unless the shader sets it. */
    @JvmField
    public val alpha: FloatArray = FloatArray(capacity)

    private val each = Fragment()

    /** The attributes that the fragments have, see [begin]; the others hold what stands for none. At first colours are 0. */
    internal var fields: Int = Attributes.COLOR
        private set

    /** Bytes held. */
    internal val bytes: Long get() = 18L * Int.SIZE_BYTES * x.size

    /** Begins a batch whose fragments have the attributes [fields], bits [Attributes.WORLD] and so on. */
    internal fun begin(fields: Int) {
        size = 0
        val stale = this.fields and fields.inv()
        this.fields = fields
        if (stale and Attributes.WORLD != 0) for (array in listOf(worldX, worldY, worldZ)) array.fill(0f)
        if (stale and Attributes.NORMAL != 0) for (array in listOf(normalX, normalY, normalZ)) array.fill(0f)
        if (stale and Attributes.UV != 0) for (array in listOf(u, v)) array.fill(0f)
        if (stale and Attributes.COLOR != 0) {
            for (array in listOf(vertexRed, vertexGreen, vertexBlue, vertexAlpha)) array.fill(1f)
        }
    }

    /** Notes that the samples from column [x] on of row [y] are those from place [at] on. */
    internal fun place(at: Int, x: Int, y: Int, count: Int) {
        for (i in 0 until count) {
            this.x[at + i] = x + i
            this.y[at + i] = y
        }
    }

    /** Shades all fragments one after the other. */
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

    /** Makes [fragment] number [i]. */
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
    }

    /** Makes this a batch of the one [fragment], shades it, and leaves the answer there. */
    internal fun shade(fragment: Fragment, shader: BatchShader) {
        size = 1
        x[0] = fragment.x
        y[0] = fragment.y
        worldX[0] = fragment.worldX
        worldY[0] = fragment.worldY
        worldZ[0] = fragment.worldZ
        normalX[0] = fragment.normalX
        normalY[0] = fragment.normalY
        normalZ[0] = fragment.normalZ
        u[0] = fragment.u
        v[0] = fragment.v
        vertexRed[0] = fragment.vertexRed
        vertexGreen[0] = fragment.vertexGreen
        vertexBlue[0] = fragment.vertexBlue
        vertexAlpha[0] = fragment.vertexAlpha
        alpha[0] = 1f
        shader.shade(this)
        fragment.setColor(red[0], green[0], blue[0], alpha[0])
    }

    override fun toString(): String = "FragmentBatch($size fragments)"

    public companion object {
        /** Most fragments in a batch. */
        public const val CAPACITY: Int = 256

        /**
         * Returns a batch of [size] fragments to call a [BatchShader] with, in a test of it, say. They are at sample (0, 0) and
         * have no attributes but for what the caller writes into the arrays: positions, normals and texture coordinates are
         * 0, vertex colours 1. The answer is black with alpha 1 until the shader gives another.
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
            batch.size = size
            batch.alpha.fill(1f)
            return batch
        }

        /** Places behind the last fragment of a full batch: the most lanes that a vector has, less one. */
        internal const val SPARE: Int = 64 - 1

        /** Places that an array needs which is written vector by vector. */
        internal const val ROOM: Int = CAPACITY + SPARE
    }
}

/**
 * A [Shader] that colours many fragments at a time, in loops that the JVM can vectorise. Faster than a plain shader where
 * there is much to compute, and equal to it otherwise. Keep loops short, with few arrays each: compilers give up vectorising
 * long ones.
 *
 * What is computed for a fragment must depend on that fragment's attributes only, not on its place in the batch or on its
 * neighbours there: batches are put together differently by every renderer, and some shade fragments one by one. Thread
 * safe, like all shaders. Arithmetic as contract rule 6.3 has it.
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
    /** Reads the attributes of the first [FragmentBatch.size] fragments of [batch], and fills in their colours. */
    public fun shade(batch: FragmentBatch)

    /** Shades one fragment, as a batch of one. */
    override fun shade(fragment: Fragment) {
        fragment.alone.shade(fragment, this)
    }
}
