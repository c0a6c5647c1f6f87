package dev.lazyz

import dev.lazyz.spi.Fragment

/**
 * The content of a frame: batches of primitives, and single primitives; or, if the frame is streamed, [parts] of it.
 * Immutable and thread safe.
 *
 * @property size number of primitives, including those in batches
 * @property batches in ascending order of their submission indices
 * @property singles in submission order: the primitives that are in no batch, and the exceptions of the batches
 * @property view what is known about the scene
 * @property parts all primitives of a streamed frame, which has neither batches nor singles; null if they are in memory
 * @property shading where the primitives of batches are shaded; null for at their samples. Singles know it themselves
 */
internal class FrameContent private constructor(
    val size: Int,
    val batches: List<PrimitiveBatch>,
    val singles: List<Primitive>,
    private val indices: IntArray?,
    val view: FrameView,
    val parts: FrameParts? = null,
    val shading: PrimitiveShading? = null,
) {
    /** Returns the submission index of `singles[number]`. */
    fun index(number: Int): Int = if (indices == null) number else indices[number]

    /** Whether any primitive is translucent. Primitives in batches are opaque. */
    val hasTranslucency: Boolean by lazy { parts?.hasTranslucency ?: singles.any { it.isTranslucent } }

    /**
     * All primitives by submission index. Those in batches become objects when the first element is accessed. Those of
     * a streamed frame can only be iterated.
     */
    val primitives: List<Primitive> = parts?.primitives() ?: if (batches.isEmpty()) singles else AllPrimitives()

    /**
     * Makes the objects of the primitives in batches, unless they are there. Passes [checkpoint] for each of them, and
     * if it ends the work, keeps none.
     */
    fun makePrimitives(checkpoint: Checkpoint) {
        (primitives as? AllPrimitives)?.make(checkpoint)
    }

    /** Returns the primitive with submission index [index], without making objects of the others. */
    fun primitive(index: Int): Primitive {
        val part = parts?.first { index - it.first in 0 until it.size } ?: return reader()(index)
        return part.content().primitive(index - part.first)
    }

    /** Returns the single primitive with submission index [index]; there must be one. */
    fun single(index: Int): Primitive =
        singles[if (indices == null) index else java.util.Arrays.binarySearch(indices, index)]

    /** Returns the number in [batches] of the batch that draws the primitive with submission index [index], or -1. */
    fun batchNumber(index: Int): Int {
        var low = 0
        var high = batches.size
        while (low < high) {
            val middle = (low + high) ushr 1
            if (batches[middle].first <= index) low = middle + 1 else high = middle
        }
        if (low == 0) return -1
        val batch = batches[low - 1]
        val triangle = index - batch.first
        return if (triangle < batch.count && batch.isDrawn(triangle)) low - 1 else -1
    }

    /** Returns this content with opaque primitives, see [Frame.asOpaque]. Those in batches are opaque already. */
    fun asOpaque(): FrameContent = if (parts != null) {
        streamed(parts.map(hasTranslucency = false) { it.content().asOpaque() }, view)
    } else {
        FrameContent(size, batches, singles.map { it.asOpaque() }, indices, view, shading = shading)
    }

    /** Returns this content, whose primitives are shaded where [shading] says. */
    fun shadedAt(shading: PrimitiveShading): FrameContent = if (parts != null) {
        streamed(parts.map { it.content().shadedAt(shading) }, view)
    } else {
        FrameContent(size, batches, singles.map { shading.of(it) }, indices, view, shading = shading)
    }

    /** Returns a function that returns a primitive of the batch with this [number], given its number there. */
    private fun reader(number: Int): (Int) -> Primitive {
        val read = batches[number].reader()
        return if (shading == null) read else { it -> shading.of(read(it)) }
    }

    /** Returns this content without batches, with each primitive replaced by the result of [change] for its index. */
    fun withAll(change: (Int, Primitive) -> Primitive): FrameContent = if (parts != null) {
        val changed = parts.map { part ->
            part.content().withAll { number, primitive -> change(part.first + number, primitive) }
        }
        streamed(changed, view)
    } else {
        of(primitives.mapIndexed(change), view)
    }

    /** Returns this content without colours, see [Frame.unshaded]. */
    fun unshaded(): FrameContent = if (parts != null) {
        streamed(parts.map { it.content().unshaded() }, view)
    } else {
        FrameContent(size, batches.map { it.unshaded() }, singles.map { UnshadedPrimitive(it) }, indices, view)
    }

    /** Calls [action] for all primitives that can cover samples, in any order, without keeping objects of them. */
    fun forEachDrawn(action: (Primitive) -> Unit) {
        parts?.forEach { it.content().forEachDrawn(action) }
        for (batch in batches) {
            val read = batch.reader()
            for (number in 0 until batch.count) if (batch.isDrawn(number)) action(read(number))
        }
        singles.forEach(action)
    }

    /**
     * Returns a function that returns the primitive with a given submission index, without making objects of the
     * others; for one thread.
     */
    fun reader(): (index: Int) -> Primitive {
        val readers = arrayOfNulls<(Int) -> Primitive>(batches.size)
        return { index ->
            val number = batchNumber(index)
            if (number < 0) {
                single(index)
            } else {
                val reader = readers[number] ?: reader(number).also { readers[number] = it }
                reader(index - batches[number].first)
            }
        }
    }

    private inner class AllPrimitives : AbstractList<Primitive>() {
        @Volatile
        private var made: List<Primitive>? = null

        fun make(checkpoint: Checkpoint): List<Primitive> =
            made ?: synchronized(this) { made ?: all(checkpoint).also { made = it } }

        private fun all(checkpoint: Checkpoint): List<Primitive> {
            val all = ArrayList<Primitive>(this@FrameContent.size)
            var number = 0
            for (batch in batches) {
                while (all.size < batch.first) all.add(singles[number++])
                for (primitive in batch.primitives(checkpoint)) {
                    checkpoint.pass()
                    all.add(if (shading == null) primitive else shading.of(primitive))
                }
                while (number < singles.size && this@FrameContent.index(number) < all.size) number++
            }
            while (number < singles.size) all.add(singles[number++])
            return all
        }

        override val size: Int get() = this@FrameContent.size

        override fun get(index: Int): Primitive = make(Checkpoint.NONE)[index]
    }

    /** Builds the content of a frame in submission order. Not thread safe. */
    class Builder {
        private var size = 0
        private val batches = ArrayList<PrimitiveBatch>()
        private val singles = ArrayList<Primitive>()
        private var indices = IntArray(16)

        /** Submission index of the next primitive. */
        val next: Int get() = size

        /** Adds a primitive. */
        fun add(primitive: Primitive) {
            addSingle(primitive, size)
            size++
        }

        /** Adds a batch. Its first index must be [next]. */
        fun add(batch: PrimitiveBatch) {
            batches.add(batch)
            for ((triangle, primitive) in batch.exceptions) addSingle(primitive, batch.first + triangle)
            size += batch.count
        }

        private fun addSingle(primitive: Primitive, index: Int) {
            if (singles.size == indices.size) indices = indices.copyOf(2 * indices.size)
            indices[singles.size] = index
            singles.add(primitive)
        }

        /** Returns the content, seen as [view] says. */
        fun build(view: FrameView): FrameContent = if (batches.isEmpty()) {
            of(singles, view)
        } else {
            FrameContent(size, batches, singles, indices.copyOf(singles.size), view)
        }
    }

    companion object {
        /** Returns content that has the given primitives and no batches. */
        fun of(primitives: List<Primitive>, view: FrameView = NoView): FrameContent =
            FrameContent(primitives.size, emptyList(), primitives, null, view)

        /** Returns the content of a streamed frame. */
        fun streamed(parts: FrameParts, view: FrameView): FrameContent =
            FrameContent(parts.size, emptyList(), emptyList(), null, view, parts)
    }
}

