package dev.lazyz.world

import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.FramePart
import dev.lazyz.FrameParts
import dev.lazyz.FrameView
import dev.lazyz.NoView
import dev.lazyz.geometry.Box
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.Surface

/**
 * From the [surfaces] of a scene to the content of a frame. Used once.
 */
internal class FrameAssembly(private val surfaces: List<Surface>, private val setUp: SetUp) {
    /** Submission index of the first primitive of each surface. */
    private val starts = IntArray(surfaces.size)

    /**
     * Returns the primitives of all surfaces in submission order; those of a scene with a [StreamedMesh] in parts, see
     * [Frame.isStreamed].
     *
     * @throws IllegalArgumentException if a streamed scene has 2^31-1 primitives or more
     */
    fun content(): FrameContent = if (surfaces.any { it is StreamedMesh }) streamed() else inMemory()

    private fun view(): FrameView = SceneView(setUp.camera, setUp.origin, starts, surfaces.map { it.name })

    private fun inMemory(): FrameContent {
        val content = FrameContent.Builder()
        for ((number, surface) in surfaces.withIndex()) {
            starts[number] = content.next
            content.add(surface)
        }
        return content.build(view())
    }

    private fun FrameContent.Builder.add(surface: Surface) {
        val batch = if (surface is Mesh) setUp.batch(surface, next) else null
        if (batch != null) return add(batch)
        for (primitive in surface.primitives(setUp)) {
            setUp.checkpoint.pass()
            add(primitive)
        }
    }

    private fun streamed(): FrameContent {
        val next = NextIndex()
        var hasTranslucency = false
        val parts = ArrayList<FramePart>()
        for ((number, surface) in surfaces.withIndex()) {
            starts[number] = next.index
            if (surface is StreamedMesh) {
                hasTranslucency = hasTranslucency || surface.isTranslucent
                for (pieces in surface.groups()) {
                    val size = pieces.sumOf { surface.source.triangleCount(it) }
                    val reach = BoxReach(setUp).of(pieces.mapNotNull { surface.bounds(it) }.reduceOrNull(Box::union))
                    parts += FramePart(next.take(size), size, reach) { part(surface.read(pieces)) }
                }
            } else {
                // Surfaces in memory are set up once
                val part = part(surface)
                hasTranslucency = hasTranslucency || part.hasTranslucency
                parts += FramePart(next.take(part.size), part.size, null) { part }
            }
        }
        return FrameContent.streamed(FrameParts(next.index, hasTranslucency) { parts.iterator() }, view())
    }

    private fun part(surface: Surface): FrameContent =
        FrameContent.Builder().apply { add(surface) }.build(NoView)

    /** Counts primitives. */
    private class NextIndex {
        var index = 0
            private set

        /** Returns the index of the first of [count] primitives. */
        fun take(count: Int): Int {
            val first = index
            val end = first.toLong() + count
            require(end < Int.MAX_VALUE) { "a frame has at most 2^31-2 primitives: at least $end" }
            index = end.toInt()
            return first
        }
    }
}
