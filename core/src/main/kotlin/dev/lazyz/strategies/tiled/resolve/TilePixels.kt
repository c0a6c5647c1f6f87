package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.bytes
import dev.lazyz.filter.LightSums
import dev.lazyz.filter.LightSums.CHANNELS
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/**
 * Fills in each pixel of a tile, the mean of its [side] x [side] samples. Nothing of the size of the samples leaves the
 * tile.
 *
 * Most pixels are *even*: all samples show the same primitive. Such a pixel takes the colour of one fragment, if the
 * primitive is shaded once a pixel. All other colours are added up in linear light, each as often as there are samples
 * that it stands for.
 *
 * @param side how many samples wide and high a pixel is, a power of two that divides the sides of all tiles
 */
internal class TilePixels(
    frame: Frame,
    keys: VisibilityBuffer,
    private val layers: TileLayers,
    kernel: FragmentKernel,
    counters: Counters.Builder,
    private val checkpoint: Checkpoint,
    private val side: Int,
) : TileShading(frame, keys, layers, Coherence.DIRECT, kernel, counters, checkpoint, side) {
    private val samples = side * side
    private val stride = keys.stride
    private val shift = Integer.numberOfTrailingZeros(side)
    private val pixelsOfRow = stride / side

    /** The places of the samples of a pixel in the keys of the tile, from its first one. */
    private val offsets = IntArray(samples) { it / side * stride + it % side }

    /** By column of the tile, the bits in which the keys of a row of pixels differ from those of its first samples. */
    private val differences = LongArray(stride)

    private val sums = PixelSums(keys.size / samples, side)

    /** A bit for each sample of a pixel. */
    private val all = -1L ushr Long.SIZE_BITS - samples

    /** The primitives of a mixed pixel, in the order of [offsets]. */
    private val indices = IntArray(samples)

    override val bytes: Long
        get() = super.bytes + 2 * offsets.bytes + differences.bytes + sums.bytes

    override fun shadeRows() {
        sums.clear()
        for (row in 0 until (keys.rowEnd - keys.rowStart) / side) {
            checkpoint.pass()
            shadeRow(row)
        }
    }

    private fun shadeRow(row: Int) {
        val first = row * side * stride
        val width = (keys.columnEnd - keys.columnStart) / side
        findDifferences(first, side * width)
        var x = 0
        while (x < width) {
            if (isBlended(x, row)) {
                blend(x++, row)
            } else if (!isEven(first, x)) {
                mix(x++, row)
            } else {
                val index = test.indexOf(keys.keys[first + side * x])
                val start = x++
                while (x < width && test.indexOf(keys.keys[first + side * x]) == index && isEven(first, x) &&
                    !isBlended(x, row)
                ) {
                    x++
                }
                shadeEven(index, row, start, x)
            }
        }
    }

    private fun findDifferences(first: Int, width: Int) {
        val all = keys.keys
        val differences = differences
        differences.fill(0)
        for (row in 1 until side) {
            val other = first + row * stride
            for (i in 0 until width) differences[i] = differences[i] or (all[first + i] xor all[other + i])
        }
    }

    /** Whether all samples of pixel [x] have the same primitive. */
    private fun isEven(first: Int, x: Int): Boolean {
        val all = keys.keys
        val start = side * x
        val key = all[first + start]
        var difference = differences[start]
        for (i in start + 1 until start + side) difference = difference or differences[i] or (key xor all[first + i])
        return difference.toInt() == 0
    }

    /** Passes the samples of a pixel to [action]: their columns and rows in the picture. */
    private inline fun samples(x: Int, row: Int, action: (x: Int, y: Int) -> Unit) {
        for (y in keys.rowStart + side * row until keys.rowStart + side * (row + 1)) {
            for (i in keys.columnStart + side * x until keys.columnStart + side * (x + 1)) action(i, y)
        }
    }

    private fun isBlended(x: Int, row: Int): Boolean {
        if (layers.isEmpty) return false
        samples(x, row) { column, y -> if (fragments.isBlended(column, y)) return true }
        return false
    }

    /** Fills in the pixels [start] until [end] of a row of pixels. All their samples show the primitive [index]. */
    private fun shadeEven(index: Int, row: Int, start: Int, end: Int) {
        band.primitive[row].fill(index, toColumn + start, toColumn + end)
        if (index == DepthTest.BACKGROUND) {
            band.argb[row].fill(background, toColumn + start, toColumn + end)
            band.depth[row].fill(frame.raster.backgroundDepth, toColumn + start, toColumn + end)
            return
        }
        val isFlat = fragments.isOfBatch(index)
        for (x in start until end) {
            val at = side * (row * stride + x)
            band.depth[row][toColumn + x] = test.depthOf(if (isFlat) nearestCorner(at) else nearest(at))
        }
        if (fragments.isOnce(index)) {
            return fragments.addPixels(index, PrimitiveRuns.place(side * row, side * start), end - start)
        }
        for (x in start until end) begin(x, row)
        for (y in side * row until side * (row + 1)) {
            fragments.add(index, PrimitiveRuns.place(y, side * start), side * (end - start))
        }
    }

    /** Fills in pixel [x] of a row of pixels, whose samples show several primitives. */
    private fun mix(x: Int, row: Int) {
        val at = side * (row * stride + x)
        val pixel = begin(x, row)
        keepNearest(x, row, nearest(at))
        for (i in 0 until samples) indices[i] = test.indexOf(keys.keys[at + offsets[i]])
        var rest = all
        while (rest != 0L) {
            val sample = rest.countTrailingZeroBits()
            val index = indices[sample]
            var same = samplesOf(index)
            rest = rest and same.inv()
            val count = same.countOneBits()
            if (index == DepthTest.BACKGROUND) {
                sums.add(pixel, background, count, isCorner = sample == 0)
            } else if (fragments.isOnce(index)) {
                fragments.addPart(index, place(x, row, sample, count), 1)
            } else {
                while (same != 0L) {
                    fragments.add(index, place(x, row, same.countTrailingZeroBits(), 1), 1)
                    same = same and same - 1
                }
            }
        }
    }

    /** Returns which samples of the mixed pixel show the primitive [index]: a bit for each. */
    private fun samplesOf(index: Int): Long {
        var same = 0L
        for (i in samples - 1 downTo 0) {
            // Without a branch, which could not be predicted
            val difference = indices[i] xor index
            same = (same shl 1) + ((difference or -difference).inv() ushr Int.SIZE_BITS - 1)
        }
        return same
    }

    /** Returns the place of a [sample] of a pixel, which stands for [count] of them. */
    private fun place(x: Int, row: Int, sample: Int, count: Int): Int =
        PrimitiveRuns.place(side * row + (sample shr shift), side * x + (sample and side - 1), count)

    /** Fills in pixel [x] of a row of pixels, in which translucent fragments are visible: each sample is shaded. */
    private fun blend(x: Int, row: Int) {
        val pixel = begin(x, row)
        var nearest = Long.MAX_VALUE
        samples(x, row) { column, y ->
            val opaque = keys.at(column, y)
            val key = layers.nearest(keys.place(column, y), opaque)
            nearest = minOf(nearest, key)
            val index = test.indexOf(key)
            val color = when {
                key != opaque -> fragments.blend(column, y)
                index == DepthTest.BACKGROUND -> background
                else -> fragments.shaded(column, y, index).toArgb()
            }
            val isCorner = column == keys.columnStart + side * x && y == keys.rowStart + side * row
            sums.add(pixel, color, 1, isCorner)
        }
        keepNearest(x, row, nearest)
    }

    /** Begins the sums of pixel [x], and returns the number of the pixel. */
    private fun begin(x: Int, row: Int): Int {
        val pixel = row * pixelsOfRow + x
        sums.begin(pixel)
        return pixel
    }

    private fun keepNearest(x: Int, row: Int, key: Long) {
        band.depth[row][toColumn + x] = test.depthOf(key)
        band.primitive[row][toColumn + x] = test.indexOf(key)
    }

    /** Returns the nearest key of a pixel of one flat primitive: it is at a corner, because depth is linear. */
    private fun nearestCorner(at: Int): Long {
        val all = keys.keys
        val below = at + (side - 1) * stride
        return minOf(minOf(all[at], all[at + side - 1]), minOf(all[below], all[below + side - 1]))
    }

    /** Returns the nearest key of the pixel whose first key is at [at]. */
    private fun nearest(at: Int): Long {
        val all = keys.keys
        var nearest = all[at]
        for (offset in offsets) nearest = minOf(nearest, all[at + offset])
        return nearest
    }

    /** Takes the [color] of the fragment at a place. */
    private fun take(place: Int, color: Int) {
        val pixel = pixel(place)
        if (pixel in sums) {
            sums.add(pixel, color, PrimitiveRuns.samples(place), PrimitiveRuns.isCorner(place, side))
        } else {
            band.argb[PrimitiveRuns.row(place) shr shift][toColumn + (PrimitiveRuns.column(place) shr shift)] = color
        }
    }

    override fun store(fragments: WaitingFragments, argb: IntArray) {
        val places = fragments.places
        var i = 0
        while (i < fragments.size) {
            val pixel = pixel(places[i])
            if (pixel !in sums) {
                take(places[i], argb[i++])
                continue
            }
            val first = i++
            while (i < fragments.size && pixel(places[i]) == pixel) i++
            sums.add(pixel, places, argb, first, i)
        }
    }

    override fun fill(start: Int, length: Int, argb: Int) {
        for (i in 0 until length) take(start + i, argb)
    }

    private fun pixel(place: Int): Int =
        (PrimitiveRuns.row(place) shr shift) * pixelsOfRow + (PrimitiveRuns.column(place) shr shift)

    override fun finish() {
        for (number in 0 until sums.count) {
            val pixel = sums[number]
            band.argb[pixel / pixelsOfRow][toColumn + pixel % pixelsOfRow] = sums.mean(pixel, samples)
        }
    }
}

