package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.run.RunUnderWay

/** The suite for the renderer of the run in progress. Instantiated by jqwik. */
internal class SubjectOfRun : RendererConformance() {
    override fun renderer(): Renderer = checkNotNull(RunUnderWay.current) { "no run is in progress" }.make.get()
}
