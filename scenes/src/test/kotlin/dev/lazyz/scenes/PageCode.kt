package dev.lazyz.scenes

import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame
import dev.lazyz.drawing.EdgeStyle
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.filter.SuperSampling
import dev.lazyz.lighting.AmbientOcclusion
import dev.lazyz.lighting.GroundShadow
import dev.lazyz.scenes.aov.AovFiles
import dev.lazyz.scenes.aov.AovPicture
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.pictures.PictureStyle
import dev.lazyz.scenes.writers.writePng
import dev.lazyz.sections.Section
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import java.nio.file.Path

/** Code that pages show, in the order of `README.md` and the pages of `docs`: it compiles. */
internal object PageCode {
    fun picture() {
        val model = Scenes.load(Path.of("teapot.obj"))
        PictureSettings(640, 480).frame(model).render(TiledRenderer()).writePng(Path.of("teapot.png"))
    }

    fun antiAliasing(scene: Scene): Image {
        val image = SuperSampling(4).frame(scene, Raster(640, 480)).render(TiledRenderer())
        return image
    }

    fun data(scene: Scene): Double {
        val frame = SuperSampling(4).frame(scene, Raster(640, 480))
        val aovs = AovFrame(frame, setOf(Aov.DEPTH, Aov.OBJECT)).render(TiledRenderer())
        val distance = aovs[Aov.DEPTH].number(x = 320, y = 240)
        AovFiles.write(Path.of("depth.pfm"), aovs[Aov.DEPTH])
        AovPicture.of(aovs[Aov.OBJECT]).writePng(Path.of("objects.png"))
        return distance
    }

    fun drawing(scene: Scene): Image {
        val half = Section(listOf(Section.Plane.z(0.0))).of(scene)
        val drawing = EdgeStyle().withWidth(1.5).withHidden(HiddenLines.DASHED).drawnOn(half.scene)
        val image = SuperSampling(4).frame(drawing, Raster(640, 480)).render(TiledRenderer())
        return image
    }

    fun vectors(path: Path) {
        val settings = PictureSettings().with(PictureParameters.STYLE, PictureStyle.TECHNICAL)
        settings.drawing(Scenes.load(path)).writeSvg(Path.of("part.svg"))
    }

    fun light(scene: Scene): Scene {
        val soft = scene
            .withMaterials { it.asMetallicRoughness() }
            .withAmbientVisibility(AmbientOcclusion.of(scene))
        val shadow = GroundShadow.of(scene)
        val picture = soft
            .withSurfaces(soft.surfaces + shadow)
            .withViewpoint { all, aspect -> shadow.camera(scene.viewpoint.camera(all, aspect)) }
        return picture
    }
}
