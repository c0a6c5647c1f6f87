package dev.lazyz.scenes.pictures

import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.ShadingRate
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.drawing.FeatureEdges
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightRig
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LengthUnit
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.pictures.NamedValues.Companion.list
import dev.lazyz.scenes.pictures.NamedValues.Companion.words
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.camera.FittedViewpoint.View
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Points
import java.nio.file.Path
import org.joml.Vector3dc

/**
 * The table of all that can be chosen about one picture of a file, see `docs/parameters.md`. A row is a property of
 * [PictureSettings], an option of `zcli`, and a parameter of the other doors, unless [PictureParameter.missing] says
 * why not.
 *
 * What a parameter does, its range and its default are in [PictureParameter.text], as users read them. In Java, a value
 * has exactly the type of its parameter: `settings.with(PictureParameters.AZIMUTH, 60.0)`, not `60`.
 */
public object PictureParameters {
    private val rows = ArrayList<PictureParameter<*>>()
    private val colors = ColorValues()
    private val vectors = VectorValues()
    private val sizes = range("PX", 0.001, Points.MAX_SIZE.toDouble(), " pixels")
    private val finite = object : CheckedValues("DISTANCE") {
        override fun checked(value: Double) = require(value.isFinite()) { "it must be finite: $value" }
    }

    private var group = ParameterGroup.READING

    /** The format of the file; by default that which the name or the content says. */
    @JvmField
    public val FORMAT: PictureParameter<SceneFormat> = row(
        "format", NamedValues("FORMAT", SceneFormat.entries.associateBy { it.id }),
        "Format of INPUT: ${list(SceneFormat.entries.map { it.id })}", "by its extension",
        file = "is a scene",
    )

    /** The axis of the model that points up. */
    @JvmField
    public val UP: PictureParameter<UpAxis> = row(
        "up", NamedValues("AXIS", UpAxis.entries.associateBy { it.id }),
        "Which axis of the model points up: ${list(UpAxis.entries.map { it.id })}",
        "z for .stl and .3mf, otherwise y",
        file = "has `up`",
    )

    /** A moment of the animation, seconds. */
    @JvmField
    public val ANIMATION_TIME: PictureParameter<Double> = row(
        "animation-time", range("SECONDS", 0.0, 1e6, " seconds"),
        "Show the model at this moment of its first animation (glTF), 0..1000000", "at rest",
        file = "has no animation",
    )

    /** The name of a variant. */
    @JvmField
    public val VARIANT: PictureParameter<String> = row(
        "variant", TextValues("NAME"), "Show the model with the materials of this variant (glTF)",
        "the usual materials",
        file = "has materials of its own",
    )

    /** The number of a scene of the model. */
    @JvmField
    public val SCENE: PictureParameter<Int> = row(
        "scene", ScenesValues(), "Show this scene of the model (glTF), from 0", "the model's default scene",
        file = "is a scene",
    )

    init {
        group = ParameterGroup.PICTURE
    }

    /** Width and height, pixels. */
    @JvmField
    public val SIZE: PictureParameter<ImageSize> = row(
        "size", SizeValues(), "Width and height in pixels, each 1..262144, or one number for a square",
        "the scene file's, or 640x480",
        file = "has `size`",
    )

    /** The part of the picture that is rendered. */
    @JvmField
    public val REGION: PictureParameter<Region> = row(
        "region", RegionValues(),
        "Render only this part of the picture, with the same pixels: column and row of its upper left pixel, " +
            "from 0,0; width and height",
        file = "whoever renders decides",
    )

    /** Samples a pixel in each direction. */
    @JvmField
    public val AA: PictureParameter<Int> = row(
        "aa", NamedValues("N", listOf(1, 2, 4, 8).associateBy { "$it" }),
        "Anti-aliasing: N x N samples a pixel, N is 1, 2, 4 or 8", "4",
        file = "whoever renders decides",
    )

