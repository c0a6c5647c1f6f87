package dev.lazyz.conformance.frames

import dev.lazyz.Raster
import dev.lazyz.conformance.cases.Confetti
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Glass
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.frames.screen.ScreenFrames
import dev.lazyz.conformance.frames.world.WorldFrames
import dev.lazyz.scenes.Tint
import dev.lazyz.spi.Shader
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.ArbitrarySupplier
import net.jqwik.api.Combinators

/**
 * Generators of frames that are difficult to render, for jqwik's `@ForAll` and `@Provide`.
 *
 * All frames shrink: to fewer primitives, smaller rasters and rounder numbers. Sizes are upper bounds, in samples and
 * in primitives. Results include frames without primitives and rasters of one sample. Thread safe.
 */
public object Frames {
    /** Default limit of a raster's sides, in samples. */
    public const val DEFAULT_SIDE: Int = 20

    /** Default limit of the number of primitives of a frame. */
    public const val DEFAULT_PRIMITIVES: Int = 8

    /**
     * Returns rasters of any shape, background, convention, depth test and background depth, with defaults in most
     * cases.
     */
    @JvmStatic
    @JvmOverloads
    public fun rasters(maxWidth: Int = DEFAULT_SIDE, maxHeight: Int = DEFAULT_SIDE): Arbitrary<Raster> =
        Rasters.any(maxWidth, maxHeight)

    /**
     * Returns frames of polygons in screen space, with some [Confetti] among them: tiny to huge, slivers, concave,
     * self-intersecting, with holes, coincident, coplanar, interpenetrating, with shared edges, with vertices exactly
     * on samples and on pixel corners, outside the raster, degenerate, not finite.
     */
    @JvmStatic
    @JvmOverloads
    public fun screen(
        maxWidth: Int = DEFAULT_SIDE,
        maxHeight: Int = DEFAULT_SIDE,
        maxPrimitives: Int = DEFAULT_PRIMITIVES,
    ): Arbitrary<FrameCase> =
        ScreenFrames(maxWidth, maxHeight).cases(rasters(maxWidth, maxHeight), maxPrimitives).withoutEdgeCases()

    /**
     * Returns frames in screen space in which two primitives often have the same depth at a sample, so that the order
     * decides.
     */
    @JvmStatic
    @JvmOverloads
    public fun tied(maxSide: Int = DEFAULT_SIDE, maxPrimitives: Int = DEFAULT_PRIMITIVES): Arbitrary<FrameCase> =
        ScreenFrames(maxSide, maxSide).tiedCases(rasters(maxSide, maxSide), maxPrimitives).withoutEdgeCases()

    /** Returns frames of [Confetti] alone: custom primitives, most without a linear form. */
    @JvmStatic
    @JvmOverloads
    public fun confetti(maxSide: Int = DEFAULT_SIDE, maxPrimitives: Int = DEFAULT_PRIMITIVES): Arbitrary<FrameCase> =
        ScreenFrames(maxSide, maxSide).confettiCases(rasters(maxSide, maxSide), maxPrimitives).withoutEdgeCases()

    /**
     * Returns frames of all kinds in which any number of primitives are [Glass]. Contract rule 5.5 decides what a
     * sample shows, and renderers that do not blend reject such frames (rule 5.6).
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
     * Returns frames of 3D scenes: polygons with and without holes, meshes of one to dozens of triangles, spheres,
     * points and lines, in front of the camera, behind it, and across its near and far planes, with and without
     * perspective. Vertices may have normals, one or two sets of texture coordinates, tangents and colours. Materials
     * have every [dev.lazyz.world.material.Material.Shading], highlights, emission, masks, one side or two; some are of
     * the metallic-roughness model. Textures and other maps have every filter, transformed coordinates and any
     * encoding. Lights are of every kind, with and without falloff. Some scenes have an environment or tone mapping. No
     * primitive is translucent.
     *
     * The camera is directed at the surfaces, so that few frames are empty and most samples are covered more than once.
     *
     * @param maxSurfaces greatest number of surfaces of a scene; a mesh counts as one
     */
    @JvmStatic
    @JvmOverloads
    public fun world(maxSide: Int = DEFAULT_SIDE, maxSurfaces: Int = DEFAULT_PRIMITIVES): Arbitrary<FrameCase> =
        WorldFrames.cases(WorldFrames.rasters(maxSide), maxSurfaces).withoutEdgeCases()

