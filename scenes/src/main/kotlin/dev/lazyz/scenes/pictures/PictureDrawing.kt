package dev.lazyz.scenes.pictures

import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.drawing.EdgeDrawing.DrawnCap
import dev.lazyz.drawing.EdgeDrawing.DrawnLine
import dev.lazyz.drawing.EdgeStyle
import dev.lazyz.scenes.LengthUnit
import dev.lazyz.scenes.writers.AtomicFile
import dev.lazyz.scenes.writers.SvgWriter
import dev.lazyz.sections.Section.Hatching
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Surface
import java.io.IOException
import java.io.OutputStream
import java.nio.channels.Channels
import java.nio.file.Path

/**
 * The lines of a picture as vectors, with what is below them. Created by [PictureSettings.drawing].
 *
 * ```
 * val settings = PictureSettings().with(PictureParameters.STYLE, PictureStyle.TECHNICAL)
 * settings.drawing(Scenes.load(path)).writeSvg(Path.of("part.svg"))
 * ```
 *
 * Below the lines is the [picture] of the surfaces without them. There is none in a drawing of the technical style in
 * which all surfaces are white, and the background, too, or it is transparent: it consists of lines and caps only.
 *
 * Immutable and thread safe, if the arrays of lines and caps are not changed.
 *
 * @property style how the lines are drawn
 * @property lines the lines of the whole picture, see [dev.lazyz.drawing.EdgeDrawing.lines]
 * @property caps the cut faces of the whole picture that are filled; empty if there is a [picture], which shows them
 * @property pixels the part of the whole picture that is written
 * @property pixelSize millimetres of a pixel on paper, or null if the size is in pixels
 * @property hasBackground whether there is white paper behind a drawing without [picture]
 * @property picture what is below the lines, or null
 */
public class PictureDrawing internal constructor(
    public val style: EdgeStyle,
    public val lines: List<DrawnLine>,
    public val caps: List<DrawnCap>,
    public val pixels: Region,
    public val pixelSize: Double?,
    public val hasBackground: Boolean,
    public val picture: PictureFrame?,
) {
    /**
     * Writes the drawing to the SVG file [path], which appears when it is complete, like the other [writeSvg].
     *
     * @throws IOException if the file cannot be written; the message says which, why, and what to do
     */
    @JvmOverloads
    @Throws(InterruptedException::class, IOException::class)
    public fun writeSvg(path: Path, renderer: Renderer = TiledRenderer()): Blank? = AtomicFile.rendering {
        AtomicFile.write(path) { writeSvg(Channels.newOutputStream(it), renderer) }
    }

    /**
     * Writes the drawing as an SVG file to [output], without closing it. `docs/drawings.md` says what is in the file.
     * It has the same bytes on every machine. Cost: linear in the number of points.
     *
     * @param renderer renders the [picture]
     * @return why there is nothing to see, or null if there is something
     * @throws IOException if writing fails
     */
    @JvmOverloads
    @Throws(InterruptedException::class, IOException::class)
    public fun writeSvg(output: OutputStream, renderer: Renderer = TiledRenderer()): Blank? {
        val svg = SvgWriter(output)
        svg.begin(pixels, pixelSize)
        svg.styles(style, if (picture == null && hasBackground) Rgba.WHITE else null, caps.map { colors(it.cap) })
        val rows = picture?.let { VisibleRows(it.pixels.width) }
        if (picture == null) {
            if (hasBackground) svg.background(pixels)
        } else {
            svg.image(pixels, picture.alpha) { png ->
                picture.render(renderer) { y, argb, depth, primitive ->
                    png.row(y, argb, depth, primitive)
                    rows?.row(y, argb, depth, primitive)
                }
            }
        }
        for (cap in caps) svg.cap(cap)
        val shown = lines.filter { isNear(it.points) }
        for ((kind, same) in shown.groupBy { it.kind to it.isHidden }) svg.lines(kind.first, kind.second, same)
        svg.end()
        if (shown.isNotEmpty() || caps.isNotEmpty()) return null
        return if (rows == null) Blank.BACKGROUND else rows.blank
    }

    /** Whether a part of a line between these points may be in the [pixels]. */
    private fun isNear(points: DoubleArray): Boolean {
        fun reaches(first: Int, start: Int, end: Int): Boolean {
            val places = first until points.size step 2
            return places.any { points[it] > start - style.width } && places.any { points[it] < end + style.width }
        }
        return reaches(0, pixels.columnStart, pixels.columnEnd) && reaches(1, pixels.rowStart, pixels.rowEnd)
    }

    /** Returns the colour of a cap, and that of its stripes. */
    private fun colors(cap: Polygon): Pair<Rgba, Rgba?> {
        val hatching = cap.material.shader as? Hatching ?: return cap.material.baseColor to null
        return hatching.ground to hatching.stripe
    }

    override fun toString(): String = "PictureDrawing(${lines.size} lines, ${caps.size} caps, $pixels, $picture)"

    internal companion object {
        /**
         * Returns the millimetres of a pixel on paper, or null if [settings] choose no scale.
         *
         * @param unit the unit of the file, or null
         */
        fun pixelSize(settings: PictureSettings, unit: LengthUnit?, camera: Camera, raster: Raster): Double? {
            val scale = settings[PictureParameters.SCALE] ?: return null
            val word = settings.names.of(PictureParameters.SCALE, scale)
            val height = when (val projection = camera.projection) {
                is Projection.Orthographic -> projection.height
                is Projection.Perspective -> {
                    val other = settings.names.of(PictureParameters.PROJECTION, "orthographic")
                    refuse("$word: under perspective, lengths have no scale; use $other")
                }
                Projection.Screen -> refuse("$word: a scene given on the screen has no scale")
            }
            val own = settings[PictureParameters.UNIT] ?: unit ?: LengthUnit.MILLIMETRE
            val pixel = height / raster.height * own.millimetres * scale.paper / scale.model
            val sides = listOf(pixel * raster.width, pixel * raster.height)
            if (sides.all { it in PAPER }) return pixel
            val other = settings.names.of(PictureParameters.UNIT)
            refuse("$word: the paper would be ${sides.joinToString(" x ")} mm; use another scale, or another $other")
        }

        /** Sides of paper, millimetres. */
        private val PAPER = 0.01..1e7

        /** Whether surfaces of [scene] cannot be seen without lines, except caps in one colour or with stripes. */
        fun isOnPaper(scene: Scene, raster: Raster): Boolean =
            (raster.background == Rgba.WHITE || raster.background.alpha == 0f) &&
                scene.effectiveToneMapping == ToneMapping.NONE && scene.surfaces.all(::isOnPaper)

        private fun isOnPaper(surface: Surface): Boolean {
            val material = surface.material ?: return false
            if (surface !is Polygon || !surface.isCap) return isPlain(material, surface) && isWhite(material.baseColor)
            return material.shader is Hatching || (isPlain(material, surface) && material.baseColor.alpha >= 1f)
        }

        private fun isPlain(material: Material, surface: Surface) = material.shading == Shading.CONSTANT &&
            material.shader == null && material.texture == null && surface.withoutColors() === surface

        private fun isWhite(color: Rgba) = color == Rgba.WHITE
    }
}
