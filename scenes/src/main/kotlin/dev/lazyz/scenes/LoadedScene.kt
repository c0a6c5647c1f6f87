package dev.lazyz.scenes

import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightMeter
import dev.lazyz.lighting.LightRig
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.surface.StreamedMesh
import java.io.Closeable
import java.nio.file.Path

/**
 * A scene that was read, and warnings about what the reader ignored. The lists are not copied; do not change them.
 *
 * @property scene the contents of the file, with the file's camera and lights if it has them
 * @property warnings one sentence for each kind, in the order of the file: for example about missing textures, of which
 *   some are named, or skipped faces
 * @property size the image size that the file requests, or null if it requests none; only scene files can
 * @property depth the depth rules; only scene files can differ from the default
 * @property cameras the cameras of a model, in the order of the file; the first is the viewpoint of [scene]. Empty for
 *   scene files, whose only camera is the viewpoint, and for formats without cameras
 * @property lightRig the arrangement of lights that a scene file names, or null. [scene] has its lights for the camera
 *   of the file; for a picture from another one, use `scene.withLights(lightRig.lights(camera))`
 * @property files the files that the scene refers to, such as textures and material libraries, as absolute paths in the
 *   order in which they were found, each once; also those that could not be decoded. Without the file itself
 * @property format the format that was read, or null if the scene does not come from a file
 * @property picture what a scene file says about a picture of it: names of `PictureParameters`, each with its words
 * @property unit the unit of its lengths, if the file or its format says one: that of a 3MF file, and the metre of glTF
 */
public class LoadedScene @JvmOverloads constructor(
    public val scene: Scene,
    public val warnings: List<String>,
    public val size: ImageSize? = null,
    public val depth: DepthRules = DepthRules(),
    public val cameras: List<NamedCamera> = emptyList(),
    public val lightRig: LightRig? = null,
    public val files: List<Path> = emptyList(),
    public val format: SceneFormat? = null,
    public val picture: Map<String, List<String>> = emptyMap(),
    public val unit: LengthUnit? = null,
) {
    /** Whether this is a model: not a scene file, whose author chose camera and light. */
    public val isModel: Boolean get() = format != null && format != SceneFormat.SCENE

    /** The axis that points up in most files of the [format]; y if there is none. */
    public val usualUp: UpAxis get() = format?.usualUp ?: UpAxis.Y

    /**
     * Returns the raster for setting up the scene, `scene.frame(raster(...))`, with the scene's background and the
     * file's depth rules.
     *
     * @throws IllegalArgumentException if a side is out of range
     */
    public fun raster(width: Int, height: Int): Raster = depth.raster(width, height, scene.background)

    /**
     * Returns [scene], which is this input's scene seen by a camera, with its lights: those of [rig], or by default
     * those of the file's [lightRig] for this camera, or else the scene's own.
     *
     * @param intensity the factor of all light, 0 or more; by default what [LightMeter] finds for models, and the
     *   scene's own for scene files
     * @throws IllegalArgumentException if the viewpoint of [scene] is not a camera, or [intensity] is negative or not
     *   finite
     */
    public fun lit(scene: Scene, rig: LightRig?, intensity: Float?): Scene {
        val given = intensity?.let { scene.withLightIntensity(it) }
        val camera = requireNotNull(scene.viewpoint as? Camera) {
            "light needs a camera, and the viewpoint of the scene is ${scene.viewpoint}; " +
                "use scene.withViewpoint(scene.camera(width, height))"
        }
        val isMetered = isModel && LightMeter.appliesTo(scene, rig)
        val bright = given ?: if (isMetered) scene.withLightIntensity(LightMeter.intensity(scene)) else scene
        return rig?.on(bright, camera) ?: lightRig?.let { bright.withLights(it.lights(camera)) } ?: bright
    }

    /** Returns this input with another scene. */
    public fun withScene(scene: Scene): LoadedScene =
        LoadedScene(scene, warnings, size, depth, cameras, lightRig, files, format, picture, unit)

    /** Returns this input with other warnings. */
    internal fun withWarnings(warnings: List<String>): LoadedScene =
        LoadedScene(scene, warnings, size, depth, cameras, lightRig, files, format, picture, unit)

    override fun toString(): String = "LoadedScene($scene, ${warnings.size} warnings, size $size)"
}

