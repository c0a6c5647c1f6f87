package dev.lazyz

/** What a frame knows about the scene that it was set up from. Immutable and thread safe. */
internal interface FrameView {
    /** [distance] at the near plane. */
    val near: Double

    /** [distance] at the far plane. */
    val far: Double

    /** The point, in world space, that [Fragment.worldX], [Fragment.worldY] and [Fragment.worldZ] are relative to. */
    val originX: Double
    val originY: Double
    val originZ: Double

    /**
     * Returns the distance from the eye along the line of sight, world units, of what is at the fraction [unit] of the
     * range of depths: 0 at the near plane, 1 at the far plane.
     */
    fun distance(unit: Double): Double

    /**
     * Returns the distance from the eye along the line of sight, world units, of a position as [Fragment] has it,
     * relative to [originX], [originY] and [originZ]. NaN if the frame was not set up from a scene.
     */
    fun distance(x: Float, y: Float, z: Float): Double

    /** Returns the number of the surface, in the order of the scene, whose primitive has the submission [index]. */
    fun objectOf(index: Int): Int

    /** The names of the surfaces, in the order of the scene; empty if the frame was not set up from one. */
    val objectNames: List<String>
}

/** The view of a frame that was not set up from a scene: distances are fractions, and all primitives are one object. */
internal object NoView : FrameView {
    override val near: Double get() = 0.0
    override val far: Double get() = 1.0
    override val originX: Double get() = 0.0
    override val originY: Double get() = 0.0
    override val originZ: Double get() = 0.0

    override fun distance(unit: Double): Double = unit

    override fun distance(x: Float, y: Float, z: Float): Double = Double.NaN

    override fun objectOf(index: Int): Int = 0

    override val objectNames: List<String> get() = emptyList()
}
