package dev.lazyz.conformance.mutants

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** A renderer with one mistake. */
open class BrokenRenderer(
    override val id: String,
    override val capabilities: Set<Capability> = emptySet(),
    private val options: ((RenderOptions) -> Renderer)? = null,
    private val how: (Frame, RowSink) -> Counters,
) : Renderer {
    override val summary: String get() = "makes one mistake: $id"

    override fun configured(options: RenderOptions): Renderer =
        this.options?.invoke(options.requireSupportedBy(this)) ?: super.configured(options)

    override fun render(frame: Frame, sink: RowSink): Counters = how(frame, sink)

    override fun toString(): String = id
}

/** Changes a correct picture before it delivers it. */
internal fun painting(id: String, change: (Image, Frame) -> Image) = BrokenRenderer(id) { frame, sink ->
    emit(change(ZBufferRenderer().render(frame), frame), sink)
}

/** Renders a changed frame. */
internal fun drawing(id: String, change: (Frame) -> Frame) =
    BrokenRenderer(id) { frame, sink -> ZBufferRenderer().render(change(frame), sink) }

/** Replaces primitives by what [change] returns for them. */
internal fun primitives(id: String, change: (Primitive) -> Primitive) =
    drawing(id) { Frame(it.raster, it.primitives.map(change), it.region) }

/** Delivers the rows of the correct picture in the [order] for their number. */
internal fun rows(id: String, order: (Int) -> List<Int>) =
    BrokenRenderer(id) { frame, sink -> emit(ZBufferRenderer().render(frame), sink, order(frame.height)) }

/** Renders correctly, but changes the counters by [change]. */
internal fun counting(id: String, change: Counters.Builder.(Image) -> Unit) = BrokenRenderer(id) { frame, sink ->
    val image = ZBufferRenderer().render(frame)
    emit(image, sink).toBuilder().apply { change(image) }.build()
}

/** Delivers [rows] of an image. */
internal fun emit(image: Image, sink: RowSink, rows: List<Int> = (0 until image.height).toList()): Counters {
    for (row in rows) {
        val (argb, depth, primitive) = listOf(image.argb, image.depth, image.primitive).map {
            it.copyOfRange(row * image.width, (row + 1) * image.width)
        }
        sink.row(image.region.rowStart + row, argb, depth, primitive)
    }
    return image.counters
}

/** Returns the frame on another raster. */
internal fun Frame.on(change: Raster.() -> Raster) = Frame(raster.change(), primitives, region)

/** Returns the test that differs only for ties. */
internal fun swappedTies(test: DepthTest) = when (test) {
    DepthTest.LESS -> DepthTest.LESS_OR_EQUAL
    DepthTest.LESS_OR_EQUAL -> DepthTest.LESS
    DepthTest.GREATER -> DepthTest.GREATER_OR_EQUAL
    DepthTest.GREATER_OR_EQUAL -> DepthTest.GREATER
}
