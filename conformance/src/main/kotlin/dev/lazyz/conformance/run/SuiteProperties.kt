package dev.lazyz.conformance.run

/** Names of the system properties of the suite, documented in `RendererConformance` and `Waivers`. */
internal object SuiteProperties {
    const val TRIES: String = "lazyz.conformance.tries"
    const val SEED: String = "lazyz.conformance.seed"
    const val DEADLINE: String = "lazyz.conformance.deadline"
    const val FRAMES: String = "lazyz.conformance.frames"
    const val OUTPUT: String = "lazyz.conformance.output"
}
