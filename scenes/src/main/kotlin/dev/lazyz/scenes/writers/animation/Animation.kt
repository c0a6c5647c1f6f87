package dev.lazyz.scenes.writers.animation

import dev.lazyz.scenes.writers.AlphaChannel

/**
 * The shape of an animation, which is repeated without end. Immutable.
 *
 * @property width columns of each frame
 * @property height rows of each frame
 * @property frames number of frames, at least 1
 * @property framesPerSecond how many frames are shown in a second, 1..50
 * @property alpha whether pixels can be transparent
 * @throws IllegalArgumentException if a number is out of range
 */
public class Animation @JvmOverloads constructor(
    public val width: Int,
    public val height: Int,
    public val frames: Int,
    public val framesPerSecond: Int = DEFAULT_FRAMES_PER_SECOND,
    public val alpha: AlphaChannel = AlphaChannel.KEEP,
) {
    init {
        require(width > 0 && height > 0) { "a frame must have at least one pixel: $width x $height" }
        require(frames > 0) { "there must be at least one frame: $frames" }
        require(framesPerSecond in 1..MAX_FRAMES_PER_SECOND) {
            "framesPerSecond must be in 1..$MAX_FRAMES_PER_SECOND: $framesPerSecond"
        }
    }

    override fun toString(): String = "Animation($width x $height, $frames frames, $framesPerSecond per second, $alpha)"

    public companion object {
        /** The default of [framesPerSecond]. */
        public const val DEFAULT_FRAMES_PER_SECOND: Int = 12

        /** The greatest [framesPerSecond]: browsers show GIF frames for at least 0.02 seconds. */
        public const val MAX_FRAMES_PER_SECOND: Int = 50
    }
}
