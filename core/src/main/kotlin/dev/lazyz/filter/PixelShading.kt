package dev.lazyz.filter

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.RowSink
import dev.lazyz.ShadingRate
import dev.lazyz.shading.GatheredShading
import java.util.Arrays

/**
 * Receives rows of samples without colours, and passes the samples of each pixel on with the colours of
 * [ShadingRate.PIXEL]. Footprints of textures are those of pixels. The region of [frame] consists of whole pixels.
 * Belongs to one rendering.
 *
 * Most pixels show one primitive, or only the background. Which ones is found by comparing long runs of samples. Pixels
 * wait until there are enough fragments to shade them together.
 */
internal class PixelShading(private val frame: Frame, private val factor: Int, private val sink: PixelSink) : RowSink {
    private val width = frame.width / factor
    private val samplesOfPixel = factor * factor
    private val background = frame.raster.background.toArgb()

    /** The primitives of the samples of a row of pixels. */
    private val primitives = Array(factor) { IntArray(frame.width) }

    /** Whether all samples of a pixel have the same primitive, or none, as far as their rows have been received. */
    private val isEven = BooleanArray(width)

    private val shading = GatheredShading(frame.content, factor, room(factor))
    private var shadingCalls = 0L

    private val fromCentre = PixelSamples.fromCentre(factor)

    /** Columns of the pixels that wait, and the places of their samples in [fragments], or [EVEN]. */
    private val waiting = IntArray(room(factor))
    private val places = IntArray(room(factor))
    private var waitingCount = 0

    /** For each sample of the uneven pixels that wait: the number of its fragment, or [EMPTY] for the background. */
    private val fragments = IntArray(room(factor))
    private var fragmentsSize = 0

    /** The primitives, and later the colours, of the samples of a pixel, row by row. */
    private val pixel = IntArray(samplesOfPixel)

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        sink.samples(y, depth, primitive)
        val number = y % factor
        primitive.copyInto(primitives[number], 0, 0, frame.width)
        if (number == 0) findEven() else compare(number)
        if (number != factor - 1) return
        gather(y - number)
        shade()
        sink.end(y / factor)
    }

    /** Finds the pixels whose first row of samples is even. */
    private fun findEven() {
        var x = 0
        while (x < width) {
            val end = BoxSink.endOfRun(primitives[0], x, factor, width)
            isEven.fill(end > x, x, maxOf(end, x + 1))
            x = maxOf(end, x + 1)
        }
    }

    /** Finds the pixels whose row [number] of samples is not like the first one. */
    private fun compare(number: Int) {
        var x = 0
        while (x < width) {
            if (!isEven[x]) {
                x++
                continue
            }
            val start = factor * x
            val equal =
                Arrays.mismatch(primitives[number], start, frame.width, primitives[0], start, frame.width)
            if (equal < 0) return
            x += equal / factor
            isEven[x++] = false
        }
    }

    /** Gathers the fragments of the row of pixels whose first row of samples is [top]. */
    private fun gather(top: Int) {
        val first = primitives[0]
        var x = 0
        while (x < width) {
            makeRoom()
            val index = first[factor * x]
            if (!isEven[x]) {
                gatherMixed(x++, top)
            } else if (index != DepthTest.BACKGROUND) {
                await(x, EVEN)
                add(index, x++, fromCentre[0], top)
            } else {
                val start = x++
                while (x < width && isEven[x] && first[factor * x] == DepthTest.BACKGROUND) x++
                sink.even(start, x, background)
            }
        }
    }

    /** Shades what waits if there may be no room for another pixel. */
    private fun makeRoom() {
        if (maxOf(shading.size, fragmentsSize) + samplesOfPixel > waiting.size) shade()
    }

    /** Adds the pixel [x] to those that wait; [place] is that of its samples in [fragments], or [EVEN]. */
    private fun await(x: Int, place: Int) {
        waiting[waitingCount] = x
        places[waitingCount++] = place
    }

    private fun add(index: Int, x: Int, sample: Int, top: Int): Int =
        shading.add(index, frame.region.columnStart + factor * x + sample % factor, top + sample / factor)

    /** Gathers a fragment of each primitive of the pixel [x]. */
    private fun gatherMixed(x: Int, top: Int) {
        val at = fragmentsSize
        await(x, at)
        fragmentsSize += samplesOfPixel
        fragments.fill(NONE, at, fragmentsSize)
        for (row in 0 until factor) {
            for (column in 0 until factor) pixel[factor * row + column] = primitives[row][factor * x + column]
        }
        for (sample in fromCentre) {
            if (fragments[at + sample] != NONE) continue
            val index = pixel[sample]
            val number = if (index == DepthTest.BACKGROUND) EMPTY else add(index, x, sample, top)
            for (other in 0 until samplesOfPixel) {
                if (fragments[at + other] == NONE && pixel[other] == index) fragments[at + other] = number
            }
        }
    }

    /** Shades the gathered fragments, and passes the pixels that wait for them on. */
    private fun shade() {
        shading.shade()
        shadingCalls += shading.size
        var next = 0
        for (i in 0 until waitingCount) {
            val at = places[i]
            if (at == EVEN) {
                sink.even(waiting[i], waiting[i] + 1, shading.argb[next++])
                continue
            }
            for (sample in 0 until samplesOfPixel) {
                val number = fragments[at + sample]
                pixel[sample] = if (number == EMPTY) background else shading.argb[number]
                next = maxOf(next, number + 1)
            }
            sink.mixed(waiting[i], pixel)
        }
        shading.clear()
        waitingCount = 0
        fragmentsSize = 0
    }

    /** Returns [counters] of the rendering without colours, with the shading calls of this sink. */
    fun counted(counters: Counters): Counters = counters.toBuilder().also {
        it.shadingCalls = shadingCalls
        it.shadingStarts = shadingCalls
        it.shadingSteps = 0
        it.longestChain = 0
    }.build()

    companion object {
        /** Instead of the place of a pixel that has one fragment. */
        private const val EVEN = -1

        /** Numbers of samples without a fragment: of the background, and not yet known. */
        private const val EMPTY = -1
        private const val NONE = -2

        /** The most samples that wait, if a pixel does not have more. */
        private const val MANY = 4096

        private fun room(factor: Int): Int = maxOf(MANY, factor * factor)

        /** Bytes held for the samples of [frame], [factor] x [factor] a pixel. */
        fun bytes(frame: Frame, factor: Int): Long {
            val rows = Int.SIZE_BYTES.toLong() * factor * frame.width + frame.width / factor
            return rows + 3L * Int.SIZE_BYTES * room(factor) + GatheredShading.bytes(room(factor))
        }
    }
}

