package dev.lazyz.conformance.frames

import dev.lazyz.Raster
import dev.lazyz.conformance.cases.Confetti
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Glass
import dev.lazyz.conformance.cases.PartSeeds
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.listsOf
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.frames.screen.Piece
import dev.lazyz.conformance.frames.screen.PieceOrder
import dev.lazyz.conformance.frames.screen.PolygonPiece
import dev.lazyz.conformance.frames.screen.broughtTo
import dev.lazyz.conformance.frames.screen.screenCase
import dev.lazyz.conformance.frames.world.WorldFrames
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/**
 * Which frames to generate: kinds and their weights, sizes, counts, depth complexity, levels of depth, translucency.
 *
 * Every function returns a changed copy. Pass the result to [Frames.of]:
 *
 * ```
 * Frames.of(FrameMix.of(FrameKind.HOLES, FrameKind.SLIVERS).sized(40, 30).counted(5, 50).layered(3))
 * ```
 *
 * The kind of each group of primitives in a frame is random, with probabilities in proportion to the weights. Kinds in
 * world space and kinds in screen space never occur in the same frame. All frames shrink: to fewer primitives, a
 * smaller raster, rounder numbers. Immutable and thread safe.
 */
public class FrameMix private constructor(
    private val weights: Map<FrameKind, Int>,
    private val maxWidth: Int = Frames.DEFAULT_SIDE,
    private val maxHeight: Int = Frames.DEFAULT_SIDE,
    private val minPrimitives: Int = 0,
    private val maxPrimitives: Int = Frames.DEFAULT_PRIMITIVES,
    private val layers: Int = 0,
    private val levels: Int = 0,
    private val translucentPercent: Int = 0,
    private val parts: PartSeeds? = null,
) {
    /**
     * Returns a mix in which [kind] has the given [weight], at least 0. Groups are chosen in proportion to the weights.
     */
    public fun with(kind: FrameKind, weight: Int): FrameMix {
        require(weight >= 0) { "weight must not be negative: $weight" }
        return copy(weights = weights + (kind to weight))
    }

    /** Returns a mix of frames with at most this number of columns and rows, 1..[Raster.MAX_SIDE]. */
    public fun sized(maxWidth: Int, maxHeight: Int): FrameMix {
        require(maxWidth in 1..Raster.MAX_SIDE && maxHeight in 1..Raster.MAX_SIDE) {
            "sides must be in 1..${Raster.MAX_SIDE}: $maxWidth, $maxHeight"
        }
        return copy(maxWidth = maxWidth, maxHeight = maxHeight)
    }

    /**
     * Returns a mix of frames with [min] to [max] primitives in screen space, not counting layers, or surfaces in world
     * space. If [min] is 0, one frame in sixteen is empty.
     */
    public fun counted(min: Int, max: Int): FrameMix {
        require(min in 0..max) { "counts must be 0 <= min <= max: $min, $max" }
        return copy(minPrimitives = min, maxPrimitives = max)
    }

    /**
     * Returns a mix whose frames in screen space have [layers] additional polygons, among the others, that cover the
     * whole raster. This is the minimum depth complexity of every sample.
     */
    public fun layered(layers: Int): FrameMix {
        require(layers >= 0) { "layers must not be negative: $layers" }
        return copy(layers = layers)
    }

    /**
     * Returns a mix whose polygons in screen space have vertices at only [levels] different depths, spread evenly from
     * near to far. Fewer levels give more ties. 0 leaves depths unchanged.
     */
    public fun levels(levels: Int): FrameMix {
        require(levels >= 0) { "levels must not be negative: $levels" }
        return copy(levels = levels)
    }

    /** Returns a mix in which [percent] of the frames, 0..100, have [Glass] among their primitives. */
    public fun translucent(percent: Int): FrameMix {
        require(percent in 0..100) { "percent must be in 0..100: $percent" }
        return copy(translucentPercent = percent)
    }

    /** Returns a mix of frames with these [parts]; other frames of it differ in what is not among them. */
    internal fun of(parts: PartSeeds): FrameMix = copy(parts = parts)

    /** Generates the frames; see [Frames.of]. */
    internal fun frames(): Arbitrary<FrameCase> {
        val onScreen = weights.filter { it.value > 0 && !it.key.isInSpace }
        val inSpace = weights.filter { it.value > 0 && it.key.isInSpace }
        require(onScreen.isNotEmpty() || inSpace.isNotEmpty()) { "a kind must have a weight above 0: $weights" }
        val rasters = Frames.rasters(maxWidth, maxHeight).let { parts?.rasters(it) ?: it }
        val choices = ArrayList<Pair<Int, Arbitrary<FrameCase>>>()
        if (onScreen.isNotEmpty()) choices.add(onScreen.values.sum() to screen(rasters, onScreen))
        if (inSpace.isNotEmpty()) choices.add(inSpace.values.sum() to space(rasters, inSpace))
        return glazed(mixed(*choices.toTypedArray())).withoutEdgeCases()
    }

    private fun screen(rasters: Arbitrary<Raster>, kinds: Map<FrameKind, Int>): Arbitrary<FrameCase> {
        val pieces = ScreenKinds(maxWidth, maxHeight)
        val groups = mixed(*kinds.map { (kind, weight) -> weight to pieces.of(kind) }.toTypedArray())
        val whole = pieces.layers(layers, layers)
        return Combinators.combine(rasters, counted(groups), whole, Arbitraries.integers())
            .`as` { raster, list, covers, salt ->
                // Limit the number of primitives, and insert the layers at random positions
                val order = if (salt and 1 == 0) PieceOrder.TOGETHER else PieceOrder.APART
                val all = order.of(list.map { it.broughtTo(raster) }).take(maxPrimitives).toMutableList()
                for (cover in covers) all.add(Math.floorMod(salt, all.size + 1), cover)
                screenCase(raster, all.map(::leveled))
            }
    }

    private fun space(rasters: Arbitrary<Raster>, kinds: Map<FrameKind, Int>): Arbitrary<FrameCase> {
        val surfaces = kinds.map { (kind, weight) ->
            weight to when (kind) {
                FrameKind.MESHES -> WorldFrames.mesh()
                FrameKind.SPHERES -> WorldFrames.sphere()
                FrameKind.NEAR_PLANE -> WorldFrames.nearPlane()
                FrameKind.POINTS -> WorldFrames.points()
                FrameKind.LINES -> WorldFrames.lines()
                else -> mixed(2 to WorldFrames.polygon(), 1 to WorldFrames.holed())
            }
        }
        return WorldFrames.cases(rasters, counted(mixed(*surfaces.toTypedArray())))
    }

    private fun <T : Any> counted(elements: Arbitrary<T>): Arbitrary<List<T>> = when {
        parts != null -> parts.lists(elements)
        minPrimitives == 0 -> listsOf(elements, maxPrimitives)
        else -> elements.list().ofMinSize(minPrimitives).ofMaxSize(maxPrimitives)
    }

    private fun leveled(piece: Piece): Piece {
        if (levels == 0 || piece !is PolygonPiece) return piece
        val steps = maxOf(levels - 1, 1)
        val contours = piece.contours.map { contour ->
            DoubleArray(contour.size) {
                when {
                    it % 3 != 2 || !contour[it].isFinite() -> contour[it]
                    levels == 1 -> 0.5
                    else -> StrictMath.rint(contour[it] * steps) / steps
                }
            }
        }
        return PolygonPiece(contours, piece.fillRule)
    }

    private fun glazed(cases: Arbitrary<FrameCase>): Arbitrary<FrameCase> {
        if (translucentPercent == 0) return cases
        return Combinators.combine(cases, ints(1, 100), ints(1, 0xFFFF)).`as` { case, percent, choice ->
            if (percent <= translucentPercent) case.glazed(choice) else case
        }
    }

    private fun copy(
        weights: Map<FrameKind, Int> = this.weights,
        maxWidth: Int = this.maxWidth,
        maxHeight: Int = this.maxHeight,
        minPrimitives: Int = this.minPrimitives,
        maxPrimitives: Int = this.maxPrimitives,
        layers: Int = this.layers,
        levels: Int = this.levels,
        translucentPercent: Int = this.translucentPercent,
        parts: PartSeeds? = this.parts,
    ) = FrameMix(weights, maxWidth, maxHeight, minPrimitives, maxPrimitives, layers, levels, translucentPercent, parts)

    override fun toString(): String = "FrameMix($weights, $maxWidth x $maxHeight, " +
        "$minPrimitives..$maxPrimitives primitives, $layers layers, $levels levels, $translucentPercent% translucent)"

    public companion object {
        /**
         * Returns a mix of all kinds, with greater weights for ties, intersections and curved depth, and smaller ones
         * for primitives that cover little or nothing.
         */
        @JvmStatic
        public fun usual(): FrameMix = FrameMix(
            FrameKind.entries.associateWith {
                when (it) {
                    FrameKind.COINCIDENT, FrameKind.COPLANAR, FrameKind.INTERPENETRATING -> 5
                    FrameKind.CONFETTI, FrameKind.SPHERES -> 4
                    FrameKind.DEGENERATE, FrameKind.TINY, FrameKind.POINTS, FrameKind.LINES -> 1
                    else -> 2
                }
            },
        )

        /** Returns a mix of [kinds], all equally likely. */
        @JvmStatic
        public fun of(vararg kinds: FrameKind): FrameMix {
            require(kinds.isNotEmpty()) { "at least one kind is required" }
            return FrameMix(kinds.associateWith { 1 })
        }
    }
}

