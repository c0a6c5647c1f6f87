package dev.lazyz.scenes.pictures

import dev.lazyz.RenderOptions
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.camera.FittedViewpoint.View
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.camera.Viewpoint
import dev.lazyz.world.material.Material.Shading
import java.nio.file.Path

/**
 * How a file is shown: all that `zcli render` offers for one picture, with its defaults. That is the whole model, in
 * three quarter view, with more light for dark materials, and 4 x 4 samples a pixel.
 *
 * ```
 * val settings = PictureSettings(640, 480).with(PictureParameters.VIEW, View.ISO).with(PictureParameters.EDGES, true)
 * settings.frame(Scenes.load(path)).render(TiledRenderer()).writePng(output)
 * ```
 *
 * In Java:
 *
 * ```java
 * PictureSettings settings = new PictureSettings(640, 480)
 *     .with(PictureParameters.VIEW, View.ISO).with(PictureParameters.EDGES, true);
 * LoadedScene loaded = Scenes.load(path, settings.loadOptions(new LoadLimits()));
 * Images.writePng(settings.frame(loaded).render(new TiledRenderer()), output);
 * ```
 *
 * What can be chosen are the [PictureParameters]. What is not chosen has a default, which can depend on the file.
 *
 * A picture is made from a loaded file in these steps, in this order:
 * 1. colours of the [PictureParameters.STYLE];
 * 2. cuts, in the axes of the file;
 * 3. the camera is chosen, and the scene turned so that its up axis is y; sizes of points and lines;
 * 4. colour and texture of all surfaces, then shading and texture filter;
 * 5. the camera is fitted to the whole picture;
 * 6. lights and surroundings, or the lit sphere of a matcap; what is to be opaque;
 * 7. ambient occlusion, and the shadow on the ground;
 * 8. tone curve and exposure;
 * 9. edges, which are not lit;
 * 10. set-up of the samples, of a region or of all; a gradient comes behind the pixels when they are rendered.
 *
 * Immutable and thread safe.
 *
 * @property viewpoint a camera or a rule for one, in place of that of the file; it takes precedence over that of a
 *   style. No words describe it
 */
