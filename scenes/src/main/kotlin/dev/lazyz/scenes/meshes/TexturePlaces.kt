package dev.lazyz.scenes.meshes

import dev.lazyz.geometry.DistinctTriples

/** Numbers the distinct texture coordinates of a file from 0. Not thread safe. */
internal class TexturePlaces {
    private val places = DistinctTriples()

    /** Returns the number of these coordinates, a new number if the coordinates are new. */
    fun add(u: Float, v: Float): Int = places.add(u.toBits(), v.toBits(), 0)

    /** Writes the two components of coordinates [number] to [to], starting at index [at]. */
    fun copy(number: Int, to: FloatArray, at: Int) {
        for (axis in 0 until 2) to[at + axis] = Float.fromBits(places.get(number, axis))
    }
}
