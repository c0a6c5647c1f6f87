package dev.lazyz.testing

import dev.lazyz.Raster
import dev.lazyz.world.Scene

/** A golden test of a scene, whose size is not known yet. Created by [assertThat]. Immutable and thread safe. */
public class SceneAssertion internal constructor(private val scene: Scene, private val goldens: Goldens) {
    /**
     * Returns the test of a picture of [width] x [height] pixels, with the background of the scene.
     *
     * @throws IllegalArgumentException if a side is not in 1..[Raster.MAX_SIDE]
     */
    public fun at(width: Int, height: Int): RenderingAssertion =
        RenderingAssertion(scene, Raster(width, height, scene.background), goldens)
}
