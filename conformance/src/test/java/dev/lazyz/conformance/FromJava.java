package dev.lazyz.conformance;

import dev.lazyz.Renderer;
import dev.lazyz.strategies.zbuffer.ZBuffer;

/** How the suite is used from Java; docs/conformance.md shows it. */
class FromJava extends RendererConformance {
    @Override
    public Renderer renderer() {
        return new ZBuffer();
    }
}
