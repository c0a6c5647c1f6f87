package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Renderers that are correct except for normals, light, textures, maps, materials and tone mapping. */
internal object ShadingMistakes {
    val mistakes: List<Mistake> = listOf(
        mistake("normals-not-turned", "lights back faces from the wrong side", Inside.Companion::turnNormals),
        mistake(
            "tangents-not-turned", "reverses normals of back faces, but not tangents", MapChanges::turnTangentsBack,
        ),
        mistake("highlights-lost", "light without highlights", Inside.Companion::loseHighlight),
        mistake("emission-lost", "ignores the light that materials emit", Inside.Companion::loseEmission),
        mistake("nearest-texel", "reads the nearest texel instead of mixing four", Inside.Companion::readNearest),
        mistake(
            "interpolates-on-the-screen", "interpolates without perspective", Inside.Companion::interpolateOnScreen,
        ),
        mistake(
            "one-set-of-coordinates",
            "reads all maps at the first texture coordinates",
            MapChanges::readFirstCoordinates,
        ),
        mistake("transform-of-maps-lost", "texture coordinates are not transformed", MapChanges::loseTransforms),
        mistake("occlusion-lost", "ignores occlusion maps", MapChanges::loseOcclusion),
        mistake("emission-map-lost", "ignores emission maps", MapChanges::loseEmissionMap),
        mistake("metals-are-plastic", "all metals are plastic", MapChanges::loseMetalness),
        mistake("spheres-not-toned", "tone mapping is left out for spheres", MapChanges::loseToneMappingOfSpheres),
        mistake("environment-lost", "metals do not reflect the environment", LightChanges::loseEnvironment),
        mistake("cones-lost", "spots shine in all directions", LightChanges::loseCones),
        mistake("falloff-lost", "light is equally strong at any distance", LightChanges::loseFalloff),
        mistake("visibility-lost", "ignores the visibility of ambient light", LightChanges::loseVisibility),
        Mistake(::vertexAlphaIgnored, "blends as if vertex colours were opaque"),
        Mistake(
            ::footprintOfANeighbour,
            "reads textures of fine meshes with the derivatives of the sample that was shaded before",
        ),
    )

    /** A mistake in how primitives are shaded, which [change] makes inside each of them. */
    private fun mistake(id: String, what: String, change: (Inside, Changes) -> Unit) =
        Mistake(id, what) {
            BrokenRenderer(id) { frame, sink -> changed(frame, change) { ZBufferRenderer().render(frame, sink) } }
        }

    fun vertexAlphaIgnored() = BrokenRenderer("vertex-alpha-ignored", setOf(Capability.TRANSPARENCY)) { frame, sink ->
        val change = { inside: Inside, changes: Changes ->
            inside.eachCorner { data, at -> changes.setNumber(data, at + Inside.COLOR + 3, 1.0) }
        }
        changed(frame, change) { ListsRenderer().render(frame, sink) }
    }

    /** In fine meshes, derivatives of the sample that was shaded before, which is often one of another triangle. */
    fun footprintOfANeighbour() = BrokenRenderer("footprint-of-a-neighbour") { frame, sink ->
        val last = Footprint()
        val isFine = frame.primitives.size > 1000
        val change = { inside: Inside, changes: Changes ->
            if (isFine) inside.reshade(changes) { late(it, last) }
        }
        changed(frame, change) { ZBufferRenderer().render(frame, sink) }
    }

    /** Returns [shader] with the derivatives of the sample before, which are in [last]. */
    private fun late(shader: Shader, last: Footprint) = Shader {
        val own = Footprint(it)
        if (last.isKnown) last.copyTo(it)
        last.copy(own)
        shader.shade(it)
    }

    /** Calls [block] while the frame's primitives are changed. */
    internal fun <T> changed(frame: Frame, change: (Inside, Changes) -> Unit, block: () -> T): T =
        Changes().use { changes ->
            for (primitive in frame.primitives) change(Inside(primitive), changes)
            block()
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
