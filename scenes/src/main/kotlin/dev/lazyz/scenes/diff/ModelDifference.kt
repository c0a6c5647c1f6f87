package dev.lazyz.scenes.diff

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.aov.Aov
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.diff.ModelDifference.Change
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.pictures.PictureDifference
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.pictures.PictureSteps
import dev.lazyz.scenes.pictures.VisibleRows
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.surface.Surface

/**
 * What changed from one model to another: in a picture of each, by one camera, and in their numbers. Created by
 * [between]. Immutable and thread safe.
 *
 * Pixels are compared by the surface that is visible at the pixel's nearest sample, see [Change], and by colour;
 * numbers as they are. All comparisons are exact: the bits are the same on every machine, so that no threshold is
 * needed.
 *
 * @property before the picture of the old model
 * @property after the picture of the new model
 * @property isCropped whether a part of a model is outside the pictures
 * @property whole the numbers of both models
 * @property parts the parts of both models: those with the same [Surface.name], the first with the first, the second
 *   with the second, in the order of the old model; then what only the new one has
 */
public class ModelDifference private constructor(
    public val before: Image,
    public val after: Image,
    private val changes: ByteArray,
    public val isCropped: Boolean,
    public val whole: PartDifference,
    public val parts: List<PartDifference>,
) {
    /**
     * What changed at a pixel. Surfaces are those of the models, without drawn edges and without the shadow on the
     * ground.
     *
     * @property color its colour in [toImage], `0xRRGGBB`
     */
    public enum class Change(public val color: Int) {
        /** The pixel shows the same: the same bits of depth, normal and colour, or the same background. */
        SAME(0xC8C8C8),

        /** Only the new model has a surface here. */
        ADDED(0x009E73),

        /** Only the old model has a surface here. */
        REMOVED(0xD55E00),

        /** Both have a surface here, at another depth or with another normal. */
        MOVED(0x0072B2),

        /** The surface is in the same place and has another colour, or a part of the pixel shows something else. */
        RECOLORED(0xE6C400),
        ;

        /** Its name in data. */
        public val id: String get() = name.lowercase()
    }

    private val counts = LongArray(Change.entries.size).also { counts -> changes.forEach { counts[it.toInt()]++ } }

    /** Whether all pixels show the same, and no number of the models and of their parts differs. */
    public val isEqual: Boolean
        get() = count(Change.SAME) == before.region.size && whole.isEqual && parts.all { it.isEqual }

    /** Returns the number of pixels with this [change]. */
    public fun count(change: Change): Long = counts[change.ordinal]

    /**
     * Returns what changed at column [x] and row [y] of the whole picture.
     *
     * @throws IllegalArgumentException if the pixel is not in the region of the pictures
     */
    public fun change(x: Int, y: Int): Change {
        val region = before.region
        require(region.contains(x, y)) { "pixel must be within $region: ($x, $y)" }
        return Change.entries[changes[(y - region.rowStart) * region.width + x - region.columnStart].toInt()]
    }

    /**
     * Returns the result as `zcli diff --json` prints it, see `docs/cli.md`: texts, numbers and booleans, in lists, and
     * in maps by name. Programs depend on the names.
     *
     * @param old what the old model is called
     * @param new what the new model is called
     */
    public fun toData(old: String, new: String): Map<String, Any?> = mapOf(
        "old" to side(old, before),
        "new" to side(new, after),
        "equal" to isEqual,
        "width" to before.width,
        "height" to before.height,
        "cropped" to isCropped,
        "pixels" to Change.entries.associate { it.id to count(it) },
        "numbers" to whole.toData(),
        "parts" to parts.map { mapOf("name" to it.name, "change" to it.change, "numbers" to it.toData()) },
    )

    private fun side(name: String, image: Image): Map<String, Any> {
        val isBlank = VisibleRows(image.width).apply { add(image) }.blank != null
        return mapOf("file" to name, "pixelHash" to image.pixelHash(), "blank" to isBlank)
    }

    /**
     * Returns a picture of the changes: each in its colour, darker where the surface is; what is the same is pale, in
     * the grey of the new picture. It is opaque, and has no depth.
     */
    public fun toImage(): Image {
        val argb = IntArray(changes.size) { at ->
            val change = Change.entries[changes[at].toInt()]
            val shown = (if (change == Change.REMOVED) before else after).argb[at]
            if (change == Change.SAME) PictureDifference.pale(Picture.widened(shown)) else shaded(change.color, shown)
        }
        val none = IntArray(argb.size) { DepthTest.BACKGROUND }
        return Image(before.region, argb, IntArray(argb.size), none, Counters.NONE)
    }

    /** Returns [color], half as bright where [argb] is black. */
    private fun shaded(color: Int, argb: Int): Int {
        val light = 255 + ((argb shr 16 and 0xFF) + (argb shr 8 and 0xFF) + (argb and 0xFF)) / 3
        return listOf(16, 8, 0).fold(0xFF) { all, shift -> all shl 8 or ((color shr shift and 0xFF) * light / 510) }
    }

    override fun toString(): String =
        "ModelDifference(${Change.entries.joinToString { "${count(it)} ${it.name.lowercase()}" }}, $whole)"

    /** A picture, and what is visible of the surfaces of a model alone. */
    private class Sight(val image: Image, val surfaces: Image, val normals: FloatArray, val isCropped: Boolean)

    public companion object {
        /**
         * Compares [new] with [old]. The camera is fitted to both, and cuts in percent refer to both; the axis that
         * points up, the camera and the size of a file are those of the old one. Otherwise, each picture is the one
         * that the [settings] give. Cost: both pictures, with edges or a shadow on the ground twice, and one pass over
         * all triangles. Memory, besides both models and what rendering takes: 49 bytes a pixel, or 73 with edges or a
         * shadow on the ground; while the numbers of a model are computed, 40 bytes for each of its triangles, and a
         * table of its points.
         *
         * @param renderer renders the pictures, which are the same with each
         * @param options the threads of set-up
         * @param oldObserver is told what happens to the old model
         * @param newObserver is told what happens to the new one
         * @throws dev.lazyz.scenes.pictures.NoPictureException as [PictureSettings.frame]; also if a model has more
         *   than 715 million triangles
         * @throws dev.lazyz.scenes.SceneFormatException as [PictureSettings.frame]
         */
        @JvmStatic
        @JvmOverloads
        @Throws(InterruptedException::class)
        public fun between(
            old: LoadedScene,
            new: LoadedScene,
            settings: PictureSettings = PictureSettings(),
            renderer: Renderer = TiledRenderer(),
            options: RenderOptions = RenderOptions(),
            oldObserver: PictureObserver = PictureObserver(),
            newObserver: PictureObserver = PictureObserver(),
        ): ModelDifference {
            val axis = settings[PictureParameters.UP] ?: old.usualUp
            val turned = settings.with(PictureParameters.UP, axis)
            val both = old.withScene(old.scene.withSurfaces(old.scene.surfaces + new.scene.surfaces))
            val stage = PictureSteps(turned, both, options, PictureObserver(limits = oldObserver.limits)).stage()
            val seen = turned.without(PictureParameters.CAMERA)
            val (was, now) = listOf(old to oldObserver, new to newObserver).map { (loaded, observer) ->
                sight(PictureSteps(seen, loaded, options, observer, stage), renderer) {
                    PictureSteps(seen, loaded, options, PictureObserver(limits = observer.limits), stage)
                }
            }
            val changes = ByteArray(was.image.argb.size) { change(was, now, it).ordinal.toByte() }
            val whole = PartDifference("", old.scene.surfaces, new.scene.surfaces)
            val parts = PartDifference.pairs(old.scene.surfaces, new.scene.surfaces, whole)
            return ModelDifference(was.image, now.image, changes, was.isCropped || now.isCropped, whole, parts)
        }

        private fun sight(steps: PictureSteps, renderer: Renderer, again: () -> PictureSteps): Sight {
            val frame = steps.frame(null)
            if (!steps.hasExtras) {
                return rendered(frame, renderer).let { (image, normals) ->
                    Sight(image, image, normals, frame.isCropped)
                }
            }
            val (surfaces, normals) = rendered(again().bare(), renderer)
            return Sight(frame.render(renderer), surfaces, normals, frame.isCropped)
        }

        private fun rendered(frame: PictureFrame, renderer: Renderer): Pair<Image, FloatArray> {
            val collector = Image.Collector(frame.pixels)
            val aovs = frame.render(renderer, collector, setOf(Aov.NORMAL))
            return collector.toImage(aovs.counters) to aovs[Aov.NORMAL].floats
        }

        private fun change(was: Sight, now: Sight, at: Int): Change {
            val wasThere = was.surfaces.primitive[at] != DepthTest.BACKGROUND
            val isThere = now.surfaces.primitive[at] != DepthTest.BACKGROUND
            return when {
                isThere && !wasThere -> Change.ADDED
                wasThere && !isThere -> Change.REMOVED
                wasThere && isMoved(was, now, at) -> Change.MOVED
                was.image.argb[at] != now.image.argb[at] -> Change.RECOLORED
                else -> Change.SAME
            }
        }

        private fun isMoved(was: Sight, now: Sight, at: Int): Boolean =
            was.surfaces.depth[at] != now.surfaces.depth[at] ||
                (3 * at until 3 * at + 3).any { was.normals[it].toBits() != now.normals[it].toBits() }
    }
}
