package dev.lazyz.strategies.tiled

import dev.lazyz.strategies.tiled.binning.ScalarSmallTriangleKernel
import dev.lazyz.strategies.tiled.binning.SmallTriangleKernel
import dev.lazyz.strategies.tiled.binning.VectorSmallTriangleKernel
import dev.lazyz.strategies.tiled.raster.BlockKernel
import dev.lazyz.strategies.tiled.raster.ScalarBlockKernel
import dev.lazyz.strategies.tiled.raster.VectorBlockKernel
import dev.lazyz.strategies.tiled.resolve.FragmentKernel
import dev.lazyz.strategies.tiled.resolve.ScalarFragmentKernel
import dev.lazyz.strategies.tiled.resolve.VectorFragmentKernel

/**
 * Implementations of the innermost loops of [TiledRenderer]. All give the same bits. Each kernel belongs to one thread.
 */
internal enum class Kernels {
    /** Loops that run on any JVM. */
    SCALAR,

    /** Loops for JVMs with the module `jdk.incubator.vector`. */
    VECTOR,

    ;

    /** Returns the loops that compute the coverage of small triangles. */
    fun coverage(): SmallTriangleKernel = if (this == VECTOR) {
        VectorSmallTriangleKernel()
    } else {
        ScalarSmallTriangleKernel()
    }

    /** Returns the loops that draw blocks. */
    fun blocks(): BlockKernel = if (this == VECTOR) VectorBlockKernel() else ScalarBlockKernel()

    /** Returns the loops over visible samples. */
    fun fragments(): FragmentKernel = if (this == VECTOR) VectorFragmentKernel() else ScalarFragmentKernel()

    companion object {
        /** Returns the fastest that this JVM currently offers: modules can be added at run time. */
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
