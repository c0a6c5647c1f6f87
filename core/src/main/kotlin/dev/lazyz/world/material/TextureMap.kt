package dev.lazyz.world.material

/**
 * A texture and how it is laid on a surface. Immutable and thread safe.
 *
 * @property texture the image
 * @property uvSet which texture coordinates of the surface are used: 0 for the first set, 1 for the second. A surface
 *   without that set is treated as if it had the coordinates (0, 0) everywhere
 * @property transform applied to the coordinates at each sample
 * @throws IllegalArgumentException if [uvSet] is neither 0 nor 1
 */
public class TextureMap @JvmOverloads constructor(
    public val texture: Texture,
    public val uvSet: Int = 0,
    public val transform: UvTransform = UvTransform.IDENTITY,
) {
    init {
        require(uvSet in 0..1) { "uvSet must be 0 or 1: $uvSet" }
    }

    /** Returns this map with another [texture]. */
    public fun withTexture(texture: Texture): TextureMap = TextureMap(texture, uvSet, transform)

    override fun equals(other: Any?): Boolean =
        other is TextureMap && texture === other.texture && uvSet == other.uvSet && transform == other.transform

    override fun hashCode(): Int = (System.identityHashCode(texture) * 31 + uvSet) * 31 + transform.hashCode()

    override fun toString(): String = "TextureMap($texture, uvSet=$uvSet, $transform)"

    /**
     * A transform of texture coordinates: scale, then rotation, then offset, as in the glTF extension
     * `KHR_texture_transform`. Immutable and thread safe.
     *
     * The result is computed in single precision from the coordinates in single precision, with a matrix that is
     * computed once in double precision with [StrictMath].
     *
     * @property scaleU factor of u
     * @property scaleV factor of v
     * @property rotation degrees, by which the coordinates turn around the upper left corner of the image, from v
     *   toward u
     * @property offsetU added to u at the end
     * @property offsetV added to v at the end
     * @throws IllegalArgumentException if a number is not finite
     */
    public class UvTransform @JvmOverloads constructor(
        public val scaleU: Double = 1.0,
        public val scaleV: Double = 1.0,
        public val rotation: Double = 0.0,
        public val offsetU: Double = 0.0,
        public val offsetV: Double = 0.0,
    ) {
        init {
            require(listOf(scaleU, scaleV, rotation, offsetU, offsetV).all { it.isFinite() }) {
                "a transform of texture coordinates must be finite: $this"
            }
        }

        /** Whether coordinates stay as they are. */
        public val isIdentity: Boolean =
            scaleU == 1.0 && scaleV == 1.0 && rotation == 0.0 && offsetU == 0.0 && offsetV == 0.0

        // The matrix: u' = uu u + uv v + offsetU, v' = vu u + vv v + offsetV
        private val sine = StrictMath.sin(rotation * (StrictMath.PI / 180.0))
        private val cosine = StrictMath.cos(rotation * (StrictMath.PI / 180.0))
        internal val uu: Float = (cosine * scaleU).toFloat()
        internal val uv: Float = (sine * scaleV).toFloat()
        internal val vu: Float = (-sine * scaleU).toFloat()
        internal val vv: Float = (cosine * scaleV).toFloat()
        private val u0 = offsetU.toFloat()
        private val v0 = offsetV.toFloat()

        /** Returns the transformed u of the point ([u], [v]). */
        public fun u(u: Float, v: Float): Float = uu * u + uv * v + u0

        /** Returns the transformed v of the point ([u], [v]). */
        public fun v(u: Float, v: Float): Float = vu * u + vv * v + v0

        override fun equals(other: Any?): Boolean = other is UvTransform && numbers() == other.numbers()

        override fun hashCode(): Int = numbers().hashCode()

        private fun numbers() = listOf(scaleU, scaleV, rotation, offsetU, offsetV)

        override fun toString(): String =
            "UvTransform(scale ($scaleU, $scaleV), rotation $rotation, offset ($offsetU, $offsetV))"

        public companion object {
            /** Leaves coordinates as they are. */
            @JvmField
            public val IDENTITY: UvTransform = UvTransform()
        }
    }
}
