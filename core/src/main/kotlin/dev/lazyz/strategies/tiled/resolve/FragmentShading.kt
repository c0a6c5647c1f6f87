package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.ShadingRate
import dev.lazyz.bytes
import dev.lazyz.setup.triangleBatch
import dev.lazyz.shading.LateShading
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/** Receives the colours of the samples of a tile. */
internal interface FragmentSink {
    /** Receives the colours, `0xAARRGGBB`, of the first [count] of these [places], see [PrimitiveRuns.place]. */
    fun store(places: IntArray, argb: IntArray, count: Int)

    /** Receives one colour for [length] samples from place [start] on, [step] columns apart. */
    fun fill(start: Int, length: Int, step: Int, argb: Int)
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

    /**
     * Waiting fragments of triangles that are too small to load a face: [smallTriangles] of batch number [smallBatch].
     */
    private val waitingSmall = WaitingFragments()
    private val smallTriangles = IntArray(FragmentBatch.CAPACITY)
    private var smallBatch = -1
    private val scattered = ScatteredAttributes()
    private var isFine = false
    private var shadedBefore = 0L

    private val alone = FragmentBatch(1)
    private val fragment = Fragment()
    private val place = IntArray(1)
    private val color = IntArray(1)

    /** Peak number of bytes held. */
    val bytes: Long
        get() = runs.bytes + waiting.bytes + waitingSmall.bytes + scattered.bytes + faces.bytes + single.peakBytes +
            packed.bytes + smallTriangles.bytes

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

    /**
     * Adds a run of samples of the primitive [index]: [length] samples from place [start] on, which are [step] columns
     * apart. With a [step] other than 1, footprints are as wide; all runs of a primitive have the same.
     */
    fun add(index: Int, start: Int, length: Int, step: Int) {
        var number = runs.find(index)
        if (number == PrimitiveRuns.NONE) {
            if (isFine && length < FEW && canGatherSmall(index, length)) {
                count(length)
                return gatherSmall(index, start, length, step)
            }
            number = note(index, step)
        }
        when (number) {
            PrimitiveRuns.ONE_BY_ONE -> shadeEach(index, start, length, step)
            PrimitiveRuns.CONSTANT -> {
                count(length)
                sink.fill(start, length, step, runs.color(index))
            }
            else -> {
                count(length)
                runs.add(number, start, length)
            }
        }
    }

    /** Shades and stores what was added. Ends the tile. */
    fun finish() {
        for (number in 0 until runs.count) shadeAll(number)
        flush()
        flushSmall()
        counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
    }

    private fun shadeEach(index: Int, start: Int, length: Int, step: Int) {
        val primitive = primitive(index)
        val x = keys.columnStart + PrimitiveRuns.column(start)
        val y = keys.rowStart + PrimitiveRuns.row(start)
        for (i in 0 until length) {
            color[0] = single.shaded(x + step * i, y, index, primitive, step).toArgb()
            place[0] = start + step * i
            sink.store(place, color, 1)
        }
    }

    /** Records a primitive that is encountered for the first time, see [PrimitiveRuns.find]. */
    private fun note(index: Int, step: Int): Int {
        if (!faces.isFlat(index)) return runs.noteOneByOne(index)
        val constant = faces.constant(index) ?: return runs.note(index, step)
        return runs.noteConstant(index, constant.argb)
    }

    /** Counts shading calls. */
    private fun count(calls: Int) {
        counters.shadingCalls += calls
        counters.shadingStarts += calls
    }

    /** Computes the colours of all samples of group number [group] of [runs], or adds the samples to those waiting. */
    private fun shadeAll(number: Int) {
        val index = runs.index(number)
        val step = runs.step(number)
        if (runs.size(number) < FEW && canGatherSmall(index, runs.size(number))) {
            return runs.forEach(number) { start, length -> gatherSmall(index, start, length, step) }
        }
        val face = faces.face(index)!!
        if (face.isConstant) {
            runs.forEach(number) { start, length -> sink.fill(start, length, step, face.argb) }
        } else {
            gather(number, face, step)
        }
    }

    /** Adds the samples of a face to those waiting. */
    private fun gather(number: Int, face: Face, step: Int) {
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
                    kernel.attributes(face, waiting, first, keys.columnStart, keys.rowStart, step)
                    flush()
                    first = 0
                }
                val count = minOf(length - done, waiting.room)
                waiting.add(start + step * done, count, step)
                done += count
            }
        }
        kernel.attributes(face, waiting, first, keys.columnStart, keys.rowStart, step)
    }

    /**
     * Returns whether primitive [index] can be shaded as a small triangle; if so, makes room for [count] more samples.
     */
    private fun canGatherSmall(index: Int, count: Int): Boolean {
        val batch = if (faces.isUsed) faces.batch(index) else -1
        if (batch < 0 || !faces.setUp(batch).isShared) return false
        if (faces.setUp(batch).fields and Attributes.FOOTPRINT != 0) return false
        if (batch != smallBatch || count > waitingSmall.room) {
            flushSmall()
            smallBatch = batch
            waitingSmall.batch.begin(faces.setUp(batch).fields)
        }
        return true
    }

    /**
     * Adds samples of primitive [index] to the waiting ones of small triangles; [canGatherSmall] must have returned
     * true.
     */
    private fun gatherSmall(index: Int, start: Int, length: Int, step: Int) {
        val first = waitingSmall.size
        waitingSmall.add(start, length, step)
        smallTriangles.fill(index - content.batches[smallBatch].first, first, first + length)
    }

    /** Shades the waiting fragments of faces. */
    private fun flush() {
        if (waiting.size == 0) return
        waiting.locate(keys.columnStart, keys.rowStart)
        shade(waiting, shader!!)
    }

    /** Computes the attributes of the waiting fragments of small triangles, and shades these fragments. */
    private fun flushSmall() {
        if (waitingSmall.size == 0) return
        val setUp = faces.setUp(smallBatch)
        waitingSmall.locate(keys.columnStart, keys.rowStart)
        scattered.fill(waitingSmall.batch, content.triangleBatch(smallBatch), smallTriangles, setUp)
        shade(waitingSmall, setUp.shader)
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
            alone.place(0, x, y, 1)
            face.attributes(alone, 0, x, y, 1)
            alone.moveTo(fragment, 0)
            face.shader.shade(fragment)
        }
        return fragment
    }

    private companion object {
        /** Fewest samples for which it is worthwhile to load a triangle's face. */
        const val FEW = 4
    }
}