/** Changes where primitives are shaded. Thread safe. */
internal fun interface PrimitiveShading {
    /** Returns [primitive], or one that covers the same and is shaded elsewhere. */
    fun of(primitive: Primitive): Primitive
}

/**
 * Consecutive primitives of a frame, stored together without an object for each. They are converted to single
 * primitives only for renderers that need them. Immutable and thread safe.
 */
internal interface PrimitiveBatch {
    /** Submission index of the first primitive. */
    val first: Int

    /** Number of primitives, including those that are not drawn from this batch. */
    val count: Int

    /** The primitives that must be drawn one by one, with their number in this batch. */
    val exceptions: List<IndexedValue<Primitive>>

    /** Whether primitive [number], 0 until [count], is drawn from this batch. */
    fun isDrawn(number: Int): Boolean

    /** Returns what primitive [number] may cover of [region]; null if it is nothing. */
    fun boundsIn(region: Region, number: Int): Region?

    /** Bounds of the depths of primitive [number], see [Primitive.leastDepth]. */
    fun leastDepth(number: Int): Int

    fun greatestDepth(number: Int): Int

    /** Returns a function that returns a primitive of the batch, given its number; for one thread. */
    fun reader(): (number: Int) -> Primitive

    /** Returns this batch with primitives whose colours are not computed. */
    fun unshaded(): PrimitiveBatch

    /**
     * Returns all primitives of the batch as single primitives. Passes [checkpoint] while it prepares for the first.
     */
    fun primitives(checkpoint: Checkpoint): Sequence<Primitive>
}

