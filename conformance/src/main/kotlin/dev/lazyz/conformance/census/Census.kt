package dev.lazyz.conformance.census

import dev.lazyz.Frame
import dev.lazyz.world.Scene
import java.util.Collections
import java.util.IdentityHashMap

/** Counts the frames that a rule is tried on by their traits. Thread safe: a rule may try frames in several threads. */
internal class Census {
    private val pairs = TraitPairs()
    private val seen = Collections.newSetFromMap(IdentityHashMap<Frame, Boolean>())
    private var frames = 0L
    private var unexamined = 0L

    /** From here on a frame counts anew. */
    @Synchronized
    fun nextTry() = seen.clear()

    /**
     * Counts [frame], unless this try had it before.
     *
     * @param scene what it was set up from, or null
     * @param how what is special about the renderer, or nothing
     */
    @Synchronized
    fun add(frame: Frame, scene: Scene? = null, how: String = "") {
        if (!seen.add(frame)) return
        frames++
        val traits = try {
            if (frame.width.toLong() * frame.primitives.size > MOST_IN_A_ROW) null else traits(frame, scene, how)
        } catch (_: Exception) {
            // Primitives may be as wild as they like; a census must not be what fails
            null
        }
        if (traits == null) unexamined++ else pairs.add(traits)
    }

    @Synchronized
    fun distribution(): Distribution = Distribution(frames, unexamined, TraitPairs() + pairs)

    companion object {
        /** Columns times primitives; larger frames are few, and would take longer to look at than to render. */
        private const val MOST_IN_A_ROW = 100_000L

        /** Returns what [frame] has; see [add]. Time: samples x primitives, for large frames less. */
        fun traits(frame: Frame, scene: Scene? = null, how: String = ""): Set<FrameTrait> {
            val traits = rasterTraits(frame.raster)
            if (frame.primitives.isEmpty()) traits.add(FrameTrait.NO_PRIMITIVES)
            if (frame.region != frame.raster.region) traits.add(FrameTrait.REGION)
            if (frame.hasTranslucency) traits.add(FrameTrait.TRANSLUCENT)
            if (maxOf(frame.width, frame.height) > USUAL_TILE) traits.add(FrameTrait.SEVERAL_TILES)
            if (frame.primitives.any { it.depthForm == null }) traits.add(FrameTrait.FORMLESS)
            if (how.isNotEmpty()) traits.add(FrameTrait.CONFIGURED)
            if (scene != null) addSceneTraits(scene, traits)
            SampleTraits(frame).addTo(traits)
            return traits
        }

        private const val USUAL_TILE = 64
    }
}
