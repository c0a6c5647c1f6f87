package dev.lazyz.conformance.frames

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.spi.Spans
import java.util.Random
import net.jqwik.api.Arbitrary

/** The first [count] of [frames], the same in every run. */
internal fun some(frames: Arbitrary<FrameCase>, count: Int): List<FrameCase> {
    val generator = frames.generator(1000)
    val random = Random(1995)
    return List(count) { generator.next(random).value() }
}

/** A property of a frame's picture, for statistics of distributions. */
internal enum class PictureTrait {
    /** Nothing is visible. */
    EMPTY,

    /**
     * Two primitives have the same depth at a sample, which is the winning one, so that the order of submission
     * decides.
     */
    TIED,

    /** Each of two primitives is nearer at some sample. */
    INTERPENETRATING,

    /** Some sample is covered at least three times. */
    DEEP,

    /** Some primitive has several spans in a row. */
    SEVERAL_SPANS,

    /** Some primitive covers samples and has no linear form of depth. */
    CURVED,

    /** Some primitive covers nothing. */
    USELESS,

    /** Some primitive is translucent. */
    TRANSLUCENT,

    /** The raster has one row or one column. */
    NARROW,
    ;

    companion object {
        /** Returns the traits of [frame]. Cost: samples x primitives^2, so for small frames. */
        fun of(frame: Frame): Set<PictureTrait> = PictureTraits(frame).traits()
    }
}

/** Queries every primitive at every sample. */
private class PictureTraits(private val frame: Frame) {
    private val found = HashSet<PictureTrait>()
    private val covering = BooleanArray(frame.primitives.size)
    private val nearer = HashSet<Pair<Int, Int>>()
    private val spans = Spans()

    fun traits(): Set<PictureTrait> {
        for (y in frame.region.rowStart until frame.region.rowEnd) row(y)
        if (nearer.any { (a, b) -> Pair(b, a) in nearer }) found.add(PictureTrait.INTERPENETRATING)
        if (covering.any { !it }) found.add(PictureTrait.USELESS)
        if (covering.indices.any {
                covering[it] && frame.primitives[it].depthForm == null
            }
        ) {
            found.add(PictureTrait.CURVED)
        }
        if (frame.hasTranslucency) found.add(PictureTrait.TRANSLUCENT)
        if (frame.raster.width == 1 || frame.raster.height == 1) found.add(PictureTrait.NARROW)
        if (ReferenceRenderer().render(frame.asOpaque()).visible == 0) found.add(PictureTrait.EMPTY)
        return found
    }

    private fun row(y: Int) {
        val byColumn = HashMap<Int, MutableList<Int>>()
        for (index in frame.primitives.indices) {
            spans.clear()
            frame.primitives[index].spans(y, spans)
            if (spans.count > 1) found.add(PictureTrait.SEVERAL_SPANS)
            for (i in 0 until spans.count) {
                covering[index] = true
                for (x in spans.start(i) until spans.end(i)) byColumn.getOrPut(x) { ArrayList() }.add(index)
            }
        }
        for ((x, indices) in byColumn) sample(x, y, indices)
    }

    private fun sample(x: Int, y: Int, indices: List<Int>) {
        if (indices.size >= 3) found.add(PictureTrait.DEEP)
        val depths = indices.map { frame.primitives[it].depth(x, y) }
        val isLess = frame.raster.depthTest == DepthTest.LESS || frame.raster.depthTest == DepthTest.LESS_OR_EQUAL
        val best = if (isLess) depths.min() else depths.max()
        if (depths.count { it == best } > 1) found.add(PictureTrait.TIED)
        for (i in indices.indices) {
            for (k in indices.indices) if (depths[i] < depths[k]) nearer.add(Pair(indices[i], indices[k]))
        }
    }
}