/**
 * The primitives of a frame in consecutive parts, for scenes that are larger than memory. A part is made when it is
 * needed, and not kept. Immutable; thread safe if the parts are.
 *
 * @property size number of primitives in all parts
 * @property hasTranslucency whether any primitive is translucent
 * @param parts returns the parts in order
 */
internal class FrameParts(val size: Int, val hasTranslucency: Boolean, private val parts: () -> Iterator<FramePart>) :
    Iterable<FramePart> {
    override fun iterator(): Iterator<FramePart> = parts()

    /** Returns these parts, each with its content replaced by the result of [change]. It must have the same size. */
    fun map(hasTranslucency: Boolean = this.hasTranslucency, change: (FramePart) -> FrameContent): FrameParts =
        FrameParts(size, hasTranslucency) {
            parts().asSequence().map { FramePart(it.first, it.size, it.reach) { change(it) } }.iterator()
        }

    /** The primitives of all parts as a list that can only be iterated. */
    fun primitives(): List<Primitive> = object : AbstractList<Primitive>() {
        override val size: Int get() = this@FrameParts.size

        override fun iterator(): Iterator<Primitive> =
            this@FrameParts.asSequence().flatMap { it.content().primitives.asSequence() }.iterator()

        override fun get(index: Int): Primitive = throw IllegalArgumentException(
            "the primitives of a streamed frame can only be iterated, not accessed by index: use 'tiled', 'zbuffer', " +
                "'hybrid' or 'hierarchical', or load the whole model",
        )
    }
}

/**
 * Consecutive primitives of a streamed frame.
 *
 * @property first submission index of the first primitive
 * @property size number of primitives
 * @property reach a rectangle outside of which they cover nothing, or null if it is not known; it may be empty
 * @param read makes the primitives, which takes time and memory. Thread safe
 */
internal class FramePart(val first: Int, val size: Int, val reach: Reach?, private val read: () -> FrameContent) {
    fun content(): FrameContent = read()
}

/** A rectangle of samples: columns [left] until [right], rows [top] until [bottom]. It may lie outside the raster. */
internal class Reach(private val left: Int, private val top: Int, private val right: Int, private val bottom: Int) {
    /** Returns the part of [region] that is in this rectangle, or null if there is none. */
    fun within(region: Region): Region? = region.intersect(left, top, right, bottom)
}

/** What a frame knows about the scene that it was set up from. Immutable and thread safe. */
internal interface FrameView {
    /** [distance] at the near plane. */
    val near: Double

    /** [distance] at the far plane. */
    val far: Double

    /** The point, in world space, that [Fragment.worldX], [Fragment.worldY] and [Fragment.worldZ] are relative to. */
    val originX: Double
    val originY: Double
    val originZ: Double

    /**
     * Returns the distance from the eye along the line of sight, world units, of what is at the fraction [unit] of the
     * range of depths: 0 at the near plane, 1 at the far plane.
     */
    fun distance(unit: Double): Double

    /**
     * Returns the distance from the eye along the line of sight, world units, of a position as [Fragment] has it,
     * relative to [originX], [originY] and [originZ]. NaN if the frame was not set up from a scene.
     */
    fun distance(x: Float, y: Float, z: Float): Double

    /** Returns the number of the surface, in the order of the scene, whose primitive has the submission [index]. */
    fun objectOf(index: Int): Int

    /** Returns the submission index of the first primitive of surface [number]. */
    fun firstOf(number: Int): Int

    /** The names of the surfaces, in the order of the scene; empty if the frame was not set up from one. */
    val objectNames: List<String>
}

/**
 * Returns the distance from the eye of the sample of [fragment], at which [primitive] is at the fraction [unit] of the
 * range of depths. Where the depth test uses a constant, it is that of the position, if there is one: the primitive may
 * be a sliver seen edge-on, whose true depth is not constant (contract rule 3.4).
 */
internal fun FrameView.distance(unit: Double, primitive: Primitive, fragment: Fragment): Double {
    val form = primitive.depthForm
    if (form == null || form.dx != 0L || form.dy != 0L) return distance(unit)
    fragment.worldX = Float.NaN
    primitive.geometry(fragment)
    val ofPosition = distance(fragment.worldX, fragment.worldY, fragment.worldZ)
    return if (ofPosition.isNaN()) distance(unit) else ofPosition
}

/** The view of a frame that was not set up from a scene: distances are fractions, and all primitives are one object. */
internal object NoView : FrameView {
    override val near: Double get() = 0.0
    override val far: Double get() = 1.0
    override val originX: Double get() = 0.0
    override val originY: Double get() = 0.0
    override val originZ: Double get() = 0.0

    override fun distance(unit: Double): Double = unit

    override fun distance(x: Float, y: Float, z: Float): Double = Double.NaN

    override fun objectOf(index: Int): Int = 0

    override fun firstOf(number: Int): Int = 0

    override val objectNames: List<String> get() = emptyList()
}
