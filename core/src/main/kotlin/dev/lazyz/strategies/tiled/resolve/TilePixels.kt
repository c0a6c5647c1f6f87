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
import dev.lazyz.strategies.tiled.resolve.PixelSums.Companion.CORNER

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

    private val sums = PixelSums(keys.size / samples)

    /** For each fragment of a mixed pixel, by its sample: for how many it stands, and [CORNER] for the upper left. */
    private val weights = IntArray(keys.size)

    /** The primitives of a mixed pixel, in the order of [offsets]. */
    private val indices = IntArray(samples)

    override val bytes: Long
        get() = super.bytes + 2 * offsets.bytes + differences.bytes + sums.bytes + weights.bytes

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
            weights.fill(1, y * stride + side * start, y * stride + side * end)
            if (y == side * row) for (x in start until end) weights[y * stride + side * x] = 1 or CORNER
            fragments.add(index, PrimitiveRuns.place(y, side * start), side * (end - start))
        }
    }

    /** Fills in pixel [x] of a row of pixels, whose samples show several primitives. */
    private fun mix(x: Int, row: Int) {
        val at = side * (row * stride + x)
        val pixel = begin(x, row)
        keepNearest(x, row, nearest(at))
        val corner = test.indexOf(keys.keys[at])
        for (i in 0 until samples) indices[i] = test.indexOf(keys.keys[at + offsets[i]])
        for (i in 0 until samples) {
            val index = indices[i]
            if (index == TAKEN) continue
            if (index != DepthTest.BACKGROUND && !fragments.isOnce(index)) {
                fragments.add(index, weigh(x, row, i, if (i == 0) 1 or CORNER else 1), 1)
                continue
            }
            val count = takeSame(i)
            val weight = if (index == corner) count or CORNER else count
            if (index == DepthTest.BACKGROUND) {
                sums.add(pixel, background, weight)
            } else {
                fragments.addPart(index, weigh(x, row, i, weight), 1)
            }
        }
    }

    /** Marks the samples from number [first] on that show the same primitive as that one, and returns their number. */
    private fun takeSame(first: Int): Int {
        val indices = indices
        val index = indices[first]
        var count = 0
        for (i in first until samples) {
            // Without a branch, which could not be predicted
            val difference = indices[i] xor index
            val other = (difference or -difference) shr Int.SIZE_BITS - 1
            indices[i] = indices[i] and other or (TAKEN and other.inv())
            count += 1 + other
        }
        return count
    }

    /** Records the [weight] of the fragment at a [sample] of a mixed pixel, and returns its place. */
    private fun weigh(x: Int, row: Int, sample: Int, weight: Int): Int {
        val y = side * row + sample / side
        val column = side * x + sample % side
        weights[y * stride + column] = weight
        return PrimitiveRuns.place(y, column)
    }

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
            sums.add(pixel, color, if (isCorner) 1 or CORNER else 1)
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
            sums.add(pixel, color, weight(place))
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
            sums.add(pixel, argb, first, i) { weight(places[it]) }
        }
    }

    override fun fill(start: Int, length: Int, argb: Int) {
        for (i in 0 until length) take(start + i, argb)
    }

    private fun pixel(place: Int): Int =
        (PrimitiveRuns.row(place) shr shift) * pixelsOfRow + (PrimitiveRuns.column(place) shr shift)

    private fun weight(place: Int): Int = weights[PrimitiveRuns.row(place) * stride + PrimitiveRuns.column(place)]

    override fun finish() {
        for (number in 0 until sums.count) {
            val pixel = sums[number]
            band.argb[pixel / pixelsOfRow][toColumn + pixel % pixelsOfRow] = sums.mean(pixel, samples)
        }
    }

    private companion object {
        /** Less than all indices. */
        const val TAKEN = Int.MIN_VALUE
    }
}

/**
 * The light of those pixels of a tile whose samples have several colours. Belongs to one thread; reused for each tile.
 *
 * @param pixels number of pixels of the largest tile
 */
internal class PixelSums(pixels: Int) {
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

    /** Adds a [color] to a pixel, for as many samples as [weight] says, see [CORNER]. */
    fun add(pixel: Int, color: Int, weight: Int) {
        if (weight and CORNER != 0) corners[pixel] = color
        LightSums.add(sums, CHANNELS * pixel, color, (weight and CORNER.inv()).toLong())
    }

    /**
     * Adds the colours [argb] from number [first] until [end] to a pixel; [weight] returns for how many samples each
     * is.
     */
    inline fun add(pixel: Int, argb: IntArray, first: Int, end: Int, weight: (i: Int) -> Int) {
        LightSums.add(sums, CHANNELS * pixel, argb, first, end) { i ->
            val samples = weight(i)
            if (samples and CORNER != 0) corners[pixel] = argb[i]
            samples and CORNER.inv()
        }
    }

    /** Returns the mean of a [pixel] with so many [samples]. */
    fun mean(pixel: Int, samples: Int): Int =
        LightSums.mean(sums, CHANNELS * pixel, samples.toLong(), corners[pixel])

    companion object {
        /** Bit of a weight: one of the samples is the upper left one of the pixel. */
        const val CORNER: Int = 1 shl 16
    }
}
