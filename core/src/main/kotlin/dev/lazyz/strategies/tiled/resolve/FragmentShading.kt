package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.bytes
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.ShadingPoints
import dev.lazyz.shading.LateShading
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/** Receives the colours of the samples of a tile. */
internal interface FragmentSink {
    /** Receives the colours [argb], `0xAARRGGBB`, of the samples that the [fragments] are for. */
    fun store(fragments: WaitingFragments, argb: IntArray)

    /** Receives the colour of [length] samples from place [start] on. */
    fun fill(start: Int, length: Int, argb: Int)
}

/**
 * Computes the colours of the visible samples of a tile: many at a time for flat primitives, one by one for others.
 * Belongs to one thread; reused for each tile.
 *
 * The data of a flat primitive is loaded once for all its samples of the tile. Samples are collected, primitive after
 * primitive, until the shader or the attributes change or the batch is full. For primitives with very few samples, this
 * data is not loaded at all.
 */
internal class FragmentShading(
    private val frame: Frame,
    private val keys: VisibilityBuffer,
    private val layers: TileLayers,
    coherence: Coherence,
    private val kernel: FragmentKernel,
    private val counters: Counters.Builder,
    private val checkpoint: Checkpoint,
    private val sink: FragmentSink,
) {
    private val content = frame.content
    private val test = frame.raster.depthTest
    private val single = LateShading(frame, coherence, counters, checkpoint)

    /** Disabled if attributes are stepped along rows. */
    private val faces = FaceCache(content, coherence != Coherence.INCREMENTAL)
    private val packed = IntArray(FragmentBatch.ROOM)
    private val runs = PrimitiveRuns()

    /**
     * Fragments waiting to be shaded, all with the same shader and the same attributes, which are already filled in.
     */
    private val waiting = WaitingFragments()
    private var shader: Shader? = null

    private val small = SmallTriangles(content, keys, faces)
    private var isFine = false
    private var shadedBefore = 0L

    private val alone = FragmentBatch(1)
    private val fragment = Fragment()
    private val points = faces.points

    /** Peak number of bytes held. */
    val bytes: Long
        get() = runs.bytes + waiting.bytes + small.bytes + faces.bytes + single.peakBytes + packed.bytes

    /**
     * Begins a tile.
     *
     * @param isFine whether most triangles are probably so small that they have one run only; affects only the speed
     */
    fun begin(isFine: Boolean) {
        this.isFine = isFine
        runs.begin()
        shadedBefore = counters.shadingCalls
    }

    /** Must be called before each row, if runs are added row by row. */
    fun beginRow() {
        checkpoint.pass()
        single.beginRow()
    }

    /** Adds [length] samples of the primitive [index] from place [start] on, at each of which it is shaded. */
    fun add(index: Int, start: Int, length: Int) = add(index, start, length, length)

    /**
     * Adds samples of a primitive with one colour in each pixel, see [isOnce]: [length] samples of one pixel and one
     * row.
     */
    fun addPart(index: Int, start: Int, length: Int) = add(index, start, length, 1)

    /** Passes the part of the columns [from] until [until] of the tile in each pixel to [action]. */
    inline fun forEachPart(from: Int, until: Int, action: (start: Int, end: Int) -> Unit) {
        val side = points!!.side
        var start = from
        while (start < until) {
            val end = minOf(until, start + side - Math.floorMod(keys.columnStart + start, side))
            action(start, end)
            start = end
        }
    }

    /**
     * Adds [count] pixels in a row, all of whose samples show a primitive with one colour in each pixel. It is shaded
     * at their centres. [start] is the place of the first sample of the first of them; the sink gets the colours for
     * the first sample of each.
     */
    fun addPixels(index: Int, start: Int, count: Int) = add(index, PrimitiveRuns.ofPixels(start), count, count)

    private fun add(index: Int, start: Int, length: Int, fragments: Int) {
        var number = runs.find(index)
        if (number == PrimitiveRuns.NONE) {
            if (isFine && fragments < FEW && canGatherSmall(index, fragments)) {
                count(fragments)
                return small.add(index, start, length)
            }
            number = note(index)
        }
        when (number) {
            PrimitiveRuns.ONE_BY_ONE -> shadeEach(index, start, length)
            PrimitiveRuns.CONSTANT -> {
                count(fragments)
                fill(start, length, runs.color(index))
            }
            else -> {
                count(fragments)
                runs.add(number, start, length, fragments)
            }
        }
    }

    private fun fill(start: Int, length: Int, argb: Int) {
        if (!PrimitiveRuns.isOfPixels(start)) return sink.fill(start, length, argb)
        for (i in 0 until length) sink.fill(start + points!!.side * i, 1, argb)
    }

    /** Whether primitive [index] is in a batch, and so is a triangle. */
    fun isOfBatch(index: Int): Boolean = faces.isUsed && faces.batch(index) >= 0

    /** Whether primitive [index] has one colour in each pixel, see [ShadingPoints]. */
    fun isOnce(index: Int): Boolean = points != null && faces.isOnce(index)

    /** Shades and stores what was added. Ends the tile. */
    fun finish() {
        for (number in 0 until runs.count) shadeAll(number)
        flush()
        flushSmall()
        counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
    }

    private fun shadeEach(index: Int, start: Int, length: Int) {
        val primitive = primitive(index)
        val x = keys.columnStart + PrimitiveRuns.column(start)
        val y = keys.rowStart + PrimitiveRuns.row(start)
        if (PrimitiveRuns.isOfPixels(start)) {
            val side = points!!.side
            for (i in 0 until length) {
                sink.fill(start + side * i, 1, single.shaded(x + side * i, y, index, primitive).toArgb())
            }
        } else if (isOnce(index)) {
            sink.fill(start, length, single.shaded(x, y, index, primitive).toArgb())
        } else {
            for (i in 0 until length) {
                sink.fill(start + i, 1, single.shaded(x + i, y, index, primitive).toArgb())
            }
        }
    }

    /** Records a primitive that is encountered for the first time, see [PrimitiveRuns.find]. */
    private fun note(index: Int): Int {
        if (!faces.isFlat(index)) return runs.noteOneByOne(index)
        val constant = faces.constant(index) ?: return runs.note(index)
        return runs.noteConstant(index, constant.argb)
    }

    /** Counts shading calls. */
    private fun count(calls: Int) {
        counters.shadingCalls += calls
        counters.shadingStarts += calls
    }

    /** Computes the colours of all samples of group [number] of [runs], or adds the samples to those waiting. */
    private fun shadeAll(number: Int) {
        val index = runs.index(number)
        if (runs.size(number) < FEW && canGatherSmall(index, runs.size(number))) {
            return runs.forEach(number) { start, length -> small.add(index, start, length) }
        }
        val face = faces.face(index)!!
        if (face.isConstant) {
            runs.forEach(number) { start, length -> fill(start, length, face.argb) }
        } else {
            gather(number, face, isOnce(index))
        }
    }

    /** Adds the samples of a face to those waiting. */
    private fun gather(number: Int, face: Face, isOnce: Boolean) {
        val side = if (isOnce) points!!.side else 1
        if (face.shader !== shader || face.fields != waiting.batch.fields) {
            flush()
            shader = face.shader
            waiting.batch.begin(face.fields)
        }
        var first = waiting.size
        runs.forEach(number) { start, length ->
            var done = 0
            while (done < length) {
                if (waiting.room == 0) {
                    kernel.attributes(face, waiting, first, keys.columnStart, keys.rowStart, side)
                    flush()
                    first = 0
                }
                if (isOnce && !PrimitiveRuns.isOfPixels(start)) {
                    waiting.addPart(start, length, keys, points!!, face)
                    done = length
                } else {
                    val count = minOf(length - done, waiting.room)
                    if (isOnce) {
                        waiting.addPixels(start + side * done, count, side)
                    } else {
                        waiting.add(start + done, count)
                    }
                    done += count
                }
            }
        }
        kernel.attributes(face, waiting, first, keys.columnStart, keys.rowStart, side)
    }

    /**
     * Returns whether primitive [index] can be shaded as a small triangle; if so, makes room for [count] more samples.
     */
    private fun canGatherSmall(index: Int, count: Int): Boolean {
        val batch = if (faces.isUsed) faces.batch(index) else -1
        if (!small.accepts(batch)) return false
        if (!small.hasRoom(batch, count)) {
            flushSmall()
            small.begin(batch)
        }
        return true
    }

    /** Shades the waiting fragments of faces. */
    private fun flush() {
        if (waiting.size == 0) return
        waiting.locate(keys.columnStart, keys.rowStart)
        shade(waiting, shader!!)
    }

    /** Shades the waiting fragments of small triangles. */
    private fun flushSmall() {
        if (small.fragments.size > 0) shade(small.fragments, small.complete())
    }

    private fun shade(fragments: WaitingFragments, shader: Shader) {
        checkpoint.pass()
        val batch = fragments.batch
        batch.shade(shader)
        kernel.pack(batch, packed)
        fragments.takeOut(packed, sink)
    }

    /** Returns the primitive [index], which has no face. */
    private fun primitive(index: Int): Primitive =
        if (faces.isUsed) content.single(index) else frame.primitives[index]

    /** Whether a translucent fragment is before the opaque one at a sample. */
    fun isBlended(x: Int, y: Int): Boolean {
        val opaque = keys.at(x, y)
        return layers.nearest(keys.place(x, y), opaque) != opaque
    }

    /** Returns the colour, `0xAARRGGBB`, of a sample at which a translucent primitive is before the opaque one. */
    fun blend(x: Int, y: Int): Int {
        val opaque = keys.at(x, y)
        val backdrop = if (test.indexOf(opaque) == DepthTest.BACKGROUND) null else opaque
        return layers.blend(keys.place(x, y), backdrop, frame.raster.background) { key ->
            shaded(x, y, test.indexOf(key))
        }
    }

    /** Returns a fragment with the colour of the primitive [index], not packed. */
    fun shaded(x: Int, y: Int, index: Int): Fragment {
        val face = faces.face(index) ?: return single.shaded(x, y, index, primitive(index))
        checkpoint.pass()
        count(1)
        if (face.isConstant) {
            face.shadeConstant(fragment)
        } else {
            alone.begin(face.fields)
            attributes(face, x, y, isOnce(index))
            alone.moveTo(fragment, 0)
            face.shader.shade(fragment)
        }
        return fragment
    }

    /** Sets the attributes of [alone] to those of a sample, or of the shading point in its pixel. */
    private fun attributes(face: Face, x: Int, y: Int, isOnce: Boolean) {
        var gridX = ScreenGrid.STEPS * x
        var gridY = ScreenGrid.STEPS * y
        if (isOnce) {
            val left = points!!.first(x)
            val top = points.first(y)
            val point = points.find(face, left, top)
            gridX = ScreenGrid.STEPS * left + ShadingPoints.right(point)
            gridY = ScreenGrid.STEPS * top + ShadingPoints.down(point)
        }
        alone.place(0, gridX shr ScreenGrid.SHIFT, gridY shr ScreenGrid.SHIFT, 1)
        face.attributes(alone, 0, gridX, gridY, if (isOnce) points!!.side else 1)
    }

    private companion object {
        /** Fewest samples for which it is worthwhile to load a triangle's face. */
        const val FEW = 4
    }
}