/** The samples of a pixel. */
internal object PixelSamples {
    /** Returns the samples of a pixel from its centre outward, as row times [factor] plus column. */
    fun fromCentre(factor: Int): IntArray {
        fun square(position: Int): Int = (2 * position + 1 - factor) * (2 * position + 1 - factor)
        return (0 until factor * factor).sortedBy { square(it / factor) + square(it % factor) }.toIntArray()
    }
}

/**
 * Makes rows of samples of the pixels that it receives, and passes them to [sink]. Belongs to one rendering.
 *
 * @param factor samples a pixel in each direction
 * @param width samples in a row
 */
internal class SampleRows(private val factor: Int, private val width: Int, private val sink: RowSink) : PixelSink {
    private val argb = Array(factor) { IntArray(width) }
    private val depths = Array(factor) { IntArray(width) }
    private val indices = Array(factor) { IntArray(width) }

    override fun samples(y: Int, depth: IntArray, primitive: IntArray) {
        depth.copyInto(depths[y % factor], 0, 0, width)
        primitive.copyInto(indices[y % factor], 0, 0, width)
    }

    override fun even(start: Int, end: Int, color: Int) {
        for (row in argb) row.fill(color, factor * start, factor * end)
    }

    override fun mixed(x: Int, colors: IntArray) {
        for (row in 0 until factor) colors.copyInto(argb[row], factor * x, factor * row, factor * (row + 1))
    }

    override fun end(y: Int) {
        for (row in 0 until factor) sink.row(factor * y + row, argb[row], depths[row], indices[row])
    }

    companion object {
        /** Bytes of a sample: colour, depth and primitive. */
        private const val SAMPLE_BYTES = 12L

        /** Bytes held for rows of [width] samples, [factor] x [factor] a pixel. */
        fun bytes(factor: Int, width: Int): Long = SAMPLE_BYTES * factor * width
    }
}

/** Receives the samples of pixels whose primitives are shaded once a pixel, one row of pixels after the other. */
internal interface PixelSink {
    /** Takes the depths and primitives of row [y] of samples, which are valid during this call only. */
    fun samples(y: Int, depth: IntArray, primitive: IntArray)

    /** Takes the pixels from column [start] until [end], whose samples all have the colour [color], `0xAARRGGBB`. */
    fun even(start: Int, end: Int, color: Int)

    /** Takes the pixel in column [x], whose samples have these [colors], row by row. Valid during this call only. */
    fun mixed(x: Int, colors: IntArray)

    /** Ends row [y] of pixels: all of its samples and pixels were passed. */
    fun end(y: Int)
}
