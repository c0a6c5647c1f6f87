package dev.lazyz.tiled

/**
 * The innermost loops of [Tiled], all of one make. All makes give the same bits. Belongs to one thread.
 *
 * @property isVector whether the loops are written with the Vector API
 */
internal class Kernels(
    val isVector: Boolean,
    val coverage: CoverageKernel,
    val blocks: BlockKernel,
    val fragments: FragmentKernel,
) {
    companion object {
        private val hasVectors: Boolean =
            ModuleLayer.boot().findModule("jdk.incubator.vector").isPresent && VectorBlockKernel.isUseful

        /** Returns the fastest that this JVM offers. */
        fun best(): Kernels = if (hasVectors) vector() else scalar()

        /** Returns those that any JVM runs. */
        fun scalar(): Kernels = Kernels(false, ScalarCoverageKernel(), ScalarBlockKernel(), ScalarFragmentKernel())

        /** Returns those for JVMs with the module `jdk.incubator.vector`. */
        fun vector(): Kernels = Kernels(true, VectorCoverageKernel(), VectorBlockKernel(), VectorFragmentKernel())
    }
}