    /** How samples are weighted. */
    @JvmField
    public val AA_FILTER: PictureParameter<PixelFilter> = row(
        "aa-filter", named("FILTER", PixelFilter.entries),
        "How samples are weighted: ${list(words(PixelFilter.entries).keys)}", "box",
        file = "whoever renders decides",
    )

    /** How often a primitive is shaded. */
    @JvmField
    public val SHADING_RATE: PictureParameter<ShadingRate> = row(
        "shading-rate", named("RATE", ShadingRate.entries),
        "Shade primitives at every sample, once in each pixel, or as their material needs: sample, pixel or auto",
        "auto, or pixel with --ambient-occlusion",
        file = "whoever renders decides",
    )

    /** What is behind the surfaces. */
    @JvmField
    public val BACKGROUND: PictureParameter<Backdrop> = row(
        "background", BackdropValues(),
        "A colour: a name of CSS, such as skyblue, transparent, or hexadecimal rgb, rrggbb, rrggbbaa; or two, " +
            "TOP,BOTTOM, for a gradient; or environment, what materials reflect",
        "the scene's, or white",
    )

    /** The colour of all surfaces. */
    @JvmField
    public val COLOR: PictureParameter<Rgba> =
        row("color", colors, "Replace the colours and textures of all surfaces by this colour")

    /** The texture of all surfaces. */
    @JvmField
    public val TEXTURE: PictureParameter<Path> = row(
        "texture", FileValues(),
        "Replace the colours and textures of all surfaces by this image, which --color multiplies; the model " +
            "needs texture coordinates",
        file = "has `materials`",
    )

    /** The shading of all materials. */
    @JvmField
    public val SHADING: PictureParameter<Shading> = row(
        "shading", named("SHADING", Shading.entries),
        "Replace the shading of all materials: ${list(words(Shading.entries).keys)}",
    )

    /** How textures are read where they are far away. */
    @JvmField
    public val TEXTURE_FILTER: PictureParameter<MipFilter> = row(
        "texture-filter", named("FILTER", MipFilter.entries),
        "How textures are read where many texels fall on one sample: ${list(words(MipFilter.entries).keys)}",
        "the scene file's, or anisotropic",
    )

    /** Size of points, pixels; below a pixel, they are rendered as one pixel. */
    @JvmField
    public val POINT_SIZE: PictureParameter<Double> =
        row("point-size", sizes, "Size of points in pixels, up to 4096", "the input's, or 2")

    /** Width of lines, pixels. */
    @JvmField
    public val LINE_WIDTH: PictureParameter<Double> =
        row("line-width", sizes, "Width of lines in pixels, up to 4096", "the input's, or 1")

    /** Whether translucent materials are rendered as opaque. */
    @JvmField
    public val OPAQUE: PictureParameter<Boolean> =
        row("opaque", SwitchValues(), "Render translucent materials as opaque", "blended")

    /** Which depth is nearer. */
    @JvmField
    public val DEPTH_CONVENTION: PictureParameter<DepthConvention> = row(
        "depth-convention",
        NamedValues(
            "ORDER",
            mapOf("smaller" to DepthConvention.SMALLER_IS_NEARER, "larger" to DepthConvention.LARGER_IS_NEARER),
        ),
        "Which depth is nearer: smaller or larger; the picture is the same", "the scene file's, or smaller",
        file = "has `depth`",
    )

    /** Defaults for whole pictures. */
    @JvmField
    public val STYLE: PictureParameter<PictureStyle> = row(
        "style", named("STYLE", PictureStyle.entries),
        "Defaults for whole pictures. product: for a shop, with --ambient-occlusion, --ground-shadow and a wide " +
            "margin; technical: --edges, white surfaces without light, white background, orthographic",
    )

    init {
        group = ParameterGroup.LIGHT
    }

    /** The arrangement of lights. */
    @JvmField
    public val LIGHT: PictureParameter<LightRig> = row(
        "light", named("LIGHT", LightRig.entries),
        "Replace the lights of the scene: ${list(words(LightRig.entries).keys)}", "the scene's, or studio",
        file = "has `lights`",
    )

