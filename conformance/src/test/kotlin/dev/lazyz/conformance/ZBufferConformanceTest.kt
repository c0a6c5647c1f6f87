package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.strategies.zbuffer.ZBuffer

class ZBufferConformanceTest : RendererConformance() {
    override fun renderer(): Renderer = ZBuffer()
}
