package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.bytes
import dev.lazyz.setup.triangleBatch
import dev.lazyz.shading.LateShading
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.tiled.binning.Band
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/**
 * Computes the colours of one tile after the visible primitives are known: many samples at a time for flat primitives,
 * one by one for others. Belongs to one thread; reused for each tile.
 *
 * The data of a flat primitive is loaded once for all its samples of the tile. Samples are collected, primitive after
 * primitive, until the shader or the attributes change or the batch is full. For primitives with very few samples, this
 * data is not loaded at all.
 */
internal class TileShading(
    private val frame: Frame,
    private val keys: VisibilityBuffer,
    private val layers: TileLayers,
    coherence: Coherence,
    private val kernel: FragmentKernel,
    private val counters: Counters.Builder,
    private val checkpoint: Checkpoint,
) {
    private val content = frame.content
    private val test = frame.raster.depthTest

    /**
     * Converts the upper half of a key into a depth: all bits set where the greatest depth wins; see
     * [DepthTest.depthOf].
     */
    private val depthTurn = test.depthOf(0)
    private val background = frame.raster.background.toArgb()
    private val single = LateShading(frame, coherence, counters, checkpoint)
    private val firstColumn = frame.region.columnStart

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

    private val alone = FragmentBatch(1)
    private val fragment = Fragment()
    private lateinit var band: Band

    /** Peak number of bytes held. */
    val bytes: Long
        get() = runs.bytes + waiting.bytes + waitingSmall.bytes + scattered.bytes + faces.bytes + single.peakBytes +
            packed.bytes + smallTriangles.bytes

    /**
     * Fills in colour, depth and primitive of the tile in [band].
     *
     * @param isFine whether most triangles are probably so small that they have one run only; affects only the speed
     */
    fun shade(band: Band, isFine: Boolean) {
        this.band = band
        this.isFine = isFine
        runs.begin()
        val shadedBefore = counters.shadingCalls
        for (y in keys.rowStart until keys.rowEnd) {
            checkpoint.pass()
            single.beginRow()
            if (layers.isEmpty) shadeRow(y) else blendRow(y)
        }
        for (number in 0 until runs.count) shadeAll(number)
        flush()
        flushSmall()
        counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
    }

    /** Fills a tile with background: the columns [columnStart] until [columnEnd] of [band]. */
    fun clear(band: Band, columnStart: Int, columnEnd: Int) {
        for (row in 0 until band.rowEnd - band.rowStart) {
            band.argb[row].fill(background, columnStart - firstColumn, columnEnd - firstColumn)
            band.depth[row].fill(frame.raster.backgroundDepth, columnStart - firstColumn, columnEnd - firstColumn)
            band.primitive[row].fill(DepthTest.BACKGROUND, columnStart - firstColumn, columnEnd - firstColumn)
        }
    }

    private fun shadeRow(y: Int) {
        val row = y - keys.rowStart
        val all = keys.keys
        val first = keys.place(keys.columnStart, y)
        val width = keys.columnEnd - keys.columnStart
        val toColumn = keys.columnStart - firstColumn
        val depths = band.depth[row]
        for (i in 0 until width) depths[toColumn + i] = (all[first + i] ushr Int.SIZE_BITS).toInt() xor depthTurn
        val indices = band.primitive[row]
        var at = 0
        while (at < width) {
            val end = kernel.runEnd(all, first + at, first + width) - first
            val index = test.indexOf(all[first + at])
            for (i in at until end) indices[toColumn + i] = index
            shadeRun(keys.columnStart + at, keys.columnStart + end, y, row, index)
            at = end
        }
    }

    /** Computes the colours of the samples [from] until [until] of row [y], all of the primitive [index]. */
    private fun shadeRun(from: Int, until: Int, y: Int, row: Int, index: Int) {
        val colors = band.argb[row]
        if (index == DepthTest.BACKGROUND) {
            colors.fill(background, from - firstColumn, until - firstColumn)
            return
        }
        var number = runs.find(index)
        if (number == PrimitiveRuns.NONE) {
            if (isFine && until - from < FEW && canGatherSmall(index, until - from)) {
                count(until - from)
                return gatherSmall(index, PrimitiveRuns.place(row, from - keys.columnStart), until - from)
            }
            number = note(index)
        }
        when (number) {
            PrimitiveRuns.ONE_BY_ONE -> {
                val primitive = primitive(index)
                for (x in from until until) colors[x - firstColumn] = single.shaded(x, y, index, primitive).toArgb()
            }
            PrimitiveRuns.CONSTANT -> {
                count(until - from)
                colors.fill(runs.color(index), from - firstColumn, until - firstColumn)
            }
            else -> {
                count(until - from)
                runs.add(number, PrimitiveRuns.place(row, from - keys.columnStart), until - from)
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
            return runs.forEach(number) { start, length -> gatherSmall(index, start, length) }
        }
        val face = faces.face(index)!!
        if (face.isConstant) fill(number, face.argb) else gather(number, face)
    }

    private fun fill(number: Int, argb: Int) {
        val tileColumn = keys.columnStart - firstColumn
        runs.forEach(number) { start, length ->
            val column = tileColumn + PrimitiveRuns.column(start)
            band.argb[PrimitiveRuns.row(start)].fill(argb, column, column + length)
        }
    }

    /** Adds the samples of a face to those waiting. */
    private fun gather(number: Int, face: Face) {
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
                    kernel.attributes(face, waiting, first, keys.columnStart, keys.rowStart)
                    flush()
                    first = 0
                }
                val count = minOf(length - done, waiting.room)
                waiting.add(start + done, count)
                done += count
            }
        }
        kernel.attributes(face, waiting, first, keys.columnStart, keys.rowStart)
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
    private fun gatherSmall(index: Int, start: Int, length: Int) {
        val first = waitingSmall.size
        waitingSmall.add(start, length)
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
        fragments.takeOut(packed, band.argb, keys.columnStart - firstColumn)
    }

    /** Returns the primitive [index], which has no face. */
    private fun primitive(index: Int): Primitive =
        if (faces.isUsed) content.single(index) else frame.primitives[index]

    private fun blendRow(y: Int) {
        val row = y - keys.rowStart
        val colors = band.argb[row]
        val depths = band.depth[row]
        val indices = band.primitive[row]
        for (x in keys.columnStart until keys.columnEnd) {
            val opaque = keys.at(x, y)
            val key = layers.nearest(keys.place(x, y), opaque)
            val index = test.indexOf(key)
            depths[x - firstColumn] = test.depthOf(key)
            indices[x - firstColumn] = index
            if (key == opaque) shadeRun(x, x + 1, y, row, index) else colors[x - firstColumn] = blend(x, y, opaque)
        }
    }

    /** Returns the colour of a sample at which a translucent primitive is before the [opaque] one. */
    private fun blend(x: Int, y: Int, opaque: Long): Int {
        val backdrop = if (test.indexOf(opaque) == DepthTest.BACKGROUND) null else opaque
        return layers.blend(keys.place(x, y), backdrop, frame.raster.background) { key ->
            shaded(x, y, test.indexOf(key))
        }
    }

    /** Returns a fragment with the colour of the primitive [index], not packed. */
    private fun shaded(x: Int, y: Int, index: Int): Fragment {
        val face = faces.face(index) ?: return single.shaded(x, y, index, primitive(index))
        checkpoint.pass()
        count(1)
        if (face.isConstant) {
            face.shadeConstant(fragment)
        } else {
            alone.begin(face.fields)
            alone.place(0, x, y, 1)
            face.attributes(alone, 0, x, y)
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
