package dev.lazyz.conformance.broken.gallery

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.conformance.broken.BrokenFailures
import dev.lazyz.conformance.broken.BrokenPromises
import dev.lazyz.conformance.broken.BrokenRenderer
import dev.lazyz.conformance.broken.BrokenReuse
import dev.lazyz.conformance.broken.gallery.RuleNames.arrivals
import dev.lazyz.conformance.broken.gallery.RuleNames.heap
import dev.lazyz.conformance.broken.gallery.RuleNames.held
import dev.lazyz.conformance.broken.gallery.RuleNames.kept
import dev.lazyz.conformance.broken.gallery.RuleNames.memory
import dev.lazyz.strategies.hybrid.Hybrid
import dev.lazyz.strategies.zbuffer.ZBuffer

/** The gallery's part about memory that is held but not reported. All counters are correct. */
internal object MemoryGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(
            ::wholePicture,
            "promises constant memory, but holds the picture and reports the memory of a row",
            memory,
        ),
        Mutant(::storesPrimitives, "promises to stream primitives, but stores each in a list", arrivals),
        Mutant(BrokenPromises::reportsAByte, "reports one byte, whatever it holds", held),
        Mutant(::reportsTheBudgetAsKept, "ignores the memory budget, but reports that it is kept", heap),
        Mutant(
            BrokenPromises::holdsTheImageTwice,
            "promises to stay within a budget, but holds the image twice, with any budget",
            heap, RuleNames.budget,
        ),
        Mutant(BrokenReuse::keepsHeavyPrimitives, "keeps all primitives that come one by one, in any budget", heap),
        Mutant(BrokenFailures::leavesTasks, "leaves the executor a task that keeps the frame", kept),
        Mutant(::keepsTheLastFrame, "keeps the last frame until the next one comes", kept),
        Mutant(::keepsFailedFrames, "keeps frames that could not be rendered", kept),
    )

    private fun wholePicture() = BrokenRenderer("whole-picture", setOf(Capability.CONSTANT_MEMORY)) { frame, sink ->
        ZBuffer().render(frame, sink).toBuilder().apply { peakBytes = 12L * frame.width }.build()
    }

    private fun storesPrimitives() =
        BrokenRenderer("stores-primitives", setOf(Capability.STREAMS_PRIMITIVES)) { frame, sink ->
            val hoard = ArrayList<Primitive>()
            ZBuffer().render(frame.heard { hoard.add(it) }, sink).also { hoard.clear() }
        }

    /** Returns the frame with primitives that are passed to [hear] one by one. */
    private fun Frame.heard(hear: (Primitive) -> Unit): Frame {
        val primitives = object : AbstractList<Primitive>() {
            override val size: Int get() = this@heard.primitives.size

            override fun get(index: Int): Primitive = this@heard.primitives[index].also(hear)
        }
        return Frame(raster, primitives, region)
    }

    private fun reportsTheBudgetAsKept(): BrokenRenderer = reportsTheBudgetAsKept(RenderOptions())

    private fun reportsTheBudgetAsKept(options: RenderOptions): BrokenRenderer = BrokenRenderer(
        "reports-the-budget-as-kept",
        setOf(Capability.MEMORY_BUDGET),
        { reportsTheBudgetAsKept(it) },
    ) { frame, sink ->
        val image = Hybrid(RenderOptions(memoryBudget = 0)).render(Frame(frame.raster, emptyList(), frame.region))
        val most = image.counters.peakBytes + (options.memoryBudget ?: Long.MAX_VALUE / 2)
        Hybrid().render(frame, sink).toBuilder().apply { peakBytes = minOf(peakBytes, most) }.build()
    }

    private fun keepsTheLastFrame(): BrokenRenderer {
        val last = arrayOfNulls<Frame>(1)
        return BrokenRenderer("keeps-the-last-frame") { frame, sink ->
            last[0] = frame
            ZBuffer().render(frame, sink)
        }
    }

    private fun keepsFailedFrames(): BrokenRenderer {
        val failed = ArrayList<Frame>()
        return BrokenRenderer("keeps-failed-frames") { frame, sink ->
            failed.add(frame)
            ZBuffer().render(frame, sink).also { failed.remove(frame) }
        }
    }
}
