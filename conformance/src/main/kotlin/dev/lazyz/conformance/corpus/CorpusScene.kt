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
internal class CorpusScene(given: Raster, val background: CorpusColor, val shapes: List<CorpusShape>) {
    val raster: Raster = given.withBackground(background.rgba)

    /** The same scene for renderers of the library. */
    val scene: Scene by lazy {
        val far = if (shapes.any { it is CorpusSphere }) CorpusSphere.FAR else 1.0
        Scene(shapes.map { it.surface() }, viewpoint = Camera.screen(0.0, far))
    }

    val frame: Frame by lazy { scene.frame(raster) }

    /** The picture that is right. */
    val expected: Image by lazy { ReferenceRenderer().render(frame) }

    /** Whether the depth test and the depth of the background are the usual ones. */
    val hasUsualDepths: Boolean get() = raster.depthTest == DepthTest.LESS && raster.backgroundDepth == Int.MAX_VALUE

    /** What a program must be able to do to draw it. */
    val tags: List<String> by lazy {
        check(isOpen.isNotEmpty())
        val ofShapes = shapes.flatMap { it.tags }
        val own = listOfNotNull(
            "translucent".takeIf { shapes.any { it.isTranslucent } },
            "background".takeIf { background.alpha > 0 },
            "depth-test".takeUnless { hasUsualDepths },
            "far-vertices".takeIf { shapes.any { shape -> shape.edges.any { it.isFar } } },
            "fine-depth".takeIf { closest < FINE },
        )
        (ofShapes + own).distinct().sorted()
    }

    /** How much a component of a colour may differ. */
    val colorTolerance: Int get() = if ("colors" in tags || "translucent" in tags) 1 else 0

    /** The least difference of depth, not 0, that decides at any sample which is compared. */
    private var closest = Long.MAX_VALUE

    /** At which samples other arithmetic may give another picture, see [isOpen]. In rows from the top. */
    val isOpen: BooleanArray by lazy {
        BooleanArray(raster.width * raster.height) { isOpen(it % raster.width, it / raster.width) }
    }

    /** Returns whether something is compared at a sample in this [situation]. */
    fun shows(situation: Situation): Boolean = (0 until raster.height).any { y ->
        (0 until raster.width).any { x -> situation(CorpusSample(this, x, y)) && !isOpen(x, y) }
    }

    /**
     * Whether other arithmetic may give another picture: within a step of an outline, unless all its vertices are at
     * 16ths of pixels; and where depths that decide differ by at most [CLOSE] units without being exact.
     */
    private fun isOpen(x: Int, y: Int): Boolean =
        isDepthClose(x, y) or shapes.any { !it.isCoarse && it.isNearOutline(x, y) }

    private fun isDepthClose(x: Int, y: Int): Boolean {
        val nearestFirst = frame.fragments(x, y)
        val opaque = nearestFirst.indexOfFirst { !shapes[it].isTranslucent }
        val used = if (opaque < 0) nearestFirst.size else opaque + 1
        fun depth(index: Int) = frame.primitives[index].depth(x, y)
        var isClose = false
        for (i in 0 until used) {
            val nearer = shapes[nearestFirst[i]]
            for (other in nearestFirst.drop(i + 1).filterNot { nearer.isCoplanar(shapes[it]) }) {
                val areLevel = nearer.level != null && shapes[other].level != null
                isClose = isClose(depth(nearestFirst[i]), depth(other), areLevel) or isClose
            }
        }
        for (index in shapes.indices) {
            if (!frame.primitives[index].covers(x, y)) continue
            isClose = isClose(depth(index), raster.backgroundDepth, shapes[index].level != null) or isClose
        }
        return isClose
    }

    /** Notes that these depths decide, and returns whether other arithmetic may decide otherwise. */
    private fun isClose(depth: Int, other: Int, isExact: Boolean): Boolean {
        val gap = gap(depth, other)
        val isClose = gap <= CLOSE && !isExact
        if (gap > 0 && !isClose) closest = minOf(closest, gap)
        return isClose
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

        private fun gap(depth: Int, other: Int): Long = StrictMath.abs(depth.toLong() - other)
    }
}
