package dev.lazyz.strategies.tiled

import dev.lazyz.strategies.tiled.binning.CoverageKernel
import dev.lazyz.strategies.tiled.binning.ScalarCoverageKernel
import dev.lazyz.strategies.tiled.binning.VectorCoverageKernel
import dev.lazyz.strategies.tiled.raster.BlockKernel
import dev.lazyz.strategies.tiled.raster.ScalarBlockKernel
import dev.lazyz.strategies.tiled.raster.VectorBlockKernel
import dev.lazyz.strategies.tiled.resolve.FragmentKernel
import dev.lazyz.strategies.tiled.resolve.ScalarFragmentKernel
import dev.lazyz.strategies.tiled.resolve.VectorFragmentKernel

/** The makes of the innermost loops of [Tiled]. All give the same bits. What they make belongs to one thread. */
internal enum class Kernels {
    /** Those that any JVM runs. */
    SCALAR,

    /** Those for JVMs with the module `jdk.incubator.vector`. */
    VECTOR,

    ;

    /** Returns the loops that find out what small triangles cover. */
    fun coverage(): CoverageKernel = if (this == VECTOR) VectorCoverageKernel() else ScalarCoverageKernel()

    /** Returns the loops that draw blocks. */
    fun blocks(): BlockKernel = if (this == VECTOR) VectorBlockKernel() else ScalarBlockKernel()

    /** Returns the loops over visible samples. */
    fun fragments(): FragmentKernel = if (this == VECTOR) VectorFragmentKernel() else ScalarFragmentKernel()

    companion object {
        /** Returns the fastest that this JVM offers now: a module may come to one that runs. */
        fun best(): Kernels = if (hasVectors()) VECTOR else SCALAR

        /** Whether the JVM's own class loaders find the Vector API, and its vectors are wide enough. */
        private fun hasVectors(): Boolean = try {
            Class.forName("jdk.incubator.vector.LongVector", false, ClassLoader.getPlatformClassLoader())
            VectorBlockKernel.isUseful
        } catch (_: ClassNotFoundException) {
            false
        }
    }
}
