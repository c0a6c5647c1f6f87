package dev.lazyz.scenes

import dev.lazyz.world.Scene

/**
 * A built-in scene, for trying out the library without a file; see `Scenes.builtins`.
 *
 * Immutable and thread safe.
 *
 * @property id lower-case name, used on command lines and in scene files
 * @property summary what the scene shows, in one line
 * @property size the image size that the scene was composed for; any other size works too
 */
public class Builtin internal constructor(
    public val id: String,
    public val summary: String,
    public val size: ImageSize,
    private val make: () -> Scene,
) {
    /** Creates the scene: surfaces, lights, camera and background. Cost: each call creates all surfaces again. */
    public fun scene(): Scene = make()

    override fun toString(): String = "Builtin($id: $summary)"
}
