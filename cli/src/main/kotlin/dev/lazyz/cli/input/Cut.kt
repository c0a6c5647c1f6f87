package dev.lazyz.cli.input

import dev.lazyz.sections.SectionPlane
import dev.lazyz.world.Scene
import org.joml.Vector3d

/** A plane from the command line, whose [text] is `x=0.5`, `-z=10%` or `a,b,c,d`. */
internal sealed class Cut(private val text: String) {
    /** Returns the plane for [scene]. */
    abstract fun plane(scene: Scene): SectionPlane

    override fun toString(): String = text

    /** A plane across an axis (0..2); [sign] is 1 to remove what is beyond it, and -1 to remove what is before it. */
    class Axis(
        text: String,
        private val axis: Int,
        private val sign: Int,
        private val place: Double,
        private val isPercent: Boolean,
    ) : Cut(text) {
        override fun plane(scene: Scene): SectionPlane {
            val at = if (isPercent) fraction(scene, place / 100) else place
            val normal = Vector3d().setComponent(axis, 1.0)
            return if (sign > 0) SectionPlane(normal, at) else SectionPlane(normal, at).reversed()
        }

        private fun fraction(scene: Scene, part: Double): Double {
            val box = scene.bounds ?: return 0.0
            val low = box.corner(0).get(axis)
            val high = box.corner(7).get(axis)

            // The ends exactly, so that 0% and 100% are along faces
            return if (part == 1.0) high else low + part * (high - low)
        }
    }

    /** A plane given by its normal and its distance. */
    class General(
        text: String,
        private val a: Double,
        private val b: Double,
        private val c: Double,
        private val d: Double,
    ) : Cut(text) {
        override fun plane(scene: Scene): SectionPlane {
            val length = StrictMath.sqrt(a * a + b * b + c * c)
            return SectionPlane(Vector3d(a, b, c), d / length)
        }
    }

    companion object {
        private val axes = listOf("x", "y", "z")

        /** Returns the plane that [text] describes, or null if it describes none. */
        fun parse(text: String): Cut? = if ('=' in text) axis(text) else general(text)

        private fun axis(text: String): Cut? {
            val name = text.substringBefore('=').lowercase()
            val axis = axes.indexOf(if (name.startsWith('+') || name.startsWith('-')) name.drop(1) else name)
            val place = text.substringAfter('=')
            val number = decimal(place.removeSuffix("%"))
            if (axis < 0 || number == null) return null
            return Axis(text, axis, if (name.startsWith('-')) -1 else 1, number, place.endsWith('%'))
        }

        private fun general(text: String): Cut? {
            val numbers = text.split(',').map { decimal(it) ?: return null }
            if (numbers.size != 4) return null
            val (a, b, c, d) = numbers
            val square = a * a + b * b + c * c
            return if (square > 0.0 && square.isFinite() && d.isFinite()) General(text, a, b, c, d) else null
        }
    }
}

/** Returns the decimal number that [text] is, such as `-2.5` or `.5e3`, or null: other forms do not count. */
internal fun decimal(text: String): Double? =
    if (text.all { it in "0123456789.+-eE" }) text.toDoubleOrNull() else null
