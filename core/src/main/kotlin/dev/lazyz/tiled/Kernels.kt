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
        /** Returns the fastest that this JVM offers now: a module may come to one that runs. */
        fun best(): Kernels = if (hasVectors()) vector() else scalar()

        /** Whether the JVM's own class loaders find the Vector API, and its vectors are wide enough. */
        private fun hasVectors(): Boolean = try {
            Class.forName("jdk.incubator.vector.LongVector", false, ClassLoader.getPlatformClassLoader())
            VectorBlockKernel.isUseful
        } catch (_: ClassNotFoundException) {
            false
        }

        /** Returns those that any JVM runs. */
        fun scalar(): Kernels = Kernels(false, ScalarCoverageKernel(), ScalarBlockKernel(), ScalarFragmentKernel())

        /** Returns those for JVMs with the module `jdk.incubator.vector`. */
        fun vector(): Kernels = Kernels(true, VectorCoverageKernel(), VectorBlockKernel(), VectorFragmentKernel())
    }
}
