package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

class ZBufferConformanceTest : RendererConformance() {
    override fun renderer(): Renderer = ZBufferRenderer()
}
