package dev.lazyz.conformance.corpus

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.oracle.covers
import dev.lazyz.conformance.oracle.fragments
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera

/**
 * A scene that a program in any language can draw: a raster, and primitives on the contract's grid. All numbers are
 * whole, so that their text does not depend on the version of Java. Immutable and thread safe.
 *
 * @param given the raster, whose background is not used
 */
internal class CorpusScene(given: Raster, private val background: CorpusColor, val shapes: List<CorpusShape>) {
    val raster: Raster = given.withBackground(background.rgba)

    /** The same scene for renderers of the library. */
    val scene: Scene by lazy {
        val far = if (shapes.any { it is CorpusSphere }) CorpusSphere.FAR else 1.0
        Scene(shapes.map { it.surface() }, viewpoint = Camera.screen(0.0, far))
    }

    val frame: Frame by lazy { scene.frame(raster) }

    /** The picture that is right. */
    val expected: Image by lazy { ReferenceRenderer().render(frame) }

    /** What a program must be able to do to draw it. */
    val tags: List<String> by lazy {
        check(isOpen.isNotEmpty())
        val ofShapes = shapes.flatMap { it.tags }
        val isUsual = raster.depthTest == DepthTest.LESS && raster.backgroundDepth == Int.MAX_VALUE
        val coordinates = shapes.flatMap { it.edges }.flatMap { listOf(it.x0, it.y0, it.x1, it.y1) }
        val own = listOfNotNull(
            "translucent".takeIf { shapes.any { it.isTranslucent } },
            "background".takeIf { background.alpha > 0 },
            "depth-test".takeUnless { isUsual },
            "far-vertices".takeIf { coordinates.any { it !in -FAR_OFF..FAR_OFF } },
            "fine-depth".takeIf { closest in CLOSE + 1L..FINE },
        )
        (ofShapes + own).distinct().sorted()
    }

    /** Whether all vertices are on 16ths of pixels near the raster, so that even floats of 24 bits are exact. */
    private val isCoarse: Boolean get() = shapes.none { it is CorpusSphere } && shapes.flatMap { it.edges }
        .all { edge -> listOf(edge.x0, edge.y0, edge.x1, edge.y1).all { it % 16 == 0L && it in -FAR_OFF..FAR_OFF } }

    /** How much a component of a colour may differ. */
    val colorTolerance: Int get() = if ("colors" in tags || "translucent" in tags) 1 else 0

    /** The least difference of depth that decides at any sample, above [CLOSE]. */
    private var closest = Long.MAX_VALUE

    /**
     * At which samples other arithmetic may give another picture: those within a step of an outline, unless all
     * vertices are on 16ths of pixels; and those at which depths that decide differ by at most [CLOSE]
     * units without being the same plane. In rows from the top.
     */
    val isOpen: BooleanArray by lazy {
        val isExact = isCoarse
        BooleanArray(raster.width * raster.height) { i ->
            val x = i % raster.width
            val y = i / raster.width
            isDepthClose(x, y) or (!isExact && shapes.any { it.isNearOutline(x, y) })
        }
    }

    private fun isDepthClose(x: Int, y: Int): Boolean {
        val nearestFirst = frame.fragments(x, y)
        val opaque = nearestFirst.indexOfFirst { !shapes[it].isTranslucent }
        val deciding = if (opaque < 0) nearestFirst else nearestFirst.take(opaque + 2)
        var isClose = shapes.indices.any { isCloseToBackground(it, x, y) }
        for ((nearer, farther) in deciding.zipWithNext()) {
            if (shapes[nearer].isCoplanar(shapes[farther])) continue
            val gap = gap(frame.primitives[nearer].depth(x, y), frame.primitives[farther].depth(x, y))
            if (gap <= CLOSE) isClose = true else closest = minOf(closest, gap)
        }
        return isClose
    }

    private fun isCloseToBackground(index: Int, x: Int, y: Int): Boolean {
        val shape = shapes[index]
        if (shape is CorpusPoint || (shape as? CorpusPolygon)?.isLevel(raster.backgroundDepth) == true) return false
        val primitive = frame.primitives[index]
        return primitive.covers(x, y) && gap(primitive.depth(x, y), raster.backgroundDepth) <= CLOSE
    }

    /** Returns the scene as JSON, with these [members] at the beginning. */
    fun json(members: String): String = buildString {
        val test = raster.depthTest.name.lowercase().replace('_', '-')
        appendLine("{$members")
        appendLine(" \"tags\": ${tags.map { "\"$it\"" }},")
        appendLine(" \"width\": ${raster.width}, \"height\": ${raster.height}, \"depth_test\": \"$test\",")
        appendLine(" \"background\": $background, \"background_depth\": ${raster.backgroundDepth},")
        appendLine(" \"tolerance\": {\"color\": $colorTolerance, \"depth\": $DEPTH_TOLERANCE},")
        append(" \"primitives\": [")
        append(shapes.joinToString(",") { "\n  {${it.members}, ${it.look}, \"translucent\": ${it.isTranslucent}}" })
        appendLine("]}")
    }

    /** Returns [actual] with the expected values wherever it is within the tolerance. */
    fun tolerated(actual: Image): Image {
        fun isWithin(i: Int): Boolean = isOpen[i] || (
            actual.primitive[i] == expected.primitive[i] && isNear(actual.argb[i], expected.argb[i]) &&
                gap(actual.depth[i], expected.depth[i]) <= DEPTH_TOLERANCE
            )
        fun mixed(own: IntArray, right: IntArray) = IntArray(own.size) { if (isWithin(it)) right[it] else own[it] }
        return Image(
            expected.region, mixed(actual.argb, expected.argb), mixed(actual.depth, expected.depth),
            mixed(actual.primitive, expected.primitive), actual.counters,
        )
    }

    private fun isNear(argb: Int, other: Int): Boolean = (0..24 step 8).all {
        StrictMath.abs((argb ushr it and 0xFF) - (other ushr it and 0xFF)) <= colorTolerance
    }

    override fun toString(): String = json("")

    companion object {
        /** Greatest difference of depth to the expected one, in units: both are within a unit of exact arithmetic. */
        const val DEPTH_TOLERANCE: Int = 1

        /** Depths that differ by at most this may be in another order in other arithmetic, in units. */
        private const val CLOSE = 2L

        /** Differences of depth below this need more than 24 bits, in units. */
        private const val FINE = 4096L

        /** In grid steps: 64 pixels. */
        private const val FAR_OFF = 64L * 256

        private fun gap(depth: Int, other: Int): Long = StrictMath.abs(depth.toLong() - other)
    }
}
