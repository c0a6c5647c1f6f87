package dev.lazyz.conformance.broken

import dev.lazyz.Fragment
import dev.lazyz.Shader
import dev.lazyz.strategies.zbuffer.ZBuffer

/** Renderers that are correct except for maps, metallic-roughness materials and tone mapping. */
object BrokenMaps {
    fun oneSetOfCoordinates() = BrokenShading.wrong("one-set-of-coordinates", MapMistakes::readFirstCoordinates)

    /** Returns [shader] with the derivatives of the sample before, which are in [last]. */
    private fun late(shader: Shader, last: Footprint) = Shader {
        val own = Footprint(it)
        if (last.isKnown) last.copyTo(it)
        last.copy(own)
        shader.shade(it)
    }

    /** In fine meshes, derivatives of the sample that was shaded before, which is often one of another triangle. */
    fun footprintOfANeighbour() = BrokenRenderer("footprint-of-a-neighbour") { frame, sink ->
        val last = Footprint()
        val isFine = frame.primitives.size > 1000
        val change = { inside: Inside, changes: Changes ->
            if (isFine) inside.reshade(changes) { late(it, last) }
        }
        BrokenShading.changed(frame, change) { ZBuffer().render(frame, sink) }
    }

    fun tangentsNotTurned() = BrokenShading.wrong("tangents-not-turned", MapMistakes::turnTangentsBack)

    fun metalsArePlastic() = BrokenShading.wrong("metals-are-plastic", MapMistakes::loseMetalness)

    fun spheresNotToned() = BrokenShading.wrong("spheres-not-toned", MapMistakes::loseToneMappingOfSpheres)
}

/** The derivatives of a fragment's texture coordinates. */
private class Footprint() {
    private val numbers = FloatArray(2 * SET)

    /** Whether they are those of a fragment. */
    var isKnown = false
        private set

    constructor(fragment: Fragment) : this() {
        val all = with(fragment) { floatArrayOf(dudx, dvdx, dudy, dvdy, du2dx, dv2dx, du2dy, dv2dy) }
        all.copyInto(numbers)
        isKnown = true
    }

    fun copy(other: Footprint) {
        other.numbers.copyInto(numbers)
        isKnown = other.isKnown
    }

    fun copyTo(fragment: Fragment) {
        fragment.dudx = numbers[0]
        fragment.dvdx = numbers[1]
        fragment.dudy = numbers[2]
        fragment.dvdy = numbers[3]
        fragment.du2dx = numbers[4]
        fragment.dv2dx = numbers[5]
        fragment.du2dy = numbers[6]
        fragment.dv2dy = numbers[7]
    }

    private companion object {
        /** Number of derivatives of a set of coordinates. */
        const val SET = 4
    }
}
