package dev.lazyz.tiled

import dev.lazyz.BatchShader
import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.FragmentBatch
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Shader
import dev.lazyz.setup.Face
import dev.lazyz.setup.LateShading

/**
 * Computes the colours of one tile, now that it is known what is visible: those of flat primitives many at a time,
 * others one by one. Belongs to one thread; used for tile after tile.
 *
 * Neighbours on a row that show the same primitive are a run: what is known of the primitive is fetched once. Runs are
 * gathered, over rows, until the shader or the attributes change or the batch is full.
 */
internal class TileShading(
    private val frame: Frame,
    private val keys: TileKeys,
    private val layers: TileLayers,
    coherence: Coherence,
    private val kernel: FragmentKernel,
    private val counters: Counters,
    private val checkpoint: Checkpoint,
) {
    private val content = frame.content
    private val test = frame.raster.depthTest

    /** What turns the upper half of a key into a depth: all its bits, where the greatest wins; see [DepthTest.depthOf]. */
    private val depthTurn = test.depthOf(0)
    private val background = frame.raster.background.toArgb()
    private val single = LateShading(frame, coherence, counters)
    private val firstColumn = frame.region.columnStart

    /** None where attributes are stepped along rows. */
    private val faces = FaceCache(content, coherence != Coherence.INCREMENTAL)
    private val packed = IntArray(FragmentBatch.CAPACITY + FragmentBatch.SPARE)

    /** Runs that wait for their colour, all of one shader and the same attributes, which are known. */
    private val runs = FragmentRuns()
    private var shader: Shader? = null

    /** Runs so short that it is not worth to know all of their primitives; their triangles of batch number [shortBatch]. */
    private val shortRuns = FragmentRuns()
    private val shortTriangles = IntArray(FragmentBatch.CAPACITY)
    private var shortBatch = -1
    private val scattered = ScatteredAttributes()
    private var isFine = false

    private val alone = FragmentBatch(1)
    private val fragment = Fragment()
    private lateinit var band: Band

    /** Bytes held at most. */
    val bytes: Long
        get() = runs.bytes + shortRuns.bytes + Int.SIZE_BYTES * (packed.size + shortTriangles.size.toLong()) +
            scattered.bytes + faces.bytes + single.peakBytes

    /**
     * Fills in colour, depth and primitive of the tile in [band].
     *
     * @param isFine whether most triangles are thought to be so small that they are met once; this is for speed only
     */
    fun shade(band: Band, isFine: Boolean) {
        this.band = band
        this.isFine = isFine
        val shadedBefore = counters.shadingCalls
        for (y in keys.rowStart until keys.rowEnd) {
            checkpoint.pass()
            single.beginRow()
            if (layers.isEmpty) shadeRow(y) else blendRow(y)
        }
        flush()
        flushShort()
        counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
    }

    /** Fills in background at all samples of a tile, the columns [columnStart] until [columnEnd] of [band]. */
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
            val index = test.indexOf(all[first + at])
            val end = kernel.runEnd(all, first + at, first + width) - first
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
        if (until - from < SHORT && gatherShort(from, until, y, row, index)) return
        val face = faces.face(index)
        if (face == null) {
            val primitive = primitive(index)
            for (x in from until until) {
                colors[x - firstColumn] = single.shaded(x, y, index, primitive).toArgb()
            }
            return
        }
        count(until - from)
        if (face.isConstant) {
            colors.fill(face.argb, from - firstColumn, until - firstColumn)
        } else {
            gather(face, from, until, y, row)
        }
    }

    /** Counts the calls of a shader. */
    private fun count(calls: Int) {
        counters.shadingCalls += calls
        counters.shadingStarts += calls
    }

    /** Adds a run of a face to those that wait. */
    private fun gather(face: Face, from: Int, until: Int, y: Int, row: Int) {
        if (face.shader !== shader || face.fields != runs.fragments.fields) {
            flush()
            shader = face.shader
            runs.fragments.begin(face.fields)
        }
        var x = from
        while (x < until) {
            if (runs.room == 0) flush()
            val at = runs.fragments.size
            val count = minOf(until - x, runs.room)
            runs.fragments.place(at, x, y, count)
            kernel.attributes(face, runs.fragments, at, x, y, count)
            runs.add(row, x - firstColumn, count)
            x += count
        }
    }

    /** Adds a short run to those that wait, or returns false: if it is not a batch's, or is known already. */
    private fun gatherShort(from: Int, until: Int, y: Int, row: Int, index: Int): Boolean {
        if (!isFine || !faces.isUsed || faces.has(index)) return false
        val number = faces.batch(index)
        if (number < 0) return false
        val setUp = faces.setUp(number)
        val triangle = index - content.batches[number].first
        if (!setUp.isShared) return false
        val count = until - from
        if (number != shortBatch || count > shortRuns.room) {
            flushShort()
            shortBatch = number
            shortRuns.fragments.begin(setUp.fields)
        }
        val at = shortRuns.fragments.size
        shortRuns.fragments.place(at, from, y, count)
        shortTriangles.fill(triangle, at, at + count)
        shortRuns.add(row, from - firstColumn, count)
        count(count)
        return true
    }

    /** Shades the runs whose attributes are known. */
    private fun flush() {
        if (runs.fragments.size > 0) shade(runs, shader!!)
    }

    /** Finds the attributes of short runs, and shades them. */
    private fun flushShort() {
        if (shortRuns.fragments.size == 0) return
        val setUp = faces.setUp(shortBatch)
        scattered.fill(shortRuns.fragments, content.batches[shortBatch], shortTriangles, setUp)
        shade(shortRuns, setUp.shader)
    }

    private fun shade(runs: FragmentRuns, shader: Shader) {
        val fragments = runs.fragments
        if (shader is BatchShader) {
            fragments.alpha.fill(1f, 0, fragments.size)
            shader.shade(fragments)
        } else {
            fragments.shadeEach(shader)
        }
        kernel.pack(fragments, packed)
        runs.takeOut(packed, band.argb)
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

    /** Returns the colour of a sample at which a translucent primitive is in front of what is [opaque]. */
    private fun blend(x: Int, y: Int, opaque: Long): Int {
        val backdrop = if (test.indexOf(opaque) == DepthTest.BACKGROUND) null else opaque
        return layers.blend(keys.place(x, y), backdrop, frame.raster.background) { key ->
            shaded(x, y, test.indexOf(key))
        }
    }

    /** Returns a fragment with the colour of the primitive [index], not packed. */
    private fun shaded(x: Int, y: Int, index: Int): Fragment {
        val face = faces.face(index) ?: return single.shaded(x, y, index, primitive(index))
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
        /** Samples from which on a run is not short. */
        const val SHORT = 4
    }
}
