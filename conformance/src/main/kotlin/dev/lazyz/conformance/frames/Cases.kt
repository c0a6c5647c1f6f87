package dev.lazyz.conformance.frames

import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.frames.world.WorldFrames
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.ArbitrarySupplier

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