    /** The factor of all light. */
    @JvmField
    public val LIGHT_INTENSITY: PictureParameter<Double> = row(
        "light-intensity", range("FACTOR", 0.0, 1000.0, ""), "Multiply all light, 0..1000",
        "the scene file's, or 1, or up to 3 for models with dark materials and no lights",
        file = "has `lightIntensity`",
    )

    /** A picture of the surroundings, which lights all materials; or [PictureSettings.STUDIO]. */
    @JvmField
    public val ENVIRONMENT: PictureParameter<Path> = row(
        "environment", EnvironmentValues(),
        "Light all materials by this picture of the surroundings, a Radiance file (.hdr); or studio",
        "studio",
        file = "has `environment`",
    )

    /** Where the middle of the picture of the surroundings is, degrees. */
    @JvmField
    public val ENVIRONMENT_ROTATION: PictureParameter<Double> = row(
        "environment-rotation", range("DEGREES", -1e6, 1e6, " degrees"),
        "Where the middle of --environment is: 0 front, 90 right", "0",
        file = "has `environment`",
    )

    /** The factor of the light of the surroundings. */
    @JvmField
    public val ENVIRONMENT_INTENSITY: PictureParameter<Double> = row(
        "environment-intensity", range("FACTOR", 0.0, 1000.0, ""), "Multiply the light of --environment, 0..1000", "1",
        file = "has `environment`",
    )

    /** Whether surfaces occlude ambient light. */
    @JvmField
    public val AMBIENT_OCCLUSION: PictureParameter<Boolean> = row(
        "ambient-occlusion", SwitchValues(),
        "Darken hollows and contacts, which light from all sides does not reach; all materials are lit by the studio",
    )

    /** Whether the model throws a shadow on the ground. */
    @JvmField
    public val GROUND_SHADOW: PictureParameter<Boolean> =
        row("ground-shadow", SwitchValues(), "Let the model stand on level ground, with a soft shadow")

    /** A picture of a lit sphere that colours all surfaces. */
    @JvmField
    public val MATCAP: PictureParameter<Path> = row(
        "matcap", FileValues(),
        "Colour all surfaces like this picture of a lit sphere, which --color multiplies",
        file = "has `materials`",
    )

    /** How bright light is compressed. */
    @JvmField
    public val TONE_MAP: PictureParameter<ToneMapping.Curve> = row(
        "tone-map", named("CURVE", ToneMapping.Curve.entries),
        "How bright light is compressed: ${list(words(ToneMapping.Curve.entries).keys)}",
        "the scene file's, neutral for scenes with metallic-roughness materials, or none",
        file = "has `toneMapping`",
    )

    /** Brightness, stops. */
    @JvmField
    public val EXPOSURE: PictureParameter<Double> = row(
        "exposure", range("EV", -ToneMapping.MAX_EXPOSURE, ToneMapping.MAX_EXPOSURE, " stops"),
        "Brighten by this number of stops, -20..20: 1 doubles the light", "the scene file's, or 0",
        file = "has `toneMapping`",
    )

    init {
        group = ParameterGroup.CAMERA
    }

    /** Which camera shows the file. */
    @JvmField
    public val CAMERA: PictureParameter<CameraChoice> = row(
        "camera", CameraValues(),
        "fit: show all of the scene; scene: its own camera; or the number, from 0, or the name of a camera of a model",
        "fit for models, scene for scene files and built-in scenes",
    )

    /** The side that the camera looks from. */
    @JvmField
    public val VIEW: PictureParameter<View> =
        row("view", named("SIDE", View.entries), "Look from ${list(words(View.entries).keys)}")

    /** Degrees around the up axis. */
    @JvmField
    public val AZIMUTH: PictureParameter<Double> = row(
        "azimuth", range("DEGREES", -1e6, 1e6, " degrees"), "Degrees around the up axis: 0 front, 90 right",
        "that of --view, or of the camera of the scene, or 30",
    )

