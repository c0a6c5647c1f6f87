package dev.lazyz.scenes

/**
 * How a scene is to be read. Immutable.
 *
 * @property limits how much the file may ask for
 * @property animationTime the moment of the file's first animation that is to be seen, in seconds from its start; before its
 *   first keyframe that one counts, after the last the last one. Null, the default, shows the model at rest, without its
 *   animations. Only glTF files have animations
 * @property smoothNormals whether meshes without normals in the file get smooth ones, up to the creases of the file's format.
 *   Without them each triangle has its own, and reading takes less time and memory
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

    override fun toString(): String = "LoadOptions($limits, animationTime=$animationTime, smoothNormals=$smoothNormals)"
}
