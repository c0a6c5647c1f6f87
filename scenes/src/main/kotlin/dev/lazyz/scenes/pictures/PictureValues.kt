package dev.lazyz.scenes.pictures

import dev.lazyz.Rgba
import dev.lazyz.filter.VerticalGradient
import dev.lazyz.sections.SectionPlane
import dev.lazyz.world.Scene
import org.joml.Vector3d

/**
 * What is behind the surfaces: one colour, or two, the upper and the lower end of a gradient. Immutable.
 *
 * @property color the background of the frame; transparent if there is a gradient
 * @property gradient the gradient, or null
 */
public class Backdrop private constructor(public val color: Rgba, public val gradient: VerticalGradient?) {
    public constructor(color: Rgba) : this(color, null)

    public constructor(gradient: VerticalGradient) : this(Rgba.TRANSPARENT, gradient)

    override fun toString(): String = "Backdrop(${gradient ?: color})"
}

/** Which camera shows a file. Immutable. */
public class CameraChoice private constructor(private val text: String, internal val number: Int) {
    override fun toString(): String = text

    public companion object {
        /** A camera that shows all of the scene. */
        @JvmField
        public val FIT: CameraChoice = CameraChoice("fit", -1)

        /** The own camera of the scene, or one that shows all of it if it has none. */
        @JvmField
        public val SCENE: CameraChoice = CameraChoice("scene", -1)

        /**
         * Returns the choice of the camera with this number in a model, from 0.
         *
         * @throws IllegalArgumentException if [number] is negative
         */
        @JvmStatic
        public fun ofModel(number: Int): CameraChoice {
            require(number >= 0) { "number must be 0 or more: $number" }
            return CameraChoice("$number", number)
        }
    }
}

/**
 * A plane that cuts a scene: what is beyond it is removed. In the axes of the model. Immutable.
 *
 * @property text the plane as [parse] reads it
 */
public class CutPlane private constructor(public val text: String, private val place: (Scene) -> SectionPlane) {
    /** Returns the plane in [scene], which percentages refer to. */
    public fun plane(scene: Scene): SectionPlane = place(scene)

    override fun toString(): String = text

    public companion object {
        private val axes = listOf("x", "y", "z")

        /**
         * Returns the plane that [text] describes: `x=0.5`, `y=50%` (of the bounds), `-z=10%` (what is before it is
         * removed), or `a,b,c,d` (where ax + by + cz > d is removed); or null if it describes none.
         */
        @JvmStatic
        public fun parse(text: String): CutPlane? = if ('=' in text) axis(text) else general(text)

        private fun axis(text: String): CutPlane? {
            val name = text.substringBefore('=').lowercase()
            val axis = axes.indexOf(if (name.startsWith('+') || name.startsWith('-')) name.drop(1) else name)
            val place = text.substringAfter('=')
            val number = decimal(place.removeSuffix("%"))
            if (axis < 0 || number == null) return null
            val isReversed = name.startsWith('-')
            return CutPlane(text) { scene ->
                val at = if (place.endsWith('%')) fraction(scene, axis, number / 100) else number
                val plane = SectionPlane(Vector3d().setComponent(axis, 1.0), at)
                if (isReversed) plane.reversed() else plane
            }
        }

        private fun fraction(scene: Scene, axis: Int, part: Double): Double {
            val box = scene.bounds ?: return 0.0
            val low = box.corner(0).get(axis)
            val high = box.corner(7).get(axis)

            // The ends exactly, so that 0% and 100% are along faces
            return if (part == 1.0) high else low + part * (high - low)
        }

        private fun general(text: String): CutPlane? {
            val numbers = text.split(',').map { decimal(it) ?: return null }
            if (numbers.size != 4) return null
            val (a, b, c, d) = numbers
            val square = a * a + b * b + c * c
            if (!(square > 0.0 && square.isFinite() && d.isFinite())) return null
            val length = StrictMath.sqrt(square)
            return CutPlane(text) { SectionPlane(Vector3d(a, b, c), d / length) }
        }
    }
}

/** Returns the decimal number that [text] is, such as `-2.5` or `.5e3`, or null: other forms do not count. */
internal fun decimal(text: String): Double? =
    if (text.all { it in "0123456789.+-eE" }) text.toDoubleOrNull() else null
