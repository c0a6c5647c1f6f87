package dev.lazyz.conformance.cases

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.frames.screen.PolygonPiece
import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.LinearForm

/** Parses the Kotlin code of frames in screen space, as strictly as a compiler would. */
internal class CodeReader(private val code: String) {
    private var at = 0

    /** The polygons, in order. */
    val pieces = ArrayList<PolygonPiece>()

    /** The polygons' contours, x, y, depth triples, in order. */
    val polygons: List<List<DoubleArray>> get() = pieces.map { it.contours }

    /** The frame that the code creates. */
    fun frame(): Frame {
        word("FrameBuilder(")
        val raster = raster()
        val builder = FrameBuilder(raster)
        word(")")
        while (true) {
            word("\n    .")
            when {
                isNext("polygon(") -> polygon(builder)
                isNext("add(Confetti(") -> confetti(builder)
                else -> break
            }
        }
        word("build()")
        val frame = builder.build()
        if (!isNext("\n    .glazed(")) return finished(frame)
        val choice = upTo(")").toInt()
        return finished(frame.glazed(choice))
    }

    private fun finished(frame: Frame): Frame = frame.also {
        check(at == code.length) { "left: ${code.substring(at)}" }
    }

    private fun raster(): Raster {
        word("Raster(")
        val width = upTo(", ").toInt()
        val height = upTo(", ").toInt()
        val background = if (isNext("Rgba.WHITE, ")) {
            Rgba.WHITE
        } else {
            word("Rgba(")
            val parts = upTo("), ").split(", ").map { it.removeSuffix("f").toFloat() }
            Rgba(parts[0], parts[1], parts[2], parts[3])
        }
        word("DepthConvention.")
        val convention = DepthConvention.valueOf(upTo(", "))
        word("DepthTest.")
        return Raster(width, height, background, convention, DepthTest.valueOf(upTo(", ")), upTo(")").toInt())
    }

    private fun polygon(builder: FrameBuilder) {
        word("Frames.tint(")
        val shader = Frames.tint(upTo("), ").toInt())
        word("FillRule.")
        val rule = FillRule.entries.single { isNext(it.name) }
        val contours = ArrayList<DoubleArray>()
        while (isNext(", doubleArrayOf(")) {
            contours.add(upTo(")").split(", ").filter { it.isNotEmpty() }.map(::number).toDoubleArray())
        }
        word(")")
        pieces.add(PolygonPiece(contours, rule))
        builder.polygon(shader, rule, *contours.toTypedArray())
    }

    private fun number(text: String): Double = when (text) {
        "Double.NaN" -> Double.NaN
        "Double.POSITIVE_INFINITY" -> Double.POSITIVE_INFINITY
        "Double.NEGATIVE_INFINITY" -> Double.NEGATIVE_INFINITY
        else -> text.toDouble()
    }

    private fun confetti(builder: FrameBuilder) {
        val numbers = upTo(")")
        val parts = numbers.substringBefore(", LinearForm(").split(", ").map { it.toInt() }
        val form = if (", LinearForm(" in numbers) {
            val (c, dx, dy) = numbers.substringAfter(", LinearForm(").split(", ").map(::long)
            word(")")
            LinearForm(c, dx, dy)
        } else {
            null
        }
        word(")")
        builder.add(Confetti(parts[0], parts[1], parts[2], parts[3], parts[4], parts[5], form))
    }

    private fun long(text: String): Long =
        if (text == "Long.MIN_VALUE") Long.MIN_VALUE else text.removeSuffix("L").toLong()

    private fun word(text: String) = check(isNext(text)) { "$text expected: ${code.substring(at).take(80)}" }

    private fun isNext(text: String): Boolean = code.startsWith(text, at).also { if (it) at += text.length }

    private fun upTo(end: String): String {
        val from = at
        at = code.indexOf(end, from) + end.length
        check(at >= from + end.length) { "$end expected: ${code.substring(from).take(80)}" }
        return code.substring(from, at - end.length)
    }
}
