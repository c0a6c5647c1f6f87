package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.RuleNames
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Renderers that are correct except for normals, light, textures, maps, materials and tone mapping. */
internal object ShadingMistakes {
    private val lit = arrayOf(RuleNames.lit)
    private val litAndInScenes = arrayOf(RuleNames.lit, RuleNames.scenes)
    private val turned = arrayOf(RuleNames.turned)

    val mistakes: List<Mistake> = listOf(
        mistake(
            "normals-not-turned", "lights back faces from the wrong side", turned + lit,
            Inside.Companion::turnNormals,
        ),
        mistake(
            "tangents-not-turned", "reverses normals of back faces, but not tangents", turned,
            MapChanges::turnTangentsBack,
        ),
        mistake("highlights-lost", "light without highlights", turned + lit, Inside.Companion::loseHighlight),
        mistake("emission-lost", "ignores the light that materials emit", lit, Inside.Companion::loseEmission),
        mistake("nearest-texel", "reads the nearest texel instead of mixing four", lit, Inside.Companion::readNearest),
        mistake(
            "interpolates-on-the-screen", "interpolates without perspective", lit,
            Inside.Companion::interpolateOnScreen,
        ),
        mistake(
            "one-set-of-coordinates", "reads all maps at the first texture coordinates", litAndInScenes,
            MapChanges::readFirstCoordinates,
        ),
        mistake(
            "transform-of-maps-lost", "texture coordinates are not transformed", litAndInScenes,
            MapChanges::loseTransforms,
        ),
        mistake("occlusion-lost", "ignores occlusion maps", lit, MapChanges::loseOcclusion),
        mistake("emission-map-lost", "ignores emission maps", litAndInScenes, MapChanges::loseEmissionMap),
        mistake("metals-are-plastic", "all metals are plastic", litAndInScenes, MapChanges::loseMetalness),
        mistake(
            "spheres-not-toned", "tone mapping is left out for spheres", litAndInScenes,
            MapChanges::loseToneMappingOfSpheres,
        ),
        mistake(
            "environment-lost", "metals do not reflect the environment", litAndInScenes,
            LightChanges::loseEnvironment,
        ),
        mistake("cones-lost", "spots shine in all directions", litAndInScenes, LightChanges::loseCones),
        mistake("falloff-lost", "light is equally strong at any distance", litAndInScenes, LightChanges::loseFalloff),
        mistake(
            "visibility-lost", "ignores the visibility of ambient light", litAndInScenes,
            LightChanges::loseVisibility,
        ),
        Mistake(::vertexAlphaIgnored, "blends as if vertex colours were opaque", RuleNames.blended),
        Mistake(
            ::footprintOfANeighbour,
            "reads textures of fine meshes with the derivatives of the sample that was shaded before",
            RuleNames.footprints,
        ),
    )

    /** A mistake in how primitives are shaded, which [change] makes inside each of them. */
    private fun mistake(id: String, what: String, noticedBy: Array<String>, change: (Inside, Changes) -> Unit) =
        Mistake(id, what, *noticedBy) {
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