    /**
     * Returns frames of 3D scenes like [world], in which most materials blend
     * ([dev.lazyz.world.material.Material.AlphaMode.BLEND]), with the alpha of the material, its texture or vertex
     * colours. Renderers that do not blend reject most of them.
     */
    @JvmStatic
    @JvmOverloads
    public fun blended(maxSide: Int = DEFAULT_SIDE, maxSurfaces: Int = DEFAULT_PRIMITIVES): Arbitrary<FrameCase> =
        WorldFrames.blended(WorldFrames.rasters(maxSide), maxSurfaces).withoutEdgeCases()

    /** Returns frames as defined by [mix]: kinds, weights, sizes, counts, depth complexity, translucency. */
    @JvmStatic
    public fun of(mix: FrameMix): Arbitrary<FrameCase> = mix.frames()

    /**
     * Returns a shader whose colour and opacity depend on [number], on the sample and on the fragment's interpolated
     * depth. Two primitives or two samples hardly ever have the same colour.
     */
    @JvmStatic
    public fun tint(number: Int): Shader = Tint(number)
}

/** Generates the frames of a parameter of a rule. */
internal abstract class Cases(private val frames: () -> Arbitrary<FrameCase>) : ArbitrarySupplier<FrameCase> {
    override fun get(): Arbitrary<FrameCase> = frames()
}

/** Frames in screen space. */
internal class ScreenCases : Cases({ Frames.screen() })

/** Frames in which the order of submission decides. */
internal class TiedCases : Cases({ Frames.tied() })

/** Frames of eight primitives and at most two rows. */
internal class TwoRowsCases :
    Cases({ Frames.of(FrameMix.of(FrameKind.CONFETTI, FrameKind.COPLANAR).sized(9, 2).counted(8, 8)) })

/** Frames of custom primitives. */
internal class ConfettiCases : Cases({ Frames.confetti() })

/** Frames of 3D scenes. */
internal class WorldCases : Cases({ Frames.world() })

/** Frames of 3D scenes with rows of dozens of samples. */
internal class LongRowCases : Cases({ Frames.world(maxSide = 90, maxSurfaces = 4) })

/** Frames of 3D scenes with faces seen from both sides, with rows of dozens of samples. */
internal class BackFaceCases : Cases({ WorldFrames.turned(WorldFrames.rasters(64)).withoutEdgeCases() })

/** Frames of 3D scenes with blended materials. */
internal class BlendedCases : Cases({ Frames.blended(maxSide = 40, maxSurfaces = 4) })

/** Frames of points and meshes. */
internal class PointCases : Cases({ WorldFrames.dotted(WorldFrames.rasters(40)).withoutEdgeCases() })

/** Frames of lines and meshes. */
internal class LineCases : Cases({ WorldFrames.lined(WorldFrames.rasters(40)).withoutEdgeCases() })

/** Frames of points and lines with blended materials. */
internal class BlendedPointCases : Cases({ WorldFrames.blendedDots(WorldFrames.rasters(24)).withoutEdgeCases() })

/** Frames of all kinds. */
internal class MixedCases :
    Cases({
        Arbitraries.oneOf(listOf(Frames.screen(), Frames.tied(), Frames.confetti(), Frames.world())).withoutEdgeCases()
    })

/** Frames with some translucent primitives. */
internal class TranslucentCases : Cases({ Frames.translucent() })

/** A few frames of all kinds. */
internal class SeveralCases : ArbitrarySupplier<List<FrameCase>> {
    override fun get(): Arbitrary<List<FrameCase>> =
        MixedCases().get().list().ofMinSize(2).ofMaxSize(4).withoutEdgeCases()
}

/** Frames without primitives. */
internal class EmptyCases : Cases({ Frames.screen(maxPrimitives = 0) })

/** Frames of one sample, one row or one column. */
internal class NarrowCases :
    Cases({
        val shapes = listOf(Frames.screen(1, 1), Frames.screen(1, 60), Frames.screen(60, 1))
        Arbitraries.oneOf(shapes).withoutEdgeCases()
    })
