package dev.lazyz

import dev.lazyz.spi.Fragment

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

    /** Returns the submission index of the first primitive of surface [number]. */
    fun firstOf(number: Int): Int

    /** The names of the surfaces, in the order of the scene; empty if the frame was not set up from one. */
    val objectNames: List<String>
}

/**
 * Returns the distance from the eye of the sample of [fragment], at which [primitive] is at the fraction [unit] of the
 * range of depths. Where the depth test uses a constant, it is that of the position, if there is one: the primitive may
 * be a sliver seen edge-on, whose true depth is not constant (contract rule 3.4).
 */
internal fun FrameView.distance(unit: Double, primitive: Primitive, fragment: Fragment): Double {
    val form = primitive.depthForm
    if (form == null || form.dx != 0L || form.dy != 0L) return distance(unit)
    fragment.worldX = Float.NaN
    primitive.geometry(fragment)
    val ofPosition = distance(fragment.worldX, fragment.worldY, fragment.worldZ)
    return if (ofPosition.isNaN()) distance(unit) else ofPosition
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

    override fun firstOf(number: Int): Int = 0

    override val objectNames: List<String> get() = emptyList()
}
