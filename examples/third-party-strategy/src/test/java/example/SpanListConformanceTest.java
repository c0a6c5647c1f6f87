package example;

import dev.lazyz.Renderer;
import dev.lazyz.conformance.RendererConformance;

/** Runs every rule of the suite on this project's renderer. */
class SpanListConformanceTest extends RendererConformance {
    @Override
    public Renderer renderer() {
        return new SpanListRenderer();
    }
}