/**
 * One of the cameras of a model. Immutable.
 *
 * @property name the name in the file; empty if it has none
 * @property camera the camera, in world space
 */
public class NamedCamera(public val name: String, public val camera: Camera) {
    override fun toString(): String = "NamedCamera($name, $camera)"
}

/**
 * Units of length.
 *
 * @property symbol the usual symbol; a word for the micrometre
 * @property millimetres how many millimetres one is
 */
public enum class LengthUnit(public val symbol: String, public val millimetres: Double) {
    MICROMETRE("micron", 0.001),
    MILLIMETRE("mm", 1.0),
    CENTIMETRE("cm", 10.0),
    METRE("m", 1000.0),
    INCH("in", 25.4),
    FOOT("ft", 304.8),
}

/**
 * The width and height of an image. Immutable.
 *
 * @property width number of columns, 1..[Raster.MAX_SIDE]
 * @property height number of rows, 1..[Raster.MAX_SIDE]
 * @throws IllegalArgumentException if a side is out of range
 */
public class ImageSize(public val width: Int, public val height: Int) {
    init {
        require(width in 1..Raster.MAX_SIDE) { "width must be in 1..${Raster.MAX_SIDE}: $width" }
        require(height in 1..Raster.MAX_SIDE) { "height must be in 1..${Raster.MAX_SIDE}: $height" }
    }

    override fun equals(other: Any?): Boolean = other is ImageSize && width == other.width && height == other.height

    override fun hashCode(): Int = width * 31 + height

    override fun toString(): String = "${width}x$height"
}

/**
 * A scene whose triangles stay in their file, and are read part by part when they are rendered. Close it after the last
 * rendering: it keeps the file open, and may have temporary files, which [close] deletes. The file must not change
 * before that: what reads it, such as a rendering or a fitted camera, throws an [java.io.UncheckedIOException] with a
 * [SceneReadException] as its cause if the file cannot be read. Thread safe.
 *
 * @property loaded the scene, with a [StreamedMesh] for each mesh of the file, and warnings
 */
public class StreamedScene internal constructor(public val loaded: LoadedScene, private val input: AutoCloseable) :
    Closeable {
    /** Closes the file and deletes temporary files. Closing again does nothing. */
    override fun close(): Unit = input.close()

    override fun toString(): String = "StreamedScene($loaded)"
}

/**
 * The depth rules of a [Raster]. By default the nearest fragment is visible. Immutable and thread safe.
 *
 * @property convention whether smaller or greater depths are nearer
 * @property test decides which of two fragments of a sample is visible
 * @property background depth of the background, 0..2^31-1; by default behind everything
 * @throws IllegalArgumentException if [background] is negative
 */
public class DepthRules @JvmOverloads constructor(
    public val convention: DepthConvention = DepthConvention.SMALLER_IS_NEARER,
    public val test: DepthTest = convention.nearest,
    public val background: Int = convention.farthest,
) {
    init {
        require(background >= 0) { "depth of the background must be in 0..${Int.MAX_VALUE}: $background" }
    }

    /** Returns a raster with these rules. Throws like the constructor of [Raster]. */
    public fun raster(width: Int, height: Int, color: Rgba): Raster =
        Raster(width, height, color, convention, test, background)

    override fun equals(other: Any?): Boolean =
        other is DepthRules && convention == other.convention && test == other.test && background == other.background

    override fun hashCode(): Int = (convention.hashCode() * 31 + test.hashCode()) * 31 + background

    override fun toString(): String = "DepthRules($convention, $test, background=$background)"

    public companion object {
        /** Returns the rules of [raster]. */
        @JvmStatic
        public fun of(raster: Raster): DepthRules =
            DepthRules(raster.convention, raster.depthTest, raster.backgroundDepth)
    }
}
