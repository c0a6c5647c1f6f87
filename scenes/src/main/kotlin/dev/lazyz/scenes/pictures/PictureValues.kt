package dev.lazyz.scenes.pictures

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.filter.PixelBackground.VerticalGradient
import dev.lazyz.sections.Section
import dev.lazyz.sections.Section.Hatching
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import org.joml.Vector3d

/**
 * What is behind the surfaces: one colour, or two, the upper and the lower end of a gradient, or the surroundings.
 * Immutable.
 *
 * @property color the background of the frame; transparent if something else is behind it
 * @property gradient the gradient, or null
 */
public class Backdrop private constructor(
    private val text: String,
    color: Rgba?,
    public val gradient: VerticalGradient?
) {
    public val color: Rgba = color ?: Rgba.TRANSPARENT

    /** Whether it is no more than the [color]. */
    public val isPlain: Boolean = color != null

    public constructor(color: Rgba) : this("$color", color, null)

    public constructor(gradient: VerticalGradient) : this("$gradient", null, gradient)

    override fun toString(): String = "Backdrop($text)"

    public companion object {
        /** The environment that materials reflect. */
        @JvmField
        public val ENVIRONMENT: Backdrop = Backdrop("environment", null, null)
    }
}

/** Which camera shows a file. Immutable. */
public class CameraChoice private constructor(private val text: String, internal val number: Int) {
    override fun toString(): String = text

    public companion object {
        /** A camera that shows all of the scene. */
        @JvmField
        public val FIT: CameraChoice = CameraChoice("fit", -1)

        /** The own camera of the scene, or one that shows all of it if it has none. */
        @JvmField
        public val SCENE: CameraChoice = CameraChoice("scene", -1)

        /**
         * Returns the choice of the camera with this number in a model, from 0.
         *
         * @throws IllegalArgumentException if [number] is negative
         */
        @JvmStatic
        public fun ofModel(number: Int): CameraChoice {
            require(number >= 0) { "number must be 0 or more: $number" }
            return CameraChoice("$number", number)
        }

        /** Returns the choice of the camera with this [name] in a model; of several, the first. */
        @JvmStatic
        public fun ofModel(name: String): CameraChoice = CameraChoice(name, NAMED)

        internal const val NAMED = -2
    }
}

/**
 * A plane that cuts a scene: what is beyond it is removed. In the axes of the model. Immutable.
 *
 * @property text the plane as [parse] reads it
 */
public class CutPlane private constructor(public val text: String, private val place: (Scene) -> Section.Plane) {
    /** Returns the plane in [scene], which percentages refer to. */
    public fun plane(scene: Scene): Section.Plane = place(scene)

    override fun toString(): String = text

    public companion object {
        private val axes = listOf("x", "y", "z")

        /**
         * Returns the plane that [text] describes: `x=0.5`, `y=50%` (of the bounds), `-z=10%` (what is before it is
         * removed), or `a,b,c,d` (where ax + by + cz > d is removed); or null if it describes none.
         */
        @JvmStatic
        public fun parse(text: String): CutPlane? = if ('=' in text) axis(text) else general(text)

        private fun axis(text: String): CutPlane? {
            val name = text.substringBefore('=').lowercase()
            val axis = axes.indexOf(if (name.startsWith('+') || name.startsWith('-')) name.drop(1) else name)
            val place = text.substringAfter('=')
            val number = decimal(place.removeSuffix("%"))
            if (axis < 0 || number == null) return null
            val isReversed = name.startsWith('-')
            return CutPlane(text) { scene ->
                val at = if (place.endsWith('%')) fraction(scene, axis, number / 100) else number
                val plane = Section.Plane(Vector3d().setComponent(axis, 1.0), at)
                if (isReversed) plane.reversed() else plane
            }
        }

        private fun fraction(scene: Scene, axis: Int, part: Double): Double {
            val box = scene.bounds ?: return 0.0
            val low = box.corner(0).get(axis)
            val high = box.corner(7).get(axis)

            // The ends exactly, so that 0% and 100% are along faces
            return if (part == 1.0) high else low + part * (high - low)
        }

        private fun general(text: String): CutPlane? {
            val numbers = text.split(',').map { decimal(it) ?: return null }
            if (numbers.size != 4) return null
            val (a, b, c, d) = numbers
            val square = a * a + b * b + c * c
            if (!(square > 0.0 && square.isFinite() && d.isFinite())) return null
            val length = StrictMath.sqrt(square)
            return CutPlane(text) { Section.Plane(Vector3d(a, b, c), d / length) }
        }
    }
}

/** The cuts that [settings] choose, and their caps. Warnings go to [observer]. */
internal class PictureCuts(private val settings: PictureSettings, private val observer: PictureObserver) {
    private val names = settings.names
    private val isTechnical = settings[PictureParameters.STYLE] == PictureStyle.TECHNICAL

