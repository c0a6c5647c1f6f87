package dev.lazyz.strategies.bsp

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.endIfInterrupted
import dev.lazyz.requireInMemory
import dev.lazyz.setup.triangleBatch
import java.io.IOException

/**
 * Front to back, in an order that a tree of planes decides once for each scene: list priority.
 *
 * The triangles of opaque meshes are divided by planes into a binary tree, which does not depend on the camera. For
 * each frame, the tree yields them from front to back: at each plane, first the camera's side. A sample that is covered
 * stays as it is, and no depths are compared where the tree decides. Where it does not (a triangle that a plane cuts,
 * vertices that snapping moves across a plane, other primitives), depths are compared at the sample.
 *
 * Use it to learn, and to see how many depths need not be compared. The tree is made with the first frame and kept as
 * long as the arrays of the meshes, unless memory is needed.
 *
 * Memory: 4 bytes a sample, as much again in frames with translucent primitives, and 12 to 24 for each translucent
 * fragment before what is opaque; about 43 bytes for each triangle of a mesh, 4 for any other primitive. Time: the
 * fragments; for n triangles O(n) for a frame, if most are far from most planes, and O(n log n) once for a scene.
 * Thread safe; no state between calls except the trees.
 *
 * Sources: see [ListPriority].
 *
 * @param options only [RenderOptions.coherence] is used
 */
public class BspRenderer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    init {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "bsp"

    override val summary: String get() = "front to back by a tree of planes, compares samples where it does not decide"

    override val capabilities: Set<Capability>
        get() = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.TRANSPARENCY, Capability.COHERENCE)

    override fun configured(options: RenderOptions): Renderer = BspRenderer(options)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireInMemory(frame, this)
        val counters = Counters.Builder()
        counters.primitives = frame.primitives.size.toLong()
        val content = frame.content
        content.makePrimitives(Checkpoint.CALLER)
        val samples = OwnedSamples(frame, options.coherence, counters)

        // First the meshes by the tree, then what it does not decide, then what is translucent
        val all = DrawnRanges(1).apply { add(0, Int.MAX_VALUE) }
        val batches = content.batches.indices.map { content.triangleBatch(it) }.filter { it.count > 0 }
        if (batches.isNotEmpty()) {
            val priority = ListPriority(frame, batches, samples)
            priority.draw()
            for (index in priority.steep) samples.draw(index, all)
            counters.peakBytes = priority.bytes
        }
        for ((number, primitive) in content.singles.withIndex()) {
            endIfInterrupted()
            if (!primitive.isTranslucent) samples.draw(content.index(number), all)
        }
        for ((number, primitive) in content.singles.withIndex()) {
            endIfInterrupted()
            if (primitive.isTranslucent) samples.drawLayer(content.index(number), all)
        }
        samples.finish(sink)
        counters.peakBytes += samples.bytes
        return counters.build()
    }

    override fun toString(): String = "BspRenderer($options)"
}
