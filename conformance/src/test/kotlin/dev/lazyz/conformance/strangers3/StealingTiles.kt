package dev.lazyz.conformance.strangers3

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink

/** Tiles of a band, shared by a crew of threads that steal from each other; translucent fragments in linked lists. */
internal class StealingTiles(options: RenderOptions = RenderOptions(), mistake: Mistake? = null) :
    Third("tiles", options, mistake) {
    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.PARALLEL, Capability.TRANSPARENCY, Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY,
        )

    override fun configured(options: RenderOptions): Renderer = StealingTiles(options.requireSupportedBy(this), mistake)

    override fun render(frame: Frame, sink: RowSink): Counters = Rendering(frame, sink).run()

    private inner class Rendering(private val frame: Frame, private val sink: RowSink) {
        private val region = frame.region
        private val side = options.tileSize
        private val across = (region.width + side - 1) / side
        private val threads =
            if (mistake == Mistake.TILES_ALL_CORES) maxOf(2, CORES) else minOf(options.threads, MOST_THREADS)

        /** As many rows of tiles as give each thread two. */
        private val down =
            if (mistake == Mistake.TILES_ONE_ROW) 1 else maxOf(1, (2 * threads + across - 1) / across)
        private val bandRows = minOf(side.toLong() * down, region.height.toLong()).toInt()
        private val argb = IntArray(bandRows * region.width)
        private val depth = IntArray(bandRows * region.width)
        private val index = IntArray(bandRows * region.width)
        private val row = OutRow(frame)
        private val entries = arrivals(frame)
        private var entered = 0
        private val alive = ArrayList<Int>()
        private var mostAlive = 0
        private val shared = Fragment()
        private val scratches = List(threads) {
            TileScratch(side, if (mistake == Mistake.TILES_SHARED_FRAGMENT) shared else Fragment(), mistake)
        }
        private val crew = Crew(threads, mistake) { worker, tile -> draw(worker, tile) }
        private var top = region.rowStart

        @Volatile
        private var present = IntArray(0)

        fun run(): Counters {
            if (mistake == Mistake.TILES_THREAD_LOCAL) kept.set(frame)
            crew.start()
            if (mistake == Mistake.TILES_LEAK_ON_THROW) {
                bands()
                crew.close()
            } else {
                try {
                    bands()
                } finally {
                    crew.close()
                }
            }
            return counters()
        }

        private fun bands() {
            while (top < region.rowEnd) {
                val end = minOf(top + bandRows, region.rowEnd)
                while (entered < entries.size && (entries[entered] ushr 32) < end) alive += entries[entered++].toInt()
                mostAlive = maxOf(mostAlive, alive.size)
                present = alive.toIntArray()
                crew.run(across * ((end - top + side - 1) / side))
                for (y in top until end) hand(y)
                alive.removeIf { frame.primitives[it].rowEnd <= end }
                top = end
            }
        }

        private fun draw(worker: Int, tile: Int) {
            val left = region.columnStart + tile % across * side
            val upper = top + tile / across * side
            val right = minOf(left + side, region.columnEnd)
            val lower = minOf(upper + side, region.rowEnd)
            val scratch = scratches[worker]
            scratch.begin(frame, left, upper, right, lower)
            for (i in present) {
                if (crew.isStopped) return
                scratch.draw(i)
            }
            scratch.finish { x, y, color, z, primitive ->
                val at = (y - top) * region.width + x - region.columnStart
                argb[at] = color
                depth[at] = z
                index[at] = primitive
            }
        }

        private fun hand(y: Int) {
            val from = (y - top) * region.width
            argb.copyInto(row.argb, 0, from, from + region.width)
            depth.copyInto(row.depth, 0, from, from + region.width)
            index.copyInto(row.primitive, 0, from, from + region.width)
            row.send(y, sink)
        }

        private fun counters(): Counters {
            val sum = Counters.Builder()
            for (scratch in scratches) sum.add(scratch.counters.build())
            sum.primitives = frame.primitives.size.toLong()
            sum.peakBytes = 12L * argb.size + row.bytes + 8L * entries.size + 20L * mostAlive +
                scratches.sumOf { it.bytes }
            return sum.build()
        }
    }

    private companion object {
        const val MOST_THREADS = 16
        val CORES = Runtime.getRuntime().availableProcessors()

        /** What a thread rendered last, for one mistake only. */
        val kept = ThreadLocal<Frame>()
    }
}