    /** Degrees above the horizon. */
    @JvmField
    public val ELEVATION: PictureParameter<Double> = row(
        "elevation", range("DEGREES", -90.0, 90.0, " degrees"), "Degrees above the horizon, -90..90",
        "that of --view, or of the camera of the scene, or 20",
    )

    /** Perspective or orthographic. */
    @JvmField
    public val PROJECTION: PictureParameter<Fit> =
        row("projection", named("KIND", Fit.entries), "perspective or orthographic", "perspective")

    /** The part of the picture that stays free on each side, percent. */
    @JvmField
    public val MARGIN: PictureParameter<Double> = row(
        "margin", range("PERCENT", 0.0, 45.0, " percent"),
        "Free part of the picture on each side, 0..45 percent", "${Camera.DEFAULT_MARGIN.toInt()}",
    )

    /** Magnification. */
    @JvmField
    public val ZOOM: PictureParameter<Double> = row(
        "zoom", range("FACTOR", 0.001, 1000.0, ""),
        "1 shows what the camera shows, 2 shows half as much; 0.001..1000", "1",
    )

    /** Vertical field of view, degrees. */
    @JvmField
    public val FOV: PictureParameter<Double> = row(
        "fov",
        object : CheckedValues("DEGREES") {
            override fun checked(value: Double) {
                Projection.Perspective(value)
            }
        },
        "Vertical field of view of a perspective camera at zoom 1, above 0 and below 180, or at most " +
            "${Camera.MAX_FITTED_FIELD_OF_VIEW.toInt()} without --eye if the camera is fitted",
        "${Camera.DEFAULT_FIELD_OF_VIEW.toInt()}, or the camera's",
    )

    /** Position of the camera, in the coordinates of the model, as other places. */
    @JvmField
    public val EYE: PictureParameter<Vector3dc> =
        row("eye", vectors, "Position of the camera", "where it shows all of the scene")

    /** The point in the middle of the picture. */
    @JvmField
    public val TARGET: PictureParameter<Vector3dc> =
        row("target", vectors, "The point in the middle of the picture", "the scene's")

    /** The direction that is up in the picture. */
    @JvmField
    public val CAMERA_UP: PictureParameter<Vector3dc> =
        row("camera-up", vectors, "The direction that is up in the picture", "the up axis")

    /** Visible height of an orthographic picture, world units. */
    @JvmField
    public val HEIGHT: PictureParameter<Double> = row(
        "height",
        object : CheckedValues("UNITS") {
            override fun checked(value: Double) {
                Projection.Orthographic(value)
            }
        },
        "Visible height of an orthographic picture", "it fits",
    )

    /** Distance of the near plane, world units. */
    @JvmField
    public val NEAR: PictureParameter<Double> =
        row("near", finite, "Distance of the near plane, world units", "it fits")

    /** Distance of the far plane, world units. */
    @JvmField
    public val FAR: PictureParameter<Double> =
        row("far", finite, "Distance of the far plane, world units", "it fits")

    init {
        group = ParameterGroup.LINES
    }

    /** Whether feature edges are drawn. */
    @JvmField
    public val EDGES: PictureParameter<Boolean> = row(
        "edges", SwitchValues(),
        "Draw silhouettes, creases and boundaries of meshes over the picture, without hidden lines",
    )

    /** Whether all edges are drawn. */
    @JvmField
    public val WIREFRAME: PictureParameter<Boolean> =
        row("wireframe", SwitchValues(), "Draw all edges of triangles, without hidden lines")

    /** Least angle of a crease, degrees. */
    @JvmField
    public val CREASE_ANGLE: PictureParameter<Double> = row(
        "crease-angle", range("DEGREES", 0.0, 180.0, " degrees"),
        "Least angle between the normals of the faces at a crease, 0..180",
        "${FeatureEdges.DEFAULT_CREASE_ANGLE.toInt()}",
    )

