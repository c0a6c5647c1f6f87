package dev.lazyz.conformance

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.Spans
import dev.lazyz.world.Polygon
import java.util.Random
import java.util.concurrent.CyclicBarrier
import java.util.concurrent.ExecutionException
import java.util.concurrent.Executors

/**
 * What [renderer] makes of [case]. A failure says who did what, and how to make the frame.
 *
 * @param how what is special about this renderer, or nothing
 */
internal class Judgement(private val renderer: Renderer, private val case: FrameCase, private val how: String = "") {
    init {
        Trial.current?.saw(case, how)
    }

    private val isAgain = Trial.current?.isAgain(renderer) ?: false

    /** The frame, rendered row by row. */
    val rendering: Rendering = attempt { Rendering.of(renderer, case.frame) }

    /** Fails unless the frame came out as the oracle says, bit for bit. */
    fun equalsReference(): Judgement = equalsPictureOf(ReferenceRenderer())

    /** Fails unless the frame came out as [oracle] has it, bit for bit. */
    fun equalsPictureOf(oracle: Renderer): Judgement = apply {
        val expected = Rendering.of(oracle, case.frame).image
        difference(expected, rendering.image)?.let { fail("", it) }
    }

    /** Fails unless the frame comes out the same when it is rendered into memory. */
    fun equalsItsImage(): Judgement = apply {
        val image = attempt { renderer.render(case.frame) }
        if (image.region != rendering.image.region) fail("into memory: ${differenceInWords(rendering.image, image)}")
        difference(rendering.image, image)?.let { fail("into memory: ", it) }
    }

    /** Fails unless the rows of the frame's region arrived from the top to the bottom, each once. */
    fun rowsInOrder(): Judgement = apply {
        val expected = (case.frame.region.rowStart until case.frame.region.rowEnd).toList()
        if (rendering.rows != expected) fail("rows arrived as ${rendering.rows}, not as $expected")
    }

    /** Fails because of [what]. */
    fun fail(what: String, cause: Throwable? = null): Nothing {
        val expected = Rendering.of(ReferenceRenderer(), case.frame).image
        throw violation(what, expected, rendering.image, cause)
    }

    /** Fails because of a [difference]; [lead] says what of. */
    fun fail(lead: String, difference: Difference): Nothing =
        throw violation("$lead$difference", difference.expected, difference.actual, null)

    private fun violation(what: String, expected: Image?, actual: Image?, cause: Throwable?) =
        Violation(message(what), case, expected, actual, cause, isConfigured = how.isNotEmpty(), isAgain = isAgain)

    private fun message(what: String): String =
        "${renderer.id}${if (how.isEmpty()) "" else " with $how"}: $what\nin\n$case"

    private fun <T> attempt(block: () -> T): T = try {
        block()
    } catch (e: Throwable) {
        throw violation("threw $e", null, null, e)
    }
}

/** The same primitives on [raster], which has the same size. */
internal fun FrameCase.on(raster: Raster): FrameCase =
    FrameCase(
        Frame(raster, frame.primitives),
        "$code\n    .let { Frame(${code(raster)}, it.primitives) }",
        scene.takeIf { raster.convention == frame.raster.convention },
    )

/** The same frame, whose primitives are watched. */
internal fun FrameCase.watched(frame: Frame): FrameCase = FrameCase(frame, code, scene)

/** The part of the frame within [region]. */
internal fun FrameCase.within(region: Region): FrameCase = FrameCase(
    frame.within(region),
    "$code\n    .within(Region(${region.columnStart}, ${region.rowStart}, ${region.columnEnd}, ${region.rowEnd}))",
    scene,
)

/** A part of the frame that [random] chooses, a sample at least. */
internal fun FrameCase.withinAny(random: Random): FrameCase {
    val raster = frame.raster
    val columnStart = random.nextInt(raster.width)
    val rowStart = random.nextInt(raster.height)
    val columnEnd = columnStart + 1 + random.nextInt(raster.width - columnStart)
    val rowEnd = rowStart + 1 + random.nextInt(raster.height - rowStart)
    return within(Region(columnStart, rowStart, columnEnd, rowEnd))
}

