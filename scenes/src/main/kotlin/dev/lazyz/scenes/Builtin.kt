package dev.lazyz.scenes

import dev.lazyz.world.Scene

/**
 * A scene that comes with the library, to try things out on without a file; see [Scenes.builtins].
 *
 * Immutable and thread safe.
 *
 * @property id name on command lines and in scene files, lower case
 * @property summary what it shows, in one line
 * @property size the picture that it was composed for; any other works too
 */
public class Builtin internal constructor(
    public val id: String,
    public val summary: String,
    public val size: ImageSize,
    private val make: () -> Scene,
) {
    /** Makes the scene: surfaces, lights, camera and background. Cost: that of making its surfaces, at each call. */
    public fun scene(): Scene = make()

    override fun toString(): String = "Builtin($id: $summary)"
}
