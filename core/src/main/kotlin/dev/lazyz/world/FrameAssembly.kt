package dev.lazyz.world

import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.FrameParts
import dev.lazyz.FrameView
import dev.lazyz.NoView
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.Surface

/** From the [surfaces] of a scene to the content of a frame. Used once. */
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

    private fun view(): FrameView = SceneView(setUp.camera, setUp.origin, starts)

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
        if (batch != null) add(batch) else surface.primitives(setUp).forEach(::add)
    }

    private fun streamed(): FrameContent {
        var size = 0L
        var hasTranslucency = false
        val content = ArrayList<Iterable<FrameContent>>()
        for ((number, surface) in surfaces.withIndex()) {
            starts[number] = size.toInt()
            if (surface is StreamedMesh) {
                size += surface.triangleCount
                hasTranslucency = hasTranslucency || surface.isTranslucent
                content += Iterable { surface.parts().asSequence().map(::part).iterator() }
            } else {
                // Surfaces in memory are set up once
                val part = part(surface)
                size += part.size
                hasTranslucency = hasTranslucency || part.hasTranslucency
                content += listOf(part)
            }
            require(size < Int.MAX_VALUE) { "a frame has at most 2^31-2 primitives: at least $size" }
        }
        val parts = FrameParts(size.toInt(), hasTranslucency) { content.asSequence().flatten().iterator() }
        return FrameContent.streamed(parts, view())
    }

    private fun part(surface: Surface): FrameContent =
        FrameContent.Builder().apply { add(surface) }.build(NoView)
}
