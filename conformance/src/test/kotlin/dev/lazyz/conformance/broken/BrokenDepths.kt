package dev.lazyz.conformance.broken

import dev.lazyz.Depth
import dev.lazyz.DepthConvention
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Spans
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.strategies.zbuffer.ZBuffer

/** Renderers that are correct except for depths and their comparison. */
object BrokenDepths {
    fun throughFloat() = primitives("depth-through-float") { At(it) { x, y -> it.depth(x, y).toFloat().toInt() } }

    fun in24Bits() = primitives("depth-in-24-bits") { At(it) { x, y -> it.depth(x, y) shr 7 shl 7 } }

    fun clampedToPlanes() = primitives("depth-clamped-to-planes") {
        At(it) { x, y -> it.depth(x, y).coerceIn(Depth.NEAR, Depth.FAR) }
    }

    fun formsInDouble() = primitives("forms-in-double") {
        val form = it.depthForm
        At(it) { x, y -> if (form == null) it.depth(x, y) else inDouble(form, x, y) }
    }

    private fun inDouble(form: LinearForm, x: Int, y: Int): Int =
        StrictMath.floor((form.c.toDouble() + form.dx.toDouble() * x + form.dy.toDouble() * y) / 4294967296.0).toInt()
            .coerceAtLeast(0)

    fun roundedDown() = primitives("depth-rounded-down") {
        val form = it.depthForm
        At(it) { x, y -> if (form == null) it.depth(x, y) else maxOf((form.at(x, y) - (1L shl 31) shr 32).toInt(), 0) }
    }

    fun oneStepBehind() = primitives("one-step-behind") {
        val form = it.depthForm
        At(it) { x, y -> if (form == null) it.depth(x, y) else maxOf((form.at(x, y) - form.dx shr 32).toInt(), 0) }
    }

    fun signedKeys() = comparing("signed-keys") { _, _, _, depth -> depth xor (1 shl 30) }

    fun spanComparedAtItsStart() = comparing("span-compared-at-its-start") { primitive, x, y, _ ->
        val spans = Spans().also { primitive.spans(y, it) }
        val start = (0 until spans.count).firstOrNull { x >= spans.start(it) && x < spans.end(it) }
        primitive.depth(if (start == null) x else spans.start(start), y)
    }

    fun flatPrimitives() = comparing("painter-by-nearest-depth") { primitive, _, _, _ -> primitive.leastDepth }

    fun backgroundLosesTies() = BrokenRenderer("background-loses-ties") { frame, sink ->
        val behind = with(frame.raster) {
            when {
                depthTest == DepthTest.LESS && backgroundDepth < Int.MAX_VALUE -> backgroundDepth + 1
                depthTest == DepthTest.GREATER && backgroundDepth > 0 -> backgroundDepth - 1
                else -> backgroundDepth
            }
        }
        val image = ZBuffer().render(frame.on { withBackgroundDepth(behind) })
        emit(image.withDepths { i, depth -> if (image.primitive[i] < 0) frame.raster.backgroundDepth else depth }, sink)
    }

    fun reversedTestsSwapTies() = drawing("reversed-tests-swap-ties") { frame ->
        val test = frame.raster.depthTest
        val isReversed = test == DepthTest.GREATER || test == DepthTest.GREATER_OR_EQUAL
        frame.on { withDepthTest(if (isReversed) swappedTies(test) else test) }
    }

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

    /** Rejects a primitive that is nowhere nearer than what was drawn so far, though it may win ties. */
    fun rejectsTies() = drawing("rejects-ties-by-bounds") { frame ->
        val test = frame.raster.depthTest
        val isLeast = test == DepthTest.LESS_OR_EQUAL
        if (frame.primitives.size > FEW || (!isLeast && test != DepthTest.GREATER_OR_EQUAL)) return@drawing frame
        frame.keeping { index ->
            val primitive = frame.primitives[index]
            val before = ZBuffer().render(frame.keeping { it < index })
            before.depth.any { if (isLeast) primitive.leastDepth < it else primitive.greatestDepth > it }
        }
    }

    /** Rejects a primitive that would be behind the background if the convention decided, and not the test. */
    fun rejectsByConvention() = drawing("rejects-by-the-convention") { frame ->
        val raster = frame.raster
        if (raster.convention == DepthConvention.LARGER_IS_NEARER) return@drawing frame
        frame.keeping { frame.primitives[it].leastDepth <= raster.backgroundDepth }
    }

    private const val FEW = 100

    fun mergesEqualColours() = painting("merges-equal-colours") { image, _ ->
        val depth = image.depth.copyOf()
        for (i in depth.indices) {
            if (i % image.width > 0 && image.argb[i] == image.argb[i - 1]) depth[i] = depth[i - 1]
        }
        Image(image.region, image.argb, depth, image.primitive, image.counters)
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
