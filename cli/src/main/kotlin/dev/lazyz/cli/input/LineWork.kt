package dev.lazyz.cli.input

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.cli.output.Mistake
import dev.lazyz.drawing.EdgeDrawing
import dev.lazyz.drawing.EdgeSet
import dev.lazyz.drawing.EdgeStyle
import dev.lazyz.drawing.FeatureEdges
import dev.lazyz.drawing.HiddenLines
import dev.lazyz.scenes.PictureStyle
import dev.lazyz.sections.Hatching
import dev.lazyz.sections.Section
import dev.lazyz.sections.SectionPlane
import dev.lazyz.world.Camera
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading

/** The options of line drawings and section planes; null if the user did not give the option. */
internal class LineWork(
    hasEdges: Boolean,
    isWireframe: Boolean,
    creaseAngle: Double?,
    hidden: HiddenLines?,
    private val width: Double?,
    color: Rgba?,
    hiddenColor: Rgba?,
    private val style: PictureStyle?,
    private val cuts: List<Cut>,
    private val capColor: Rgba?,
) {
    private val isTechnical = style == PictureStyle.TECHNICAL
    private val edges: EdgeStyle?

    /** An option that needs the whole model in memory, or null. */
    val wholeModel: String? = when {
        hasEdges -> "--edges"
        isWireframe -> "--wireframe"
        isTechnical -> "--style technical"
        cuts.isNotEmpty() -> "--cut"
        else -> null
    }

    init {
        if (color != null && color.alpha != 1f) throw Mistake("--edge-color must be opaque")
        if (hiddenColor != null && hiddenColor.alpha != 1f) throw Mistake("--hidden-color must be opaque")
        if (capColor != null && cuts.isEmpty()) throw Mistake("--cap-color needs --cut")
        if (hasEdges && isWireframe) throw Mistake("--wireframe contains the edges of --edges; use one of them")
        if (creaseAngle != null && isWireframe) {
            throw Mistake("--crease-angle has no effect with --wireframe, which draws all edges: omit one of them")
        }
        val isDrawn = hasEdges || isWireframe || isTechnical
        val given = mapOf(
            CREASE_ANGLE to creaseAngle, "--hidden-lines" to hidden, "--edge-width" to width,
            "--edge-color" to color,
        )
        val lonely = given.entries.firstOrNull { it.value != null && !isDrawn }
        if (lonely != null) {
            val edges = if (lonely.key == CREASE_ANGLE) "--edges" else "--edges, --wireframe"
            throw Mistake("${lonely.key} needs $edges or --style technical")
        }
        if (hiddenColor != null && (hidden == null || hidden == HiddenLines.NONE)) {
            throw Mistake("--hidden-color needs --hidden-lines dashed or solid")
        }
        edges = if (!isDrawn) {
            null
        } else {
            EdgeStyle(
                if (isWireframe) EdgeSet.ALL else EdgeSet.FEATURES,
                creaseAngle ?: FeatureEdges.DEFAULT_CREASE_ANGLE,
                color = color ?: Rgba.BLACK,
                hidden = hidden ?: HiddenLines.NONE,
                hiddenColor = hiddenColor ?: EdgeStyle.HIDDEN_GREY,
            )
        }
    }

    /** Returns [scene] cut by the planes. Passes a text to [warn] for what cannot be cut or capped. */
    fun cut(scene: Scene, warn: (String) -> Unit): Scene {
        if (cuts.isEmpty()) return scene
        if (scene.isOnScreen) throw Mistake("--cut: a scene given on the screen cannot be cut")
        val planes = cuts.map { it.plane(scene) }
        for ((cut, plane) in cuts.zip(planes)) {
            if (isKept(scene, plane)) warn("--cut $cut removes nothing: the input is on the other side")
        }
        val cut = Section(planes) { cap(it, scene) }.of(scene)
        cut.warnings.forEach(warn)
        return cut.scene
    }

    /** Returns whether nothing of [scene] is beyond [plane]. */
    private fun isKept(scene: Scene, plane: SectionPlane): Boolean {
        val farthest = scene.farthest(plane.normal) ?: return false
        return plane.normal.dot(farthest) <= plane.distance
    }

    private fun cap(material: Material, scene: Scene): Material = when {
        capColor != null && isTechnical -> Material(capColor, shading = Shading.CONSTANT)
        capColor != null -> Section.capColor(material, capColor)
        isTechnical -> hatching(scene).material()
        else -> Section.darkened(material)
    }

    private fun hatching(scene: Scene): Hatching {
        val size = scene.bounds?.let { maxOf(it.maxX - it.minX, it.maxY - it.minY, it.maxZ - it.minZ) } ?: 0.0
        return Hatching(if (size > 0.0) size / HATCHES else 1.0, HATCH_SHARE, Rgba.ofRgb(HATCH_COLOR), Rgba.WHITE)
    }

    /** Returns [scene] with the edges drawn, for the pixels of [raster]. */
    fun drawnOn(scene: Scene, raster: Raster): Scene {
        if (edges == null) return scene
        val drawing = edges.withWidth(width ?: PictureStyle.lineWidth(raster, style))
        return scene.withSurfaces(scene.surfaces + EdgeDrawing(scene.surfaces, drawing))
    }

    private companion object {
        /** Number of stripes of a cap along the model, the part of it that they cover, and their colour. */
        const val HATCHES = 40
        const val HATCH_SHARE = 0.2
        const val HATCH_COLOR = 0x606060

        const val CREASE_ANGLE = "--crease-angle"
    }
}