/** The two halves of the frame, which have the same size, beside each other or above each other; none if it is too small. */
internal fun FrameCase.halves(): List<FrameCase> {
    val raster = frame.raster
    val isWide = raster.width >= raster.height
    val width = if (isWide) raster.width / 2 else raster.width
    val height = if (isWide) raster.height else raster.height / 2
    if (width == 0 || height == 0) return emptyList()
    val second = Region(raster.width - width, raster.height - height, raster.width, raster.height)
    return listOf(within(Region(0, 0, width, height)), within(second))
}

/** The part of the frame that [parity] is the parity of the primitives' indices in. */
internal fun FrameCase.keeping(parity: Int): FrameCase =
    FrameCase(
        frame.keeping { it % 2 == parity },
        "$code\n    .keeping { it % 2 == $parity }",
        sceneOf { surfaces -> surfaces.mapIndexed { i, it -> if (i % 2 == parity) it else Polygon(emptyList()) } },
    )

/** The part of the frame with the one primitive [index], which keeps its number. */
internal fun FrameCase.alone(index: Int): FrameCase =
    FrameCase(
        frame.keeping { it == index },
        "$code\n    .keeping { it == $index }",
        sceneOf { surfaces -> surfaces.mapIndexed { i, it -> if (i == index) it else Polygon(emptyList()) } },
    )

/** The primitive that was number `order[i]` becomes number i. */
internal fun FrameCase.inOrder(order: List<Int>): FrameCase = FrameCase(
    Frame(frame.raster, order.map { frame.primitives[it] }),
    "$code\n    .let { Frame(it.raster, listOf<Int>(${order.joinToString()}).map(it.primitives::get)) }",
    sceneOf { surfaces -> order.map { surfaces[it] } },
)

/** Before each primitive comes one that covers nothing, whatever its bounds. */
internal fun FrameCase.padded(): FrameCase = FrameCase(
    Frame(frame.raster, frame.primitives.flatMap { listOf(NothingThere(frame.raster), it) }),
    "$code // and before each primitive one that covers nothing, with the raster's bounds",
)

/** The same frame without translucency. */
internal fun FrameCase.asOpaque(): FrameCase = FrameCase(frame.asOpaque(), "$code\n    .asOpaque()")

/** Fails unless [renderer] refuses [case], naming a translucent primitive by its index, before it hands out a row. */
internal fun refused(renderer: Renderer, case: FrameCase) {
    var rows = 0
    val answer = try {
        renderer.render(case.frame) { _, _, _, _ -> rows++ }
        "renders it"
    } catch (e: IllegalArgumentException) {
        val index = case.frame.primitives.indexOfFirst { it.isTranslucent }
        val isNamed = Regex("\\b[0-9]+\\b").findAll(e.message.orEmpty()).any { isTranslucent(case, it.value) }
        if (rows == 0 && isNamed) return
        if (rows > 0) "hands out $rows rows before it refuses" else "does not name primitive $index: ${e.message}"
    } catch (e: Exception) {
        "throws $e"
    }
    throw Violation("${renderer.id} does not blend, and $answer\nin\n$case", case)
}

private fun isTranslucent(case: FrameCase, index: String): Boolean =
    case.frame.primitives.getOrNull(index.toIntOrNull() ?: -1)?.isTranslucent == true

/** Whether the primitives [a] and [b] both cover column [x] of row [y], at the same depth. */
internal fun Frame.isTie(a: Int, b: Int, x: Int, y: Int): Boolean =
    covers(a, x, y) && covers(b, x, y) && primitives[a].depth(x, y) == primitives[b].depth(x, y)

private fun Frame.covers(index: Int, x: Int, y: Int): Boolean {
    val spans = Spans()
    primitives.getOrNull(index)?.spans(y, spans)
    return (0 until spans.count).any { x >= spans.start(it) && x < spans.end(it) }
}

/** Calls [block] for each of [cases] in a thread of its own, all at the same time. Fails as the first that fails. */
internal fun <T> atOnce(cases: List<T>, block: (T) -> Unit) {
    val threads = Executors.newFixedThreadPool(cases.size) { Thread(it).apply { isDaemon = true } }
    try {
        val barrier = CyclicBarrier(cases.size)
        val results = cases.map { case ->
            threads.submit {
                barrier.await()
                block(case)
            }
        }
        for (result in results) result.get()
    } catch (e: ExecutionException) {
        throw e.cause ?: e
    } finally {
        threads.shutdownNow()
    }
}
