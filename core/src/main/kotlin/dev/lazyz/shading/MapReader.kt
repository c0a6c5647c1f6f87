package dev.lazyz.shading

import dev.lazyz.Fragment
import dev.lazyz.world.TextureMap

/** Reads a map at the coordinates of a fragment. Immutable and thread safe. */
internal class MapReader private constructor(private val map: TextureMap) {
    private val texture = map.texture
    private val transform = map.transform
    private val isTransformed = !map.transform.isIdentity

    /** Stores the components at the fragment in its [Fragment.texel], and returns it. */
    fun read(fragment: Fragment): FloatArray {
        val u = fragment.u
        val v = fragment.v
        if (isTransformed) {
            texture.sample(transform.u(u, v), transform.v(u, v), fragment.texel)
        } else {
            texture.sample(u, v, fragment.texel)
        }
        return fragment.texel
    }

    companion object {
        fun of(map: TextureMap?): MapReader? = map?.let { MapReader(it) }
    }
}