/**
 * The light of those pixels of a tile whose samples have several colours. Belongs to one thread; reused for each tile.
 *
 * @param pixels number of pixels of the largest tile
 * @param side how many samples wide and high a pixel is
 */
internal class PixelSums(pixels: Int, private val side: Int) {
    private val has = BooleanArray(pixels)
    private val sums = LongArray(CHANNELS * pixels)

    /** By pixel, the colour of its upper left sample. */
    private val corners = IntArray(pixels)
    private val all = IntArray(pixels)

    /** Number of pixels. */
    var count: Int = 0
        private set

    /** Bytes held. */
    val bytes: Long get() = has.size + sums.bytes + corners.bytes + all.bytes

    /** Removes all pixels. */
    fun clear() {
        has.fill(false)
        count = 0
    }

    /** Adds a [pixel] without colours. */
    fun begin(pixel: Int) {
        has[pixel] = true
        all[count++] = pixel
        sums.fill(0, CHANNELS * pixel, CHANNELS * (pixel + 1))
    }

    operator fun contains(pixel: Int): Boolean = has[pixel]

    /** Returns the pixel with this [number], 0 until [count]. */
    operator fun get(number: Int): Int = all[number]

    /** Adds a [color] to a pixel, for so many [samples], of which the upper left one may be one. */
    fun add(pixel: Int, color: Int, samples: Int, isCorner: Boolean) {
        if (isCorner) corners[pixel] = color
        LightSums.add(sums, CHANNELS * pixel, color, samples.toLong())
    }

    /** Adds the colours [argb] from number [first] until [end] to a pixel; they are at these [places] of it. */
    fun add(pixel: Int, places: IntArray, argb: IntArray, first: Int, end: Int) {
        LightSums.add(sums, CHANNELS * pixel, argb, first, end) { i ->
            if (PrimitiveRuns.isCorner(places[i], side)) corners[pixel] = argb[i]
            PrimitiveRuns.samples(places[i])
        }
    }

    /** Returns the mean of a [pixel] with so many [samples]. */
    fun mean(pixel: Int, samples: Int): Int =
        LightSums.mean(sums, CHANNELS * pixel, samples.toLong(), corners[pixel])
}