    /** Returns [scene] without what is beyond [planes], one for each cut, or [scene] itself if there is no cut. */
    fun of(scene: Scene, planes: List<Section.Plane>): Scene {
        val cuts = settings[PictureParameters.CUT] ?: return scene
        if (scene.isOnScreen) refuse("${names.of(PictureParameters.CUT)}: a scene given on the screen cannot be cut")
        for ((cut, plane) in cuts.zip(planes)) {
            if (!isKept(scene, plane)) continue
            val word = names.of(PictureParameters.CUT, cut)
            observer.warning("$word removes nothing: the input is on the other side")
        }
        val cut = Section(planes) { cap(it, scene) }.of(scene)
        cut.warnings.forEach(observer::warning)
        return cut.scene
    }

    /** Returns whether nothing of [scene] is beyond [plane]. */
    private fun isKept(scene: Scene, plane: Section.Plane): Boolean {
        val farthest = scene.farthest(plane.normal) ?: return false
        return plane.normal.dot(farthest) <= plane.distance
    }

    private fun cap(material: Material, scene: Scene): Material {
        val color = settings[PictureParameters.CAP_COLOR]
        return when {
            color != null && isTechnical -> Material(color, shading = Shading.CONSTANT)
            color != null -> Section.capColor(material, color)
            isTechnical -> hatching(scene).material()
            else -> Section.darkened(material)
        }
    }

    private fun hatching(scene: Scene): Hatching {
        val size = scene.bounds?.let { maxOf(it.maxX - it.minX, it.maxY - it.minY, it.maxZ - it.minZ) } ?: 0.0
        return Hatching(if (size > 0.0) size / HATCHES else 1.0, HATCH_SHARE, Rgba.ofRgb(HATCH_COLOR), Rgba.WHITE)
    }

    private companion object {
        /** Number of stripes of a cap along the model, the part of it that they cover, and their colour. */
        const val HATCHES = 40
        const val HATCH_SHARE = 0.2
        const val HATCH_COLOR = 0x606060
    }
}

/**
 * How long lengths are on paper. Immutable.
 *
 * @property paper a length on paper
 * @property model the length in the model that it stands for, in the same unit
 * @throws IllegalArgumentException if one of them is not positive and finite
 */
public class DrawingScale(public val paper: Double, public val model: Double) {
    init {
        require(paper > 0.0 && model > 0.0 && paper.isFinite() && model.isFinite()) {
            "both lengths of a scale must be above 0: $paper:$model"
        }
    }

    override fun toString(): String = "${plain(paper)}:${plain(model)}"

    private fun plain(length: Double) = if (length % 1.0 == 0.0) "${length.toLong()}" else "$length"
}

/** Returns the decimal number that [text] is, such as `-2.5` or `.5e3`, or null: other forms do not count. */
internal fun decimal(text: String): Double? =
    if (text.all { it in "0123456789.+-eE" }) text.toDoubleOrNull() else null

/**
 * Styles of whole pictures, see [PictureParameters.STYLE].
 *
 * @property projection the projection of a camera that shows the whole scene, or null for the usual one
 * @property margin its free part of the picture on each side, percent, or null for the usual one
 */
public enum class PictureStyle(public val projection: Fit?, public val margin: Double?) {
    /** A drawing in a manual: edges, white surfaces without light, white background, orthographic. */
    TECHNICAL(Fit.ORTHOGRAPHIC, null) {
        override fun painted(scene: Scene): Scene = scene.withMaterials(::white).withBackground(Rgba.WHITE)
    },

    /** A product in a shop: soft shadows, in its hollows and on the ground; the margin leaves room for them. */
    PRODUCT(null, 12.0) {
        override fun painted(scene: Scene): Scene = scene
    }, ;

    /** Returns [scene] with the colours of this style, before it gets its light. */
    internal abstract fun painted(scene: Scene): Scene

    internal companion object {
        private fun white(material: Material): Material =
            Material(shading = Shading.CONSTANT, sides = material.sides, name = material.name)

        /**
         * Returns the width of edges in pixels that looks the same in large and in small pictures of [raster]; in
         * [TECHNICAL] drawings they are wider.
         */
        internal fun lineWidth(raster: Raster, style: PictureStyle?): Double {
            val scale = minOf(raster.width, raster.height) / USUAL_SIDE
            return (if (style == TECHNICAL) TECHNICAL_WIDTH else 1.0) * scale.coerceIn(LEAST_SCALE, MOST_SCALE)
        }

        /** The width of lines in technical drawings, pixels in a picture of [USUAL_SIDE]; otherwise it is 1. */
        private const val TECHNICAL_WIDTH = 1.5

        /** The shorter side of a picture, pixels, and how much lines grow and shrink with it. */
        private const val USUAL_SIDE = 480.0
        private const val LEAST_SCALE = 0.5
        private const val MOST_SCALE = 8.0
    }
}