    /** How hidden lines are drawn. */
    @JvmField
    public val HIDDEN_LINES: PictureParameter<HiddenLines> = row(
        "hidden-lines", named("HOW", HiddenLines.entries), "Hidden lines: none, dashed or solid", "none",
    )

    /** Width of edges, pixels. */
    @JvmField
    public val EDGE_WIDTH: PictureParameter<Double> = row(
        "edge-width", sizes, "Width of edges in pixels, up to 4096", "by the size of the picture, 1 for 640x480",
    )

    /** Colour of visible edges. */
    @JvmField
    public val EDGE_COLOR: PictureParameter<Rgba> =
        row("edge-color", colors, "Colour of visible edges, opaque", "black")

    /** Colour of hidden lines. */
    @JvmField
    public val HIDDEN_COLOR: PictureParameter<Rgba> =
        row("hidden-color", colors, "Colour of hidden lines, opaque", "grey")

    /** The greatest number of faces that hide a line that is drawn. */
    @JvmField
    public val HIDDEN_BEHIND: PictureParameter<Int> = row(
        "hidden-behind", NamedValues("N", (1..9).associateBy { "$it" }),
        "Draw hidden lines only where at most N faces hide them, 1..9", "behind any number",
    )

    /**
     * Planes that cut. [PictureSettings.with] replaces those that were chosen before; [PictureSettings.withWord] adds
     * one.
     */
    @JvmField
    public val CUT: PictureParameter<List<CutPlane>> = row(
        "cut", CutValues(),
        "Remove what is beyond a plane, in the axes of the input: x=0.5, y=50% (of the bounds), -z=10% (what is " +
            "before it), or a,b,c,d (where ax + by + cz > d); closed meshes are closed again; repeat for more planes",
    )

    /** Colour of cut faces. */
    @JvmField
    public val CAP_COLOR: PictureParameter<Rgba> = row(
        "cap-color", colors, "Colour of cut faces",
        "that of the material, darker; with --style technical: hatched",
    )

    init {
        group = ParameterGroup.PAPER
    }

    /** Lengths on paper. It is for [PictureSettings.drawing] alone: pictures of pixels are the same with each. */
    @JvmField
    public val SCALE: PictureParameter<DrawingScale> = row(
        "scale", ScaleValues(),
        "Lengths on the paper and in the model, such as 1:2, for an .svg file of an orthographic picture, which then " +
            "has its size in millimetres",
        "its size is in pixels",
        file = "whoever renders decides",
    )

    /** The unit of lengths in the model, for [SCALE], and for drawings alone as well. */
    @JvmField
    public val UNIT: PictureParameter<LengthUnit> = row(
        "unit", NamedValues("UNIT", LengthUnit.entries.associateBy { it.symbol }),
        "The unit of lengths in INPUT, for --scale: ${list(LengthUnit.entries.map { it.symbol })}",
        "that of the file (3MF; metres for glTF), or mm",
        file = "whoever renders decides",
    )

    /** All parameters, in the order in which the help shows them. */
    @JvmField
    public val all: List<PictureParameter<*>> = rows

    private fun <T : Any> row(
        name: String,
        values: ParameterValues<T>,
        help: String,
        default: String? = null,
        file: String? = if (group == ParameterGroup.CAMERA) "has `camera`" else null,
    ): PictureParameter<T> {
        val door = if (group == ParameterGroup.PAPER) "has no drawings" else null
        val reasons = listOf(PictureDoor.SERVICE to door, PictureDoor.SPARK to door, PictureDoor.SCENE_FILE to file)
        val missing = reasons.mapNotNull { (where, why) -> why?.let { where to it } }.toMap()
        return PictureParameter(name, group, values, help, default, missing).also { rows.add(it) }
    }

    private fun range(form: String, least: Double, most: Double, unit: String) = RangeValues(form, least..most, unit)

    private fun <E : Enum<E>> named(form: String, entries: List<E>) = NamedValues(form, words(entries))
}
