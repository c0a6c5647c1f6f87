package dev.lazyz.tiled

import dev.lazyz.BatchShader
import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.FragmentBatch
import dev.lazyz.Frame
import dev.lazyz.Shader
import dev.lazyz.Srgb
import dev.lazyz.setup.BatchFace
import dev.lazyz.setup.LateShading
import dev.lazyz.setup.PlanarSetUp
import dev.lazyz.setup.TriangleBatch

/**
 * Computes the colours of one tile, now that it is known what is visible: those of batches' triangles many at a time,
 * others one by one. Belongs to one thread; used for tile after tile.
 *
 * Neighbours on a row that show the same triangle are a run: what is known of the triangle is fetched once. Runs are
 * gathered, over rows, until the shader or the attributes change or the batch is full.
 */
internal class TileShading(
    private val frame: Frame,
    private val keys: TileKeys,
    private val layers: TileLayers,
    private val coherence: Coherence,
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

    /** Triangles lately seen, by the lower bits of their indices: a triangle is met again on the next row. */
    private val faces = arrayOfNulls<BatchFace>(if (content.batches.isEmpty()) 0 else FACES)

    /** What shades the triangles of each batch, made when it is first met. */
    private val faceSetUps = arrayOfNulls<PlanarSetUp.FaceSetUp>(content.batches.size)
    private var lastBatch: TriangleBatch? = null
    private var lastSetUp: PlanarSetUp.FaceSetUp? = null

    private val fragments = FragmentBatch(if (content.batches.isEmpty()) 1 else FragmentBatch.CAPACITY)
    private val fragment = Fragment()
    private var shader: Shader? = null
    private lateinit var band: Band

    /** Bytes held at most. */
    val bytes: Long get() = fragments.bytes + faces.size * FACE_BYTES + single.peakBytes

    /** Fills in colour, depth and primitive of the tile in [band]. */
    fun shade(band: Band) {
        this.band = band
        val shadedBefore = counters.shadingCalls
        for (y in keys.rowStart until keys.rowEnd) {
            checkpoint.pass()
            single.beginRow()
            if (layers.isEmpty) shadeRow(y) else blendRow(y)
        }
        flush()
        counters.peakSuspensions = maxOf(counters.peakSuspensions, counters.shadingCalls - shadedBefore)
    }

    private fun shadeRow(y: Int) {
        val row = y - keys.rowStart
        val depths = band.depth[row]
        val indices = band.primitive[row]
        val all = keys.keys
        val last = keys.place(keys.columnEnd - 1, y)
        val toColumn = keys.columnStart - keys.place(keys.columnStart, y)
        var at = keys.place(keys.columnStart, y)
        while (at <= last) {
            val rank = all[at].toInt()
            val index = test.indexOf(all[at])
            val start = at
            do {
                depths[toColumn + at - firstColumn] = (all[at] ushr Int.SIZE_BITS).toInt() xor depthTurn
                at++
            } while (at <= last && all[at].toInt() == rank)
            indices.fill(index, toColumn + start - firstColumn, toColumn + at - firstColumn)
            shadeRun(toColumn + start, toColumn + at, y, row, index)
        }
    }

    /** Computes the colours of the samples [from] until [until] of row [y], all of the primitive [index]. */
    private fun shadeRun(from: Int, until: Int, y: Int, row: Int, index: Int) {
        val colors = band.argb[row]
        if (index == DepthTest.BACKGROUND) {
            colors.fill(background, from - firstColumn, until - firstColumn)
            return
        }
        val face = if (coherence == Coherence.INCREMENTAL) null else face(index)
        if (face == null) {
            val primitive = if (coherence == Coherence.INCREMENTAL) frame.primitives[index] else content.single(index)
            for (x in from until until) {
                colors[x - firstColumn] = single.shaded(x, y, index, primitive).toArgb()
            }
            return
        }
        counters.shadingCalls += until - from
        counters.shadingStarts += until - from
        val shader = face.shader
        if (face.isConstant) {
            colors.fill(face.argb, from - firstColumn, until - firstColumn)
        } else if (shader is BatchShader) {
            gather(face, shader, from, until, y)
        } else {
            shadeOneByOne(face, shader, from, until, y, colors)
        }
    }

    /** Adds a run to the batch. */
    private fun gather(face: BatchFace, shader: BatchShader, from: Int, until: Int, y: Int) {
        if (shader !== this.shader || face.fields != fragments.fields) {
            flush()
            this.shader = shader
            fragments.begin(face.fields)
        }
        var x = from
        while (x < until) {
            if (fragments.size == FragmentBatch.CAPACITY) flush()
            val at = fragments.size
            val count = minOf(until - x, FragmentBatch.CAPACITY - at)
            for (i in 0 until count) {
                fragments.x[at + i] = x + i
                fragments.y[at + i] = y
            }
            face.attributes(fragments, at, x, y, count)
            fragments.size = at + count
            x += count
        }
    }

    /** Shades what has been gathered. */
    private fun flush() {
        val count = fragments.size
        if (count == 0) return
        fragments.alpha.fill(1f, 0, count)
        (shader as BatchShader).shade(fragments)
        for (i in 0 until count) {
            band.argb[fragments.y[i] - keys.rowStart][fragments.x[i] - firstColumn] =
                Srgb.pack(fragments.red[i], fragments.green[i], fragments.blue[i], fragments.alpha[i])
        }
        fragments.size = 0
    }

    /** For shaders that know no batches. */
    private fun shadeOneByOne(face: BatchFace, shader: Shader, from: Int, until: Int, y: Int, colors: IntArray) {
        flush()
        this.shader = null
        fragments.begin(face.fields)
        var x = from
        while (x < until) {
            val count = minOf(until - x, FragmentBatch.CAPACITY)
            face.attributes(fragments, 0, x, y, count)
            for (i in 0 until count) {
                fragments.moveTo(fragment, i, x + i, y)
                shader.shade(fragment)
                colors[x + i - firstColumn] = fragment.toArgb()
            }
            x += count
        }
    }

    /** Returns what is known of the triangle [index], or null if it is in no batch. */
    private fun face(index: Int): BatchFace? {
        if (faces.isEmpty()) return null
        val slot = index and FACES - 1
        val known = faces[slot]
        if (known != null && known.index == index) return known
        val batch = batch(index) ?: return null
        val face = known ?: BatchFace().also { faces[slot] = it }
        face.fill(batch, index - batch.first, lastSetUp!!, fragment)
        return face
    }

    private fun batch(index: Int): TriangleBatch? {
        val last = lastBatch
        if (last != null && index >= last.first && index < last.first + last.count &&
            last.isDrawn(index - last.first)
        ) {
            return last
        }
        val batch = content.batch(index) ?: return null
        val number = content.batches.indexOf(batch)
        lastBatch = batch
        lastSetUp = faceSetUps[number] ?: batch.faces().also { faceSetUps[number] = it }
        return batch
    }

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
        val face = if (coherence == Coherence.INCREMENTAL) null else face(index)
        if (face == null) {
            val primitive = if (coherence == Coherence.INCREMENTAL) frame.primitives[index] else content.single(index)
            return single.shaded(x, y, index, primitive)
        }
        counters.shadingCalls++
        counters.shadingStarts++
        flush()
        shader = null
        fragments.begin(face.fields)
        face.attributes(fragments, 0, x, y, 1)
        fragments.moveTo(fragment, 0, x, y)
        face.shader.shade(fragment)
        return fragment
    }

    private companion object {
        /** Triangles that are remembered, a power of two. */
        const val FACES = 64

        /** Two objects, one of 22 fields, and 48 numbers. */
        const val FACE_BYTES = 2 * 16L + 22 * 8L + 16L + 48 * 8L
    }
}
