package dev.lazyz.conformance.cases.changed

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.UncoveredPrimitive
import dev.lazyz.conformance.cases.code
import dev.lazyz.world.surface.Polygon
import java.util.Random

/** Returns the same scene, or else the same primitives, on [raster], which must have the same size. */
internal fun FrameCase.on(raster: Raster): FrameCase = codedScene?.let { FrameCase(it, raster) }
    ?: FrameCase(
        Frame(raster, frame.primitives),
        "$code\n    .let { Frame(${code(raster)}, it.primitives) }",
        scene.takeIf { raster.convention == frame.raster.convention },
    )

/** Returns this case with the equivalent [frame], whose primitives are observed. */
internal fun FrameCase.watched(frame: Frame): FrameCase = FrameCase(frame, code, scene)

/** Returns the part of the frame within [region]. */
internal fun FrameCase.within(region: Region): FrameCase = FrameCase(
    frame.within(region),
    "$code\n    .within(Region(${region.columnStart}, ${region.rowStart}, ${region.columnEnd}, ${region.rowEnd}))",
    scene,
)

/** Returns a random part of the frame, at least one sample. */
internal fun FrameCase.withinAny(random: Random): FrameCase {
    val raster = frame.raster
    val columnStart = random.nextInt(raster.width)
    val rowStart = random.nextInt(raster.height)
    val columnEnd = columnStart + 1 + random.nextInt(raster.width - columnStart)
    val rowEnd = rowStart + 1 + random.nextInt(raster.height - rowStart)
    return within(Region(columnStart, rowStart, columnEnd, rowEnd))
}

/**
 * Returns two halves of the frame of equal size, side by side or one above the other; empty if the frame is too small.
 */
internal fun FrameCase.halves(): List<FrameCase> {
    val raster = frame.raster
    val isWide = raster.width >= raster.height
    val width = if (isWide) raster.width / 2 else raster.width
    val height = if (isWide) raster.height else raster.height / 2
    if (width == 0 || height == 0) return emptyList()
    val second = Region(raster.width - width, raster.height - height, raster.width, raster.height)
    return listOf(within(Region(0, 0, width, height)), within(second))
}

/** Returns the frame with only those primitives whose index has the given [parity], 0 or 1. */
internal fun FrameCase.keeping(parity: Int): FrameCase =
    FrameCase(
        frame.keeping { it % 2 == parity },
        "$code\n    .keeping { it % 2 == $parity }",
        sceneOf { surfaces -> surfaces.mapIndexed { i, it -> if (i % 2 == parity) it else Polygon(emptyList()) } },
    )

/** Returns the frame with only the primitive [index], which keeps its index. */
internal fun FrameCase.alone(index: Int): FrameCase =
    FrameCase(
        frame.keeping { it == index },
        "$code\n    .keeping { it == $index }",
        sceneOf { surfaces -> surfaces.mapIndexed { i, it -> if (i == index) it else Polygon(emptyList()) } },
    )

/** Returns the frame in which the primitive with the index `order[i]` gets the index i. */
internal fun FrameCase.inOrder(order: List<Int>): FrameCase = FrameCase(
    Frame(frame.raster, order.map { frame.primitives[it] }),
    "$code\n    .let { Frame(it.raster, listOf<Int>(${order.joinToString()}).map(it.primitives::get)) }",
    sceneOf { surfaces -> order.map { surfaces[it] } },
)

/** Returns the frame with a primitive that covers nothing, but has the raster's bounds, before each primitive. */
internal fun FrameCase.padded(): FrameCase = FrameCase(
    Frame(frame.raster, frame.primitives.flatMap { listOf(UncoveredPrimitive(frame.raster), it) }),
    "$code\n    .let { SuiteFrames.padded(it) }",
)

/** Returns the frame without translucency. */
internal fun FrameCase.asOpaque(): FrameCase = FrameCase(frame.asOpaque(), "$code\n    .asOpaque()")

/** Returns this picture with other indices for its primitives. The background's index is unchanged. */
internal fun Image.renumbered(number: (Int) -> Int): Image {
    val primitive = IntArray(primitive.size) {
        if (primitive[it] == DepthTest.BACKGROUND) DepthTest.BACKGROUND else number(primitive[it])
    }
    return Image(region, argb, depth, primitive, counters)
}

/** Returns this picture of [raster] in the lower right corner of one that is [right] columns and [down] rows larger. */
internal fun Image.moved(right: Int, down: Int, raster: Raster): Image {
    val wide = width + right
    fun row(values: IntArray, empty: Int) = IntArray(wide * (height + down)) {
        val x = it % wide - right
        val y = it / wide - down
        if (x < 0 || y < 0) empty else values[y * width + x]
    }
    return Image(
        wide,
        height + down,
        row(argb, raster.background.toArgb()),
        row(depth, raster.backgroundDepth),
        row(primitive, DepthTest.BACKGROUND),
        counters,
    )
}
