package example;

import dev.lazyz.Renderer;
import dev.lazyz.conformance.RendererConformance;

/** Runs every rule of the suite on the strategy of the guide. */
class SortedRowsConformanceTest extends RendererConformance {
    @Override
    public Renderer renderer() {
        return new SortedRows();
    }
}
