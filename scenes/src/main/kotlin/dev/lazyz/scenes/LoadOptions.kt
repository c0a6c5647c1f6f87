package dev.lazyz.scenes

/**
 * Options for reading a scene. Immutable.
 *
 * @property limits limits on what the file can request
 * @property animationTime the time in the file's first animation at which to show the model, in seconds from the
 *   start of the animation. A time before the first keyframe shows the first keyframe, a time after the last shows
 *   the last. Null, the default, shows the model at rest, without its animations. Only glTF files have animations
 * @property smoothNormals whether meshes without normals in the file get smooth normals, except at the creases that
 *   the file's format defines. If false, each triangle has its own normal, and reading takes less time and memory
 * @throws IllegalArgumentException if [animationTime] is negative, infinite, or not a number
 */
public class LoadOptions @JvmOverloads constructor(
    public val limits: LoadLimits = LoadLimits(),
    public val animationTime: Double? = null,
    public val smoothNormals: Boolean = true,
) {
    init {
        require(animationTime == null || (animationTime >= 0.0 && animationTime.isFinite())) {
            "animationTime must be 0 or more: $animationTime"
        }
    }

    /** Returns these options with other limits. */
    public fun withLimits(limits: LoadLimits): LoadOptions = copy(limits = limits)

    /** Returns these options with a time in the file's first animation, in seconds, 0 or more. */
    public fun withAnimationTime(animationTime: Double): LoadOptions = copy(animationTime = animationTime)

    /** Returns these options for a model at rest, without its animations. */
    public fun withoutAnimationTime(): LoadOptions = copy(animationTime = null)

    /** Returns these options with smooth normals for meshes without normals in the file. */
    public fun withSmoothNormals(): LoadOptions = copy(smoothNormals = true)

    /** Returns these options without smooth normals: each triangle has its own normal. */
    public fun withoutSmoothNormals(): LoadOptions = copy(smoothNormals = false)

    private fun copy(
        limits: LoadLimits = this.limits,
        animationTime: Double? = this.animationTime,
        smoothNormals: Boolean = this.smoothNormals,
    ): LoadOptions = LoadOptions(limits, animationTime, smoothNormals)

    override fun toString(): String = "LoadOptions($limits, animationTime=$animationTime, smoothNormals=$smoothNormals)"
}
