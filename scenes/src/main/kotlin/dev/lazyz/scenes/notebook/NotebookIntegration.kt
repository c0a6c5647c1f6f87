package dev.lazyz.scenes.notebook

import dev.lazyz.Image
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.pictures.PictureDrawing
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import java.io.ByteArrayOutputStream
import java.util.Base64
import org.jetbrains.kotlinx.jupyter.api.MimeTypedResult
import org.jetbrains.kotlinx.jupyter.api.libraries.JupyterIntegration
import org.jetbrains.kotlinx.jupyter.api.mimeResult

/**
 * Kotlin notebooks show an [Image] as it is, a [Scene], a [LoadedScene] and a [PictureFrame] as `zcli render` does, and
 * a [PictureDrawing] as vectors. The kernel of Kotlin for Jupyter makes this object when the library is added to a
 * notebook, because `META-INF/kotlin-jupyter-libraries` names it; nothing else loads the class.
 */
internal class NotebookIntegration : JupyterIntegration() {
    override fun Builder.onLoaded() {
        import("dev.lazyz.*", "dev.lazyz.scenes.*", "dev.lazyz.scenes.formats.*", "dev.lazyz.scenes.pictures.*")
        import("dev.lazyz.scenes.writers.*", "dev.lazyz.world.*", "dev.lazyz.world.camera.*", "dev.lazyz.world.light.*")
        import("dev.lazyz.world.camera.FittedViewpoint.*", "dev.lazyz.world.material.Material.*")
        import("dev.lazyz.world.material.*", "dev.lazyz.world.surface.*")
        render<Image> { picture(it) }
        render<PictureFrame> { picture(it.render(TiledRenderer())) }
        render<LoadedScene> { picture(PictureSettings().frame(it).render(TiledRenderer())) }
        render<Scene> { picture(PictureSettings().frame(LoadedScene(it, emptyList())).render(TiledRenderer())) }
        render<PictureDrawing> {
            mimeResult("image/svg+xml" to ByteArrayOutputStream().apply(it::writeSvg).toString(Charsets.UTF_8))
        }
    }

    private fun picture(image: Image): MimeTypedResult =
        mimeResult("image/png" to Base64.getEncoder().encodeToString(image.toPng()))
}