/**
 * A kind of frames that are difficult to render, see [FrameMix].
 *
 * @property isInSpace whether such frames are 3D scenes seen through a camera; the others are in screen space
 */
public enum class FrameKind(public val isInSpace: Boolean = false) {
    /**
     * Three to six vertices anywhere on the 1/256 pixel grid, on and around the raster, with any depths, so rarely
     * flat.
     */
    SCATTERED,

    /** Vertices exactly on samples, so that many samples are exactly on edges. */
    ON_SAMPLES,

    /** Vertices exactly on the corners of pixels. */
    ON_CORNERS,

    /** Triangles a few grid steps wide and of any length, often steep. */
    SLIVERS,

    /** Polygons that cover one or two samples, or none. */
    TINY,

    /** Flat polygons with a notch. */
    CONCAVE,

    /** Flat polygons with a hole, or an island in the hole, with either fill rule. */
    HOLES,

    /** Flat polygons with up to eighty teeth, and as many spans in a row, if the raster is wide enough. */
    COMBS,

    /** Flat polygons whose contour intersects itself: bow ties and pentagrams. */
    SELF_CROSSING,

    /** The same polygon two or three times: ties at all its samples. */
    COINCIDENT,

    /** Polygons at one of five depths, parallel to the screen: ties where they overlap. */
    COPLANAR,