public class PictureSettings private constructor(
    private val given: Map<PictureParameter<*>, Any>,
    private val usual: Map<PictureParameter<*>, Any>,
    public val viewpoint: Viewpoint?,
    internal val names: ParameterNames,
) {
    /** Settings without any choice: the size is that of the file, or [USUAL_SIZE]. */
    public constructor() : this(emptyMap(), emptyMap(), null, ParameterNames("", "="))

    /**
     * Settings for a picture of a size.
     *
     * @param width number of columns, 1..[dev.lazyz.Raster.MAX_SIDE]
     * @param height number of rows, in the same range
     * @throws IllegalArgumentException if a side is out of range
     */
    public constructor(width: Int, height: Int) :
        this(mapOf(PictureParameters.SIZE to ImageSize(width, height)), emptyMap(), null, ParameterNames("", "="))

    /** Returns the value that was chosen for [parameter], or null. */
    @Suppress("UNCHECKED_CAST")
    public operator fun <T : Any> get(parameter: PictureParameter<T>): T? = given[parameter] as T?

    /**
     * Returns these settings with a [value] of [parameter], in place of earlier ones.
     *
     * @throws IllegalArgumentException if it is out of range
     */
    public fun <T : Any> with(parameter: PictureParameter<T>, value: T): PictureSettings {
        try {
            parameter.values.check(value)
        } catch (illegal: IllegalArgumentException) {
            throw IllegalArgumentException("${names.of(parameter)} ${illegal.message}", illegal)
        }
        return copy(given = given + (parameter to value))
    }

    /**
     * Returns these settings with the value of [parameter] that [word] means. A parameter that can be repeated, which
     * is [PictureParameters.CUT], keeps its earlier values, too.
     *
     * @throws IllegalArgumentException if it means none; the message is for the user
     */
    public fun <T : Any> withWord(parameter: PictureParameter<T>, word: String): PictureSettings {
        val value = try {
            parameter.values.read(word)
        } catch (illegal: IllegalArgumentException) {
            throw IllegalArgumentException("${names.of(parameter)}: ${illegal.message}", illegal)
        }
        val all = this[parameter]?.let { parameter.values.added(it, value) } ?: value
        return copy(given = given + (parameter to all))
    }

    /** Returns these settings without a value of [parameter]. */
    public fun without(parameter: PictureParameter<*>): PictureSettings = copy(given = given - parameter)

    /** Returns these settings, seen from [view] in place of the side that they choose. */
    public fun seenFrom(view: View): PictureSettings =
        without(PictureParameters.AZIMUTH).without(PictureParameters.ELEVATION).with(PictureParameters.VIEW, view)

    /**
     * Returns these settings with a camera in place of what they choose about it: exactly [camera], which shows a scene
     * in which y points up, for a model whose axis [up] was turned there.
     */
    public fun seenBy(camera: Camera, up: UpAxis): PictureSettings {
        val free = ParameterGroup.CAMERA.parameters.fold(withViewpoint(null)) { all, other -> all.without(other) }
        val projection = camera.projection
        if (projection == Projection.Screen) return free.with(PictureParameters.CAMERA, CameraChoice.SCENE)
        val kind = if (projection is Projection.Perspective) Fit.PERSPECTIVE else Fit.ORTHOGRAPHIC
        val placed = free.with(PictureParameters.PROJECTION, kind)
            .with(PictureParameters.EYE, up.toModel(camera.eye))
            .with(PictureParameters.TARGET, up.toModel(camera.target))
            .with(PictureParameters.CAMERA_UP, up.toModel(camera.up))
        val sized = when (projection) {
            is Projection.Perspective -> placed.with(PictureParameters.FOV, projection.verticalFieldOfView)
            is Projection.Orthographic -> placed.with(PictureParameters.HEIGHT, projection.height)
            Projection.Screen -> placed
        }
        return sized.with(PictureParameters.NEAR, camera.near).with(PictureParameters.FAR, camera.far)
    }

    /**
     * The options of `zcli render` that choose what these settings do, in the order in which it was chosen, each with
     * its value after `=`. The [viewpoint] and defaults are not among them.
     */
    public val options: List<String> get() = given.keys.flatMap { optionsOf(it) }

    private fun <T : Any> optionsOf(parameter: PictureParameter<T>): List<String> {
        val value = checkNotNull(this[parameter])
        if (parameter.values.form == null) return if (value == true) listOf("--${parameter.name}") else emptyList()
        return parameter.values.words(value).map { "--${parameter.name}=$it" }
    }

    /**
     * Returns these settings with another default of [parameter], which is [PictureParameters.SIZE] or
     * [PictureParameters.AA]. A default of the latter gives way where it is not possible, and a chosen value is an
     * error.
     *
     * @throws IllegalArgumentException if [parameter] is another one
     */
    public fun <T : Any> withDefault(parameter: PictureParameter<T>, value: T): PictureSettings {
        require(parameter in DEFAULTED) { "$parameter has no other default; there are ${DEFAULTED.joinToString()}" }
        return copy(usual = usual + (parameter to value))
    }

    /** Returns these settings with another camera or rule, or with that of the file. */
    public fun withViewpoint(viewpoint: Viewpoint?): PictureSettings = copy(viewpoint = viewpoint)

    /**
     * Returns these settings with what the [words] of a scene file choose, unless these settings choose it, too. If
     * both exclude each other, those of the file do not count.
     */
    internal fun withFile(words: Map<String, List<String>>): PictureSettings {
        if (words.isEmpty()) return this
        val pairs = words.flatMap { (name, values) -> values.map { name to it } }
        val both = copy(given = PictureDoor.SCENE_FILE.read(PictureSettings(), pairs).given + given)
        return try {
            both.apply { check() }
        } catch (_: NoPictureException) {
            this
        }
    }

    /** Returns these settings with messages in which the [names] of parameters have another form. */
    public fun withNames(names: ParameterNames): PictureSettings = copy(names = names)

    private fun copy(
        given: Map<PictureParameter<*>, Any> = this.given,
        usual: Map<PictureParameter<*>, Any> = this.usual,
        viewpoint: Viewpoint? = this.viewpoint,
        names: ParameterNames = this.names,
    ) = PictureSettings(given, usual, viewpoint, names)

    /** Returns the chosen value of [parameter], or the default of these settings, or null. */
    @Suppress("UNCHECKED_CAST")
    internal fun <T : Any> orDefault(parameter: PictureParameter<T>): T? = (given[parameter] ?: usual[parameter]) as T?

    internal fun has(switch: PictureParameter<Boolean>): Boolean = this[switch] == true

    /** The size of a picture of a file that requests none. */
    public val size: ImageSize get() = orDefault(PictureParameters.SIZE) ?: USUAL_SIZE

    /** Samples a pixel in each direction, at most. */
    public val factor: Int get() = orDefault(PictureParameters.AA) ?: USUAL_FACTOR

    /** Whether surfaces occlude ambient light. */
    public val hasOcclusion: Boolean
        get() = has(PictureParameters.AMBIENT_OCCLUSION) || this[PictureParameters.STYLE] == PictureStyle.PRODUCT

    /** Whether the model throws a shadow on the ground. */
    public val hasGroundShadow: Boolean
        get() = has(PictureParameters.GROUND_SHADOW) || this[PictureParameters.STYLE] == PictureStyle.PRODUCT

    /** Whether all edges or some are drawn. */
    public val hasEdges: Boolean
        get() = has(PictureParameters.EDGES) || has(PictureParameters.WIREFRAME) ||
            this[PictureParameters.STYLE] == PictureStyle.TECHNICAL

    /** Whether no surface has smooth normals. */
    public val hasFaceNormals: Boolean
        get() = this[PictureParameters.SHADING].let { it == Shading.FLAT || it == Shading.CONSTANT }

    /** The files that these settings name, besides that of the model. */
    public val files: Map<PictureParameter<Path>, Path>
        get() = FILES.mapNotNull { parameter -> this[parameter]?.let { parameter to it } }.toMap()
            .filter { (parameter, file) -> parameter != PictureParameters.ENVIRONMENT || file != STUDIO }

    /** A parameter for which the whole model must be in memory, as messages name it, or null. */
    public val wholeModel: String?
        get() {
            val style = this[PictureParameters.STYLE]
            val lines = listOf(PictureParameters.EDGES, PictureParameters.WIREFRAME).firstOrNull { has(it) }
            val shadows =
                listOf(PictureParameters.AMBIENT_OCCLUSION, PictureParameters.GROUND_SHADOW).firstOrNull { has(it) }
            return when {
                lines != null -> names.of(lines)
                style == PictureStyle.TECHNICAL -> names.of(PictureParameters.STYLE, "technical")
                this[PictureParameters.CUT] != null -> names.of(PictureParameters.CUT)
                style == PictureStyle.PRODUCT -> names.of(PictureParameters.STYLE, "product")
                shadows != null -> names.of(shadows)
                this[PictureParameters.TEXTURE] != null -> names.of(PictureParameters.TEXTURE)
                else -> null
            }
        }

    /** A parameter that places the camera, so that it cannot go around the scene, as messages name it, or null. */
    public val placed: String?
        get() = firstGiven(
            PictureParameters.CAMERA.takeIf { this[it] !== CameraChoice.FIT },
            PictureParameters.EYE, PictureParameters.TARGET, PictureParameters.CAMERA_UP,
        )

    /** A parameter that chooses the side, so that there is no other, as messages name it, or null. */
    public val directed: String?
        get() = firstGiven(*DIRECTION) ?: placed

    internal fun firstGiven(vararg parameters: PictureParameter<*>?): String? =
        parameters.firstOrNull { it in given }?.let { names.of(it!!) }

    /** Returns how to read the file, within [limits]: its scene, variant and moment. */
    public fun loadOptions(limits: LoadLimits): LoadOptions =
        LoadOptions(limits, this[PictureParameters.ANIMATION_TIME])
            .withVariant(this[PictureParameters.VARIANT]).withSceneNumber(this[PictureParameters.SCENE])

    /**
     * Checks that no two parameters exclude each other:
     * - a matcap, which replaces materials and light, and shading, texture, light and its intensity, ambient occlusion,
     *   surroundings, tone curve or exposure;
     * - ambient occlusion or surroundings, and flat or Gouraud shading;
     * - the camera of the file, and a view, azimuth, elevation, projection or margin; an eye, and these without the
     *   projection;
     * - edges and a wireframe; a wireframe and the angle of creases.
     *
     * It also checks that there is what others need: edges or a wireframe for their looks, dashed or solid hidden lines
     * for their colour, a cut for the colour of caps, a scale for a unit, surroundings for their rotation or
     * intensity.
     *
     * @throws NoPictureException otherwise
     */
    public fun check() {
        checkLight()
        PictureCamera(this).check()
        checkLines()
    }

    private fun checkLight() = PictureParameters.run {
        val lonely = firstGiven(
            LIGHT, LIGHT_INTENSITY, AMBIENT_OCCLUSION.takeIf { has(it) }, ENVIRONMENT, SHADING, TEXTURE, TONE_MAP,
            EXPOSURE,
        )
        if (this@PictureSettings[MATCAP] != null && lonely != null) {
            refuse("${names.of(MATCAP)} replaces materials and light, so $lonely has no effect")
        }
        val turned = firstGiven(ENVIRONMENT_ROTATION, ENVIRONMENT_INTENSITY)
        if (ENVIRONMENT !in files && turned != null) refuse("$turned needs ${names.of(ENVIRONMENT, "FILE")}")
        val shading = this@PictureSettings[SHADING]
        if ((hasOcclusion || ENVIRONMENT in files) && (shading == Shading.FLAT || shading == Shading.GOURAUD)) {
            val word = names.of(SHADING, shading.name.lowercase())
            val what = if (hasOcclusion) "ambient occlusion" else names.of(ENVIRONMENT)
            refuse("with $what, light is computed at each pixel, so $word has no effect")
        }
    }

    private fun checkLines() = PictureParameters.run {
        val own = this@PictureSettings
        for (color in listOf(EDGE_COLOR, HIDDEN_COLOR)) {
            if (own[color] != null && own[color]?.alpha != 1f) refuse("${names.of(color)} must be opaque")
        }
        if (own[CAP_COLOR] != null && own[CUT] == null) refuse("${names.of(CAP_COLOR)} needs ${names.of(CUT)}")
        val edges = names.of(EDGES)
        val wireframe = names.of(WIREFRAME)
        if (has(EDGES) && has(WIREFRAME)) refuse("$wireframe contains the edges of $edges; use one of them")
        if (own[CREASE_ANGLE] != null && has(WIREFRAME)) {
            val angle = names.of(CREASE_ANGLE)
            refuse("$angle has no effect with $wireframe, which draws all edges: omit one of them")
        }
        val lonely = firstGiven(CREASE_ANGLE, HIDDEN_LINES, EDGE_WIDTH, EDGE_COLOR)
        if (!hasEdges && lonely != null) {
            val lines = if (own[CREASE_ANGLE] != null) edges else "$edges, $wireframe"
            refuse("$lonely needs $lines or ${names.of(STYLE, "technical")}")
        }
        val onPaper = firstGiven(SCALE, UNIT)
        if (own[SCALE] == null && onPaper != null) refuse("$onPaper needs ${names.of(SCALE)}")
        val ofHidden = firstGiven(HIDDEN_COLOR, HIDDEN_BEHIND)
        if (ofHidden != null && (own[HIDDEN_LINES] ?: HiddenLines.NONE) == HiddenLines.NONE) {
            refuse("$ofHidden needs ${names.of(HIDDEN_LINES, "dashed")} or solid")
        }
    }

    /**
     * Sets up the picture of [loaded], which is what `zcli render` renders with these settings, bit for bit, if it was
     * loaded with [loadOptions]. The [PictureParameters.FORMAT] has no effect here: pass it to `Scenes.load`.
     *
     * @param options the threads of set-up, see [Scene.frame]
     * @param observer is told what happens
     * @throws NoPictureException if two parameters exclude each other, no camera shows the model, because its numbers
     *   would be beyond their range, or the model cannot be shown as chosen
     * @throws dev.lazyz.scenes.SceneFormatException if a texture, a matcap or a picture of surroundings cannot be read
     * @throws InterruptedException as [Scene.frame], and while shadows are computed
     */
    @JvmOverloads
    @Throws(InterruptedException::class)
    public fun frame(
        loaded: LoadedScene,
        options: RenderOptions = RenderOptions(),
        observer: PictureObserver = PictureObserver(),
    ): PictureFrame = PictureSteps(this, loaded, options, observer).frame(null)

    /**
     * Computes the lines of [loaded] in the picture of these settings, as vectors: what `zcli render` writes to an SVG
     * file. Throws like [frame].
     *
     * @throws NoPictureException also if the settings have no lines, see [hasEdges]
     */
    @JvmOverloads
    @Throws(InterruptedException::class)
    public fun drawing(
        loaded: LoadedScene,
        options: RenderOptions = RenderOptions(),
        observer: PictureObserver = PictureObserver(),
    ): PictureDrawing = PictureSteps(this, loaded, options, observer).drawing()

    /**
     * Returns the pictures of a turn around [loaded] in equal [steps]. These settings choose the side at which it
     * begins.
     *
     * @throws IllegalArgumentException if [steps] is below 1
     */
    public fun turntable(loaded: LoadedScene, steps: Int): Turntable = Turntable(this, loaded, steps)

    override fun toString(): String = "PictureSettings(${given.entries.joinToString { "${it.key}=${it.value}" }})"

    public companion object {
        /** The size if neither the settings nor the file choose one. */
        @JvmField
        public val USUAL_SIZE: ImageSize = ImageSize(640, 480)

        /** Samples a pixel in each direction if the settings do not choose. */
        public const val USUAL_FACTOR: Int = 4

        /** The value of [PictureParameters.ENVIRONMENT] that is no file, but the built-in studio. */
        @JvmField
        public val STUDIO: Path = Path.of("studio")

        /** The parameters whose values are files. */
        @JvmField
        public val FILES: List<PictureParameter<Path>> =
            listOf(PictureParameters.TEXTURE, PictureParameters.MATCAP, PictureParameters.ENVIRONMENT)

        internal val DIRECTION =
            arrayOf<PictureParameter<*>>(PictureParameters.VIEW, PictureParameters.AZIMUTH, PictureParameters.ELEVATION)
        private val DEFAULTED = listOf(PictureParameters.SIZE, PictureParameters.AA)
    }
}
