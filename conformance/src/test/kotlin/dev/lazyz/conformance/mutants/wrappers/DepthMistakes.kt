package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.drawing
import dev.lazyz.conformance.mutants.emit
import dev.lazyz.conformance.mutants.painting
import dev.lazyz.conformance.mutants.primitives
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Renderers that are correct except for depths and their comparison. */
internal object DepthMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::flatPrimitives, "whole primitives are sorted by their nearest depths, instead of comparing samples"),
        Mistake(::staleRejection, "a whole primitive is rejected if it is hidden at one sample"),
        Mistake(::rejectsByEnds, "a primitive is rejected if it is hidden in the tiles at the ends of its bounds"),
        Mistake(
            ::rejectsByConvention, "rejects what is behind the background by the convention, whatever the depth test",
        ),
        Mistake(::dropsEqualPrimitives, "a primitive that equals an earlier one is dropped"),
        Mistake(::numbersByEquality, "the index is that of the first primitive that is equal"),
        Mistake(::numbersTheExtended, "primitives whose bounds are empty have no number"),
        Mistake(::throughFloat, "depth goes through a float"),
        Mistake(::in24Bits, "depth has 24 bits"),
        Mistake(::middleOfSlivers, "what is seen edge-on is halfway to the far plane"),
        Mistake(::ordersPlanes, "planes are ordered as if depths were not rounded"),
    )

    fun throughFloat() = primitives("depth-through-float") { At(it) { x, y -> it.depth(x, y).toFloat().toInt() } }

    fun in24Bits() = primitives("depth-in-24-bits") { At(it) { x, y -> it.depth(x, y) shr 7 shl 7 } }

    fun numbersTheExtended() = painting("numbers-the-extended") { image, frame ->
        image.renumbered { index ->
            (0 until index).count { frame.primitives[it].rowStart < frame.primitives[it].rowEnd }
        }
    }

    fun flatPrimitives() = comparing("painter-by-nearest-depth") { primitive, _, _, _ -> primitive.leastDepth }

    /** Decides by one sample of what was drawn so far whether a whole primitive is hidden. */
    fun staleRejection() = drawing("rejects-by-one-corner") { frame ->
        frame.keeping { index ->
            val before = ZBufferRenderer().render(frame.keeping { it < index })
            val depth = before.depth[0]
            val primitive = frame.primitives[index]
            when (frame.raster.depthTest) {
                DepthTest.LESS, DepthTest.LESS_OR_EQUAL -> primitive.leastDepth <= depth
                else -> primitive.greatestDepth >= depth
            }
        }
    }

    /** Looks only at the tiles of 16 x 16 samples at the corners of a primitive's bounds. */
    fun rejectsByEnds() = drawing("rejects-by-ends") { frame ->
        val image = ZBufferRenderer().render(frame)
        fun ends(start: Int, end: Int, most: Int) =
            listOf(maxOf(start, 0), minOf(end, most) - 1).flatMap { (it and 15.inv())..minOf(it or 15, most - 1) }
        frame.keeping { index ->
            val primitive = frame.primitives[index]
            val columns = ends(primitive.columnStart, primitive.columnEnd, image.width)
            val rows = ends(primitive.rowStart, primitive.rowEnd, image.height)
            rows.any { y -> columns.any { x -> image.depth[y * image.width + x] >= primitive.leastDepth } }
        }
    }

    /** Rejects a primitive that would be behind the background if the convention decided, and not the test. */
    fun rejectsByConvention() = drawing("rejects-by-the-convention") { frame ->
        val raster = frame.raster
        if (raster.convention == DepthConvention.LARGER_IS_NEARER) return@drawing frame
        frame.keeping { frame.primitives[it].leastDepth <= raster.backgroundDepth }
    }

    /** A primitive at another depth, without a linear form. */
    private class At(whole: Primitive, private val how: (x: Int, y: Int) -> Int) : Primitive by whole {
        override val depthForm get() = null

        override fun depth(x: Int, y: Int): Int = how(x, y)
    }

    /** Compares other depths than it shows. */
    private fun comparing(id: String, how: (primitive: Primitive, x: Int, y: Int, depth: Int) -> Int) =
        BrokenRenderer(id) { frame, sink ->
            val primitives = frame.primitives.map { At(it) { x, y -> how(it, x, y, it.depth(x, y)) } }
            val image = ZBufferRenderer().render(Frame(frame.raster, primitives, frame.region))
            val shown = image.withDepths { i, _ ->
                val x = image.region.columnStart + i % image.width
                val y = image.region.rowStart + i / image.width
                frame.primitives.getOrNull(image.primitive[i])?.depth(x, y) ?: frame.raster.backgroundDepth
            }
            emit(shown, sink)
        }

    /** The plane of a triangle seen edge-on is too steep for a form, and is taken to be halfway to the far plane. */
    fun middleOfSlivers() = primitives("middle-of-slivers") { whole ->
        val isSliver = whole.columnEnd - whole.columnStart in 1..3 && whole.rowEnd - whole.rowStart > 6
        if (isSliver) At(whole) { _, _ -> Int.MAX_VALUE / 2 } else whole
    }

    /** At each sample, what the planes order before all others: ties of depth go to the nearer plane. */
    fun ordersPlanes() = BrokenRenderer("orders-planes") { frame, sink ->
        val alone = frame.primitives.indices.map { index -> ZBufferRenderer().render(frame.keeping { it == index }) }
        val image = ZBufferRenderer().render(frame)
        val nearest = IntArray(image.primitive.size) { at ->
            fun plane(index: Int): Long {
                val form = frame.primitives[index].depthForm ?: return alone[index].depth[at].toLong() shl 32
                return form.at(frame.region.columnStart + at % frame.width, frame.region.rowStart + at / frame.width)
            }
            alone.indices.filter { alone[it].primitive[at] == it }.minByOrNull(::plane) ?: DepthTest.BACKGROUND
        }
        emit(Image(image.region, image.argb, image.depth, nearest, image.counters), sink)
    }

    private fun Image.withDepths(change: (i: Int, depth: Int) -> Int) =
        Image(region, argb, IntArray(depth.size) { change(it, depth[it]) }, primitive, counters)

    fun dropsEqualPrimitives() = drawing("drops-equal-primitives") { frame ->
        val seen = HashSet<Primitive>()
        frame.keeping { seen.add(frame.primitives[it]) }
    }

    fun numbersByEquality() = painting("numbers-by-equality") { image, frame ->
        image.renumbered { frame.primitives.indexOf(frame.primitives[it]) }
    }
}
