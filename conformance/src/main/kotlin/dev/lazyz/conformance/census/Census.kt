package dev.lazyz.conformance.census

import dev.lazyz.Frame
import dev.lazyz.world.Scene
import java.util.Collections
import java.util.IdentityHashMap

/** Counts the frames of a rule by their traits. Thread safe, because a rule may render frames in several threads. */
internal class Census {
    private val pairs = TraitPairs()
    private val seen = Collections.newSetFromMap(IdentityHashMap<Frame, Boolean>())
    private var frames = 0L
    private var unexamined = 0L

    /** Starts a new try: each frame is counted once per try. */
    @Synchronized
    fun nextTry() = seen.clear()

    /**
     * Counts [frame], unless it was already counted in this try.
     *
     * @param scene the scene of the frame, or null
     * @param how how the renderer differs from the default; empty if it does not
     */
    @Synchronized
    fun add(frame: Frame, scene: Scene? = null, how: String = "") {
        if (!seen.add(frame)) return
        frames++
        val traits = try {
            if (frame.width.toLong() * frame.primitives.size > MOST_IN_A_ROW) null else traits(frame, scene, how)
        } catch (_: Exception) {
            // Custom primitives may throw anything; the census itself must not fail
            null
        }
        if (traits == null) unexamined++ else pairs.add(traits)
    }

    @Synchronized
    fun distribution(): Distribution = Distribution(frames, unexamined, TraitPairs() + pairs)

    companion object {
        /**
         * Greatest product of columns and primitives. Larger frames are few, and examining them would take longer than
         * rendering them.
         */
        private const val MOST_IN_A_ROW = 100_000L

        /** Returns the traits of [frame]; see [add]. Time: samples x primitives, less for large frames. */
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
