package dev.lazyz.conformance

import dev.lazyz.Depth
import dev.lazyz.DepthConvention
import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.Shader
import dev.lazyz.scenes.Tint
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/**
 * Generators of awkward frames, for jqwik's `@ForAll` and `@Provide`.
 *
 * All shrink: to fewer primitives, smaller rasters and rounder numbers. Sizes are upper bounds, in samples and in
 * primitives; frames without primitives and rasters of one sample are among the results. Thread safe.
 */
public object Frames {
    /** Sides of rasters, in samples, where none are given. */
    public const val DEFAULT_SIDE: Int = 20

    /** Most primitives of a frame, where none are given. */
    public const val DEFAULT_PRIMITIVES: Int = 8

    /** Returns rasters of any shape, background, convention, depth test and background depth, mostly the usual. */
    @JvmStatic
    @JvmOverloads
    public fun rasters(maxWidth: Int = DEFAULT_SIDE, maxHeight: Int = DEFAULT_SIDE): Arbitrary<Raster> {
        val backgrounds = oneOf(Rgba.WHITE, Rgba.TRANSPARENT, Rgba(0.25f, 0.5f, 0.125f, 0.75f))
        val conventions = oneOf(DepthConvention.SMALLER_IS_NEARER, DepthConvention.LARGER_IS_NEARER)
        return Combinators
            .combine(sides(maxWidth), sides(maxHeight), backgrounds, conventions, ints(0, 15), ints(0, 127))
            .`as` { width, height, background, convention, test, depth ->
                val depthTest = DepthTest.entries.getOrElse(test - 12) { convention.nearest }
                val behind = behindAll(depthTest)
                val fromBehind = BACKGROUND_DEPTHS.getOrElse(depth - 112) { 0 }
                val backgroundDepth = if (behind == 0) fromBehind else behind - fromBehind
                Raster(width, height, background, convention, depthTest, backgroundDepth)
            }
    }

    /**
     * Returns frames of polygons given on the screen, with some [Confetti] among them: tiny to huge, slivers, concave,
     * self-crossing, with holes, coincident, coplanar, interpenetrating, with shared edges, with vertices exactly on
     * samples and on pixel corners, off the raster, degenerate, not finite.
     */
    @JvmStatic
    @JvmOverloads
    public fun screen(
        maxWidth: Int = DEFAULT_SIDE,
        maxHeight: Int = DEFAULT_SIDE,
        maxPrimitives: Int = DEFAULT_PRIMITIVES,
    ): Arbitrary<FrameCase> =
        ScreenFrames(maxWidth, maxHeight).cases(rasters(maxWidth, maxHeight), maxPrimitives).withoutEdgeCases()

    /** Returns frames on the screen in which a depth often occurs twice at a sample, so that the order decides. */
    @JvmStatic
    @JvmOverloads
    public fun tied(maxSide: Int = DEFAULT_SIDE, maxPrimitives: Int = DEFAULT_PRIMITIVES): Arbitrary<FrameCase> =
        ScreenFrames(maxSide, maxSide).tiedCases(rasters(maxSide, maxSide), maxPrimitives).withoutEdgeCases()

    /** Returns frames of [Confetti] alone: primitives of one's own, most without a linear form. */
    @JvmStatic
    @JvmOverloads
    public fun confetti(maxSide: Int = DEFAULT_SIDE, maxPrimitives: Int = DEFAULT_PRIMITIVES): Arbitrary<FrameCase> =
        ScreenFrames(maxSide, maxSide).confettiCases(rasters(maxSide, maxSide), maxPrimitives).withoutEdgeCases()

    /**
     * Returns frames of all kinds in which some primitives, most or none are [Glass]: contract rule 5.5 decides what a
     * sample shows, and renderers that do not blend refuse them (rule 5.6).
     */
    @JvmStatic
    @JvmOverloads
    public fun translucent(maxSide: Int = DEFAULT_SIDE, maxPrimitives: Int = DEFAULT_PRIMITIVES): Arbitrary<FrameCase> {
        val kinds = listOf(
            screen(maxSide, maxSide, maxPrimitives),
            tied(maxSide, maxPrimitives),
            confetti(maxSide, maxPrimitives),
            world(maxSide, maxPrimitives),
        )
        return Combinators.combine(Arbitraries.oneOf(kinds), ints(0, 0xFFFF)).`as` { case, choice ->
            case.glazed(choice)
        }
            .withoutEdgeCases()
    }

    /**
     * Returns frames of scenes: polygons with and without holes, meshes of one to dozens of triangles, spheres, in
     * front of the camera, behind it, and across its near and far planes, with and without perspective. Vertices have
     * normals, texture coordinates and colours or not; materials have every [dev.lazyz.world.Shading], highlights, emission,
     * textures, masks, one side or two; lights are of every kind. None is translucent.
     *
     * The camera looks at the surfaces, so that few frames are blank, and most samples are covered more than once.
     *
     * @param maxSurfaces most surfaces of a scene; a mesh is one
     */
    @JvmStatic
    @JvmOverloads
    public fun world(maxSide: Int = DEFAULT_SIDE, maxSurfaces: Int = DEFAULT_PRIMITIVES): Arbitrary<FrameCase> =
        WorldFrames.cases(WorldFrames.rasters(maxSide), maxSurfaces).withoutEdgeCases()

    /**
     * Returns frames of scenes as [world] does, in which most materials blend ([dev.lazyz.world.AlphaMode.BLEND]): with the
     * alpha of the material, of its texture, of vertex colours. Renderers that do not blend refuse most of them.
     */
    @JvmStatic
    @JvmOverloads
    public fun blended(maxSide: Int = DEFAULT_SIDE, maxSurfaces: Int = DEFAULT_PRIMITIVES): Arbitrary<FrameCase> =
        WorldFrames.blended(WorldFrames.rasters(maxSide), maxSurfaces).withoutEdgeCases()

    /** Returns frames as [mix] says: kinds, weights, sizes, counts, depth complexity, translucency. */
    @JvmStatic
    public fun of(mix: FrameMix): Arbitrary<FrameCase> = mix.frames()

    /**
     * Returns a shader whose colour and opacity depend on [number], on the sample and on the fragment's interpolated
     * depth: hardly ever the same for two primitives, or at two samples.
     */
    @JvmStatic
    public fun tint(number: Int): Shader = Tint(number)

    /** The depth that everything passes [test] against: the usual one of a background. */
    internal fun behindAll(test: DepthTest): Int = when (test) {
        DepthTest.LESS, DepthTest.LESS_OR_EQUAL -> Int.MAX_VALUE
        DepthTest.GREATER, DepthTest.GREATER_OR_EQUAL -> 0
    }

    /**
     * How far before the usual depth of a background another may lie, in units: mostly in the middle, where it hides
     * something; at the far plane; and where it hides nearly everything or everything.
     */
    private val BACKGROUND_DEPTHS =
        List(4) { listOf(Int.MAX_VALUE / 2, Int.MAX_VALUE / 2 + 1, Int.MAX_VALUE / 4 + it) }.flatten() +
            listOf(1, Depth.MARGIN, Int.MAX_VALUE - Depth.MARGIN, Int.MAX_VALUE)

    private fun sides(max: Int): Arbitrary<Int> {
        require(max in 1..Raster.MAX_SIDE) { "a side must be in 1..${Raster.MAX_SIDE}: $max" }
        return mixed(2 to ints(1, max), 13 to ints((max + 1) / 2, max), 1 to Arbitraries.just(1))
    }
}
