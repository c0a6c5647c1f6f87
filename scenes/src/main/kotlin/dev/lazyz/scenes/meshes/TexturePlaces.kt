package dev.lazyz.scenes.meshes

import dev.lazyz.geometry.DistinctTriples

/** Numbers the different texture coordinates of a file from 0. Not thread safe. */
internal class TexturePlaces {
    private val places = DistinctTriples()

    /** Returns the number of these coordinates, new ones if they are not there yet. */
    fun add(u: Float, v: Float): Int = places.add(u.toBits(), v.toBits(), 0)

    /** Writes the two numbers of coordinates [number] to [to], from [at] on. */
    fun copy(number: Int, to: FloatArray, at: Int) {
        for (axis in 0 until 2) to[at + axis] = Float.fromBits(places.get(number, axis))
    }
}
