package dev.lazyz.shading

import dev.lazyz.Fragment
import dev.lazyz.FragmentBatch
import dev.lazyz.world.material.TextureMap

/** Reads a map at the coordinates of a fragment. Immutable and thread safe. */
internal class MapReader private constructor(map: TextureMap) {
    private val texture = map.texture
    private val isSecond = map.uvSet == 1
    private val transform = map.transform
    private val isTransformed = !map.transform.isIdentity

    /** Stores the components at the fragment in its [Fragment.texel], and returns it. */
    fun read(fragment: Fragment): FloatArray {
        if (isSecond) {
            read(
                fragment.u2, fragment.v2, fragment.du2dx, fragment.dv2dx, fragment.du2dy, fragment.dv2dy,
                fragment.texel,
            )
        } else {
            read(fragment.u, fragment.v, fragment.dudx, fragment.dvdx, fragment.dudy, fragment.dvdy, fragment.texel)
        }
        return fragment.texel
    }

    /** Stores the components at fragment [i] of [batch] in [out]. */
    fun read(batch: FragmentBatch, i: Int, out: FloatArray) = if (isSecond) {
        read(batch.u2[i], batch.v2[i], batch.du2dx[i], batch.dv2dx[i], batch.du2dy[i], batch.dv2dy[i], out)
    } else {
        read(batch.u[i], batch.v[i], batch.dudx[i], batch.dvdx[i], batch.dudy[i], batch.dvdy[i], out)
    }

    private fun read(
        u: Float,
        v: Float,
        dudx: Float,
        dvdx: Float,
        dudy: Float,
        dvdy: Float,
        out: FloatArray,
    ) = if (isTransformed) {
        texture.sample(
            transform.u(u, v),
            transform.v(u, v),
            transform.uu * dudx + transform.uv * dvdx,
            transform.vu * dudx + transform.vv * dvdx,
            transform.uu * dudy + transform.uv * dvdy,
            transform.vu * dudy + transform.vv * dvdy,
            out,
        )
    } else {
        texture.sample(u, v, dudx, dvdx, dudy, dvdy, out)
    }

    companion object {
        /** Returns a reader for [map], or null if there is none. */
        fun of(map: TextureMap?): MapReader? = map?.let { MapReader(it) }
    }
}
