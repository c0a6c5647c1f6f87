package dev.lazyz.conformance.judgement

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.conformance.cases.FrameCase

/** The result of rendering a frame: the image, the counters, and the rows in the order of delivery. */
internal class Recording private constructor(val image: Image, val counters: Counters, val rows: List<Int>) {
    companion object {
        /** Depth of samples whose row was not delivered. */
        const val MISSING: Int = Int.MIN_VALUE

        /** Renders [frame] row by row. Exceptions of the renderer are passed on. */
        fun of(renderer: Renderer, frame: Frame): Recording {
            val recorder = Recorder(frame.region)
            val counters = renderer.inTime(frame, recorder)
            return Recording(recorder.image(counters), counters, recorder.rows)
        }
    }
}

/** Renders [frame] with the whole time of a deadline, however much of it the try has used before. */
internal fun Renderer.inTime(frame: Frame, sink: RowSink): Counters {
    TryUnderWay.current?.goesOn()
    return render(frame, sink)
}

/**
 * Stores the rows of [region] by their number and accepts everything, even invalid rows. The rules check them later:
 * [Image.Collector] would throw exceptions.
 */
internal class Recorder(private val region: Region) : RowSink {
    private val size = region.size.toInt()
    private val argb = IntArray(size)
    private val depth = IntArray(size) { Recording.MISSING }
    private val primitive = IntArray(size) { DepthTest.BACKGROUND }

    /** The numbers of the rows, in the order of delivery. */
    val rows = ArrayList<Int>()

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        rows.add(y)
        if (y !in region.rowStart until region.rowEnd) return
        copy(argb, this.argb, y)
        copy(depth, this.depth, y)
        copy(primitive, this.primitive, y)
    }

    private fun copy(row: IntArray, to: IntArray, y: Int) {
        row.copyInto(to, (y - region.rowStart) * region.width, 0, minOf(row.size, region.width))
    }

    /** Returns the delivered picture. */
    fun image(counters: Counters): Image = Image(region, argb, depth, primitive, counters)
}

/**
 * A difference between [expected] and [actual]: the first of [count] differing samples, at column [x] and row [y] of
 * the raster.
 */
internal class FirstDifference(val expected: Image, val actual: Image, val x: Int, val y: Int, val count: Int) {
    /** The correct values of the sample, in words. */
    val expectedAnswer: String get() = answer(expected, sample)

    /** The actual values of the sample, in words. */
    val actualAnswer: String get() = answer(actual, sample)

    private val sample get() = (y - expected.region.rowStart) * expected.width + x - expected.region.columnStart

    override fun toString(): String = "sample ($x, $y) is the first of $count that differ\n" +
        "    expected $expectedAnswer\n" +
        "    but was  $actualAnswer"
}

/** Returns the first sample, in rows from the top, at which [actual] differs from [expected]; null if there is none. */
internal fun difference(expected: Image, actual: Image): FirstDifference? {
    val samples = expected.argb.indices.filter { expected.differsAt(actual, it) }
    val first = samples.firstOrNull() ?: return null
    val x = expected.region.columnStart + first % expected.width
    val y = expected.region.rowStart + first / expected.width
    return FirstDifference(expected, actual, x, y, samples.size)
}

/** Returns whether [other], a picture of the same region, has another colour, depth or primitive at index [sample]. */
internal fun Image.differsAt(other: Image, sample: Int): Boolean = argb[sample] != other.argb[sample] ||
    depth[sample] != other.depth[sample] || primitive[sample] != other.primitive[sample]

private fun answer(image: Image, sample: Int): String {
    if (image.depth[sample] == Recording.MISSING) return "nothing: the row was not delivered"
    val index = image.primitive[sample]
    val owner = if (index == DepthTest.BACKGROUND) "the background" else "primitive $index"
    val depth = image.depth[sample].let { if (it < 0) "$it, which is out of range" else "$it" }
    return "#%08x".format(image.argb[sample]) + ", depth $depth, $owner"
}

/** Returns the counters as text without peak memory, which grows with the number of threads. */
internal fun Counters.withoutMemory(): String = toString().substringBefore(", peakBytes")

/** Describes the difference between [actual] and [expected], or returns null if they are equal. */
internal fun differenceInWords(expected: Image, actual: Image): String? =
    if (expected.region != actual.region) {
        "expected ${inWords(expected.region)}, but was ${inWords(actual.region)}"
    } else {
        difference(expected, actual)?.toString()
    }

private fun inWords(region: Region): String =
    "${region.width} x ${region.height} samples from column ${region.columnStart}, row ${region.rowStart} on"

/** The current try of a rule, as seen by the code that renders for the rule. */
internal interface TryUnderWay {
    /** The user's own frames. */
    val ownCases: List<FrameCase>

    /** The name of a setting of the process that has changed since the run began; null if there is none. */
    val settingChanged: String?

    /**
     * Called before a rule renders [case]. [how] describes how the renderer differs from the default; empty if it does
     * not.
     */
    fun saw(case: FrameCase, how: String = "")

    /**
     * Returns whether this try has already used [renderer]. Always false in threads other than the try's own, because
     * there the order is not defined.
     */
    fun isAgain(renderer: Renderer): Boolean

    /** Called when another rendering begins: each has its own deadline. */
    fun goesOn()

    companion object {
        /** The current try; null between rules. There is one at a time in a JVM. */
        @Volatile
        var current: TryUnderWay? = null
    }
}