    /** Triangles around a common vertex, each of which shares an edge with the next. */
    SHARED_EDGES,

    /** Two flat polygons that intersect somewhere in the middle. */
    INTERPENETRATING,

    /** Two or three large polygons whose depths differ by a few units, and that intersect. */
    NEARLY_COPLANAR,

    /**
     * A slope, and polygons of constant depth at its nearest or farthest depth, or one unit in front of or behind it.
     */
    TOUCHING,

    /** Two to five polygons that cover the whole raster. */
    LAYERED,

    /** Vertices up to the limit of the guard band, 2^19 pixels away. */
    GIANT,

    /** Polygons that cover nothing: too few vertices, no area, NaN or infinite numbers. */
    DEGENERATE,

    /** [Confetti]: custom primitives, with many spans in a row and no coherence. */
    CONFETTI,

    /** Polygons of three to five vertices in world space, and flat squares with holes. */
    POLYGONS_IN_SPACE(true),

    /** Meshes of up to six triangles. */
    MESHES(true),

    /** Spheres of any size, some around the camera. */
    SPHERES(true),

    /** Triangles that extend from in front of the camera to behind it. */
    NEAR_PLANE(true),

    /** Clouds of points, of less than a pixel to more than a tile. */
    POINTS(true),

    /** Lines, mostly polylines, as wide as the points. */
    LINES(true),
}
