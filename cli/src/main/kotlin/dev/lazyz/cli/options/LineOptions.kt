package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.input.Cut
import dev.lazyz.cli.input.LineWork
import dev.lazyz.drawing.FeatureEdges
import dev.lazyz.drawing.HiddenLines
import dev.lazyz.scenes.PictureStyle
import dev.lazyz.world.surface.Points

/** Options of line drawings and of section planes. */
internal class LineOptions : OptionGroup("Lines and sections") {
    private val hasEdges by option(
        "--edges",
        help = "Draw silhouettes, creases and boundaries of meshes over the picture, without hidden lines",
    ).flag()

    private val isWireframe by option("--wireframe", help = "Draw all edges of triangles, without hidden lines").flag()

    private val creaseAngle by option(
        "--crease-angle",
        help = "Least angle between the normals of the faces at a crease, 0..180; default: " +
            "${FeatureEdges.DEFAULT_CREASE_ANGLE.toInt()}",
    ).number("DEGREES", 0.0..180.0, " degrees")

    private val hidden by option("--hidden-lines", help = "Hidden lines: none, dashed or solid; default: none")
        .oneOf("HOW", words(HiddenLines.entries))

    private val width by option(
        "--edge-width",
        help = "Width of edges in pixels, up to 4096; default: by the size of the picture, 1 for 640x480",
    ).number("PX", 0.001..Points.MAX_SIZE.toDouble(), " pixels")

    private val color by option("--edge-color", help = "Colour of visible edges, opaque; default: black").color()

    private val hiddenColor by option("--hidden-color", help = "Colour of hidden lines, opaque; default: grey").color()

    private val cuts by option(
        "--cut",
        help =
        "Remove what is beyond a plane, in the axes of the input: x=0.5, y=50% (of the bounds), -z=10% (what is " +
            "before it), or a,b,c,d (where ax + by + cz > d); closed meshes are closed again; repeat for more planes",
    ).convert("PLANE") { text ->
        Cut.parse(text) ?: fail("'$text' is not a plane, such as x=0.5, -z=10% or a,b,c,d")
    }.multiple()

    private val capColor by option(
        "--cap-color",
        help = "Colour of cut faces; default: that of the material, darker; with --style technical: hatched",
    ).color()

    /** Returns the lines and planes that the options and the [style] describe. */
    fun lineWork(style: PictureStyle?) =
        LineWork(hasEdges, isWireframe, creaseAngle, hidden, width, color, hiddenColor, style, cuts, capColor)
}
