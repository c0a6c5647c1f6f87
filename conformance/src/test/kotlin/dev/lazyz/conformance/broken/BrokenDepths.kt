package dev.lazyz.conformance.broken

import dev.lazyz.DepthConvention
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.strategies.zbuffer.ZBuffer

/** Renderers that are correct except for depths and their comparison. */
object BrokenDepths {

    fun flatPrimitives() = comparing("painter-by-nearest-depth") { primitive, _, _, _ -> primitive.leastDepth }

    /** Decides by one sample of what was drawn so far whether a whole primitive is hidden. */
    fun staleRejection() = drawing("rejects-by-one-corner") { frame ->
        frame.keeping { index ->
            val before = ZBuffer().render(frame.keeping { it < index })
            val depth = before.depth[0]
            val primitive = frame.primitives[index]
            when (frame.raster.depthTest) {
                DepthTest.LESS, DepthTest.LESS_OR_EQUAL -> primitive.leastDepth <= depth
                else -> primitive.greatestDepth >= depth
            }
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
            val behind = frame.raster.backgroundDepth.let { if (id == "signed-keys") it xor (1 shl 30) else it }
            val raster = frame.raster.withBackgroundDepth(behind)
            val image = ZBuffer().render(Frame(raster, primitives, frame.region))
            val shown = image.withDepths { i, _ ->
                val x = image.region.columnStart + i % image.width
                val y = image.region.rowStart + i / image.width
                frame.primitives.getOrNull(image.primitive[i])?.depth(x, y) ?: frame.raster.backgroundDepth
            }
            emit(shown, sink)
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
