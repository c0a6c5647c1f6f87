package dev.lazyz.conformance.broken

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Shader
import dev.lazyz.ShadingCursor
import dev.lazyz.strategies.lazy.LazyZBuffer
import dev.lazyz.strategies.zbuffer.ZBuffer
import dev.lazyz.world.material.MipFilter

/** Renderers that are correct except for maps, metallic-roughness materials and tone mapping. */
object BrokenMaps {
    fun oneSetOfCoordinates() = BrokenShading.wrong("one-set-of-coordinates", MapMistakes::readFirstCoordinates)

    /** Derivatives of the sample that was shaded before. */
    fun footprintOfTheLastSample() = reshading("footprint-of-the-last-sample") { shader, _ ->
        late(shader, Footprint())
    }

    /** Returns [shader] with the derivatives of the sample before, which are in [last]. */
    private fun late(shader: Shader, last: Footprint) = Shader {
        val own = Footprint(it)
        if (last.isKnown) last.copyTo(it)
        last.copy(own)
        shader.shade(it)
    }

    /** Derivatives that a surface does not have are those of a surface that was shaded before. */
    fun footprintOfAnotherSurface(): BrokenRenderer {
        val last = Footprint()
        return reshading("footprint-of-another-surface") { shader, _ ->
            Shader {
                val own = Footprint(it)
                own.fillFrom(last)
                last.copy(own)
                own.copyTo(it)
                shader.shade(it)
            }
        }
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

    /** The normal that a map has made is the one that the map changes at the next sample. */
    fun normalOfTheLastSample() = reshading("normal-of-the-last-sample") { shader, inside ->
        val normal = FloatArray(3)
        var row = -1
        if (inside.material?.let { Inside.read(it, "normalMap") } == null) {
            shader
        } else {
            Shader {
                if (it.y == row) {
                    it.normalX = normal[0]
                    it.normalY = normal[1]
                    it.normalZ = normal[2]
                }
                shader.shade(it)
                row = it.y
                normal[0] = it.normalX
                normal[1] = it.normalY
                normal[2] = it.normalZ
            }
        }
    }

    fun tangentsNotTurned() = BrokenShading.wrong("tangents-not-turned", MapMistakes::turnTangentsBack)

    /** Stepped colours lack the attributes that few materials use. */
    fun stepsForgetAttributes() = BrokenColours.coherent("steps-forget-attributes") { frame, options, sink ->
        val isStepped = ThreadLocal.withInitial { false }
        val primitives = frame.primitives.map { Stepped(it, isStepped) }
        val change = { inside: Inside, changes: Changes ->
            inside.reshade(changes) { shader ->
                Shader {
                    if (isStepped.get()) forget(it)
                    shader.shade(it)
                }
            }
        }
        BrokenShading.changed(frame, change) {
            LazyZBuffer(options).render(Frame(frame.raster, primitives, frame.region), sink)
        }
    }

    private fun forget(fragment: Fragment) {
        Footprint().copyTo(fragment)
        fragment.u2 = 0f
        fragment.v2 = 0f
        fragment.tangentX = 0f
        fragment.tangentY = 0f
        fragment.tangentZ = 0f
    }

    private class Stepped(private val whole: Primitive, private val isStepped: ThreadLocal<Boolean>) :
        Primitive by whole {
        override fun shadingCursor(x: Int, y: Int): ShadingCursor? {
            val cursor = whole.shadingCursor(x, y) ?: return null
            var steps = 0
            return object : ShadingCursor {
                override fun step() {
                    steps++
                    cursor.step()
                }

                override fun shade(fragment: Fragment) {
                    isStepped.set(steps > 0)
                    cursor.shade(fragment)
                    isStepped.set(false)
                }
            }
        }
    }

    fun mipFilterLost() = BrokenShading.wrong("mip-filter-lost") { inside, changes ->
        inside.texture?.let { changes.set(it, "mipFilter", MipFilter.NONE) }
    }

    fun transformLost() = BrokenShading.wrong("transform-of-maps-lost", MapMistakes::loseTransforms)

    fun occlusionLost() = BrokenShading.wrong("occlusion-lost", MapMistakes::loseOcclusion)

    fun emissionMapLost() = BrokenShading.wrong("emission-map-lost", MapMistakes::loseEmissionMap)

    fun metalsArePlastic() = BrokenShading.wrong("metals-are-plastic", MapMistakes::loseMetalness)

    fun spheresNotToned() = BrokenShading.wrong("spheres-not-toned", MapMistakes::loseToneMappingOfSpheres)

    private fun reshading(id: String, change: (Shader, Inside) -> Shader) = BrokenShading.wrong(id) { inside, changes ->
        inside.reshade(changes) { change(it, inside) }
    }
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

    /** Replaces the derivatives of each set of coordinates that are all 0 by those of [other]. */
    fun fillFrom(other: Footprint) {
        for (first in listOf(0, SET)) {
            val set = first until first + SET
            if (set.all { numbers[it] == 0f }) for (k in set) numbers[k] = other.numbers[k]
        }
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
