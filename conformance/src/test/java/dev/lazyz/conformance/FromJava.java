package dev.lazyz.conformance;

import dev.lazyz.Renderer;
import dev.lazyz.strategies.zbuffer.ZBufferRenderer;

/** Use of the suite from Java, as shown in docs/conformance.md. */
class FromJava extends RendererConformance {
    @Override
    public Renderer renderer() {
        return new ZBufferRenderer();
    }
}
