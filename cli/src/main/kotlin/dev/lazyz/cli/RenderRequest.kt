package dev.lazyz.cli

import dev.lazyz.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.Shading
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.SceneFormat
import java.nio.file.Path

/** How to tell what the rendering took. */
internal enum class StatsForm { TABLE, JSON }

/** Which axis of the input points up. */
internal enum class Up { Y, Z }

/** What `zcli render` is asked to do, as the user said it; null means: not said. */
internal class RenderRequest(
    val input: String,
    val format: SceneFormat?,
    val up: Up,
    val output: String?,
    val depthOutput: Path?,
    val size: ImageSize?,
    val background: Rgba?,
    val strategy: String,
    val shading: Shading?,
    val pointOfView: PointOfView,
    val depthConvention: DepthConvention,
    val stats: StatsForm?,
)
