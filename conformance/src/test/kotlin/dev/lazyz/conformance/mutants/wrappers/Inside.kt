package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Primitive
import dev.lazyz.Rgba
import dev.lazyz.spi.Shader
import dev.lazyz.world.material.Texture

/** Temporary changes of fields of the library's objects. */
internal class Changes : AutoCloseable {
    private val undo = ArrayList<() -> Unit>()

    fun set(target: Any, field: String, value: Any?) {
        val accessible = Inside.field(target, field)
        val before = accessible.get(target)
        accessible.set(target, value)
        undo.add { accessible.set(target, before) }
    }

    fun setNumber(data: DoubleArray, at: Int, value: Double) {
        val before = data[at]
        data[at] = value
        undo.add { data[at] = before }
    }

    fun setNumber(data: FloatArray, at: Int, value: Float) {
        val before = data[at]
        data[at] = value
        undo.add { data[at] = before }
    }

    override fun close() {
        for (it in undo.reversed()) it()
    }
}

/**
 * Access to the internals of a primitive made by set-up, which renderers do not see: the place of mistakes in shading.
 */
internal class Inside(primitive: Primitive) {
    /** The primitive if it has a mask. */
    val mask: Any?

    /** The polygon or sphere, or null. */
    private val core: Any?

    init {
        var whole: Any = primitive
        var masked: Any? = null
        while (whole.javaClass.simpleName in WRAPPERS) {
            if (whole.javaClass.simpleName == "MaskedPrimitive") masked = whole
            whole = checkNotNull(read(whole, "whole"))
        }
        mask = masked
        core = whole.takeIf { it.javaClass.simpleName in CORES }
    }

    private val isPlanar: Boolean get() = core?.javaClass?.simpleName == "PlanarPrimitive"

    /** Whether it is a sphere. */
    val isSphere: Boolean get() = core?.javaClass?.simpleName == "SpherePrimitive"

    /** Whether the normals of the vertices are reversed. */
    val isTurned: Boolean get() = isPlanar && read(checkNotNull(core), "normalSign") == -1.0

    /** The shader of the primitive's material, or null. */
    val shader: Any? get() = core?.let { read(it, "shader") }
        ?.takeIf { it.javaClass.simpleName == "MaterialShader" }

    /** The material, or null. */
    val material: Any? get() = shader?.let { read(it, "material") }

    /** The material's texture, or null. */
    val texture: Any? get() = material?.let { read(it, "textureMap") }?.let { read(it, "texture") }

    /** Calls [action] with the numbers of each corner of the reference triangle, and their first index. */
    fun eachCorner(action: (data: DoubleArray, at: Int) -> Unit) {
        if (!isPlanar) return
        val planar = checkNotNull(core)
        val vertices = checkNotNull(read(planar, "vertices"))
        val data = read(vertices, "data") as DoubleArray
        for (corner in read(planar, "corners") as IntArray) action(data, read(vertices, "stride") as Int * corner)
    }

    /** Replaces the shader by what [change] returns for it. */
    fun reshade(changes: Changes, change: (Shader) -> Shader) {
        val whole = core ?: return
        changes.set(whole, "shader", change(read(whole, "shader") as Shader))
    }

    companion object {
        private val WRAPPERS = setOf("MaskedPrimitive", "OpaquePrimitive", "Glass")
        private val CORES = setOf("PlanarPrimitive", "SpherePrimitive")
        private const val W = 3
        const val NORMAL: Int = 7
        const val COLOR: Int = 12

        fun field(target: Any, name: String): java.lang.reflect.Field =
            target.javaClass.getDeclaredField(name).apply { isAccessible = true }

        fun read(target: Any, name: String): Any? = field(target, name).get(target)

        /** Uses the normals of the vertices unchanged for both sides. */
        fun turnNormals(inside: Inside, changes: Changes) {
            if (inside.isPlanar) changes.set(checkNotNull(inside.core), "normalSign", 1.0)
        }

        fun loseHighlight(inside: Inside, changes: Changes) {
            inside.material?.let { changes.set(it, "specular", Rgba.BLACK) }
        }

        fun loseEmission(inside: Inside, changes: Changes) {
            inside.material?.let { changes.set(it, "emission", Rgba.BLACK) }
        }

        fun readNearest(inside: Inside, changes: Changes) {
            inside.texture?.let { changes.set(it, "filter", Texture.Filter.NEAREST) }
        }

        fun interpolateOnScreen(inside: Inside, changes: Changes) =
            inside.eachCorner { data, at -> changes.setNumber(data, at + W, 1.0) }
    }
}

/** Mistakes in lights, in the environment, and in the visibility of ambient light. */
internal object LightChanges {
    fun loseVisibility(inside: Inside, changes: Changes) = eachOwner(inside) { changes.set(it, "visibility", null) }

    /** Spots shine in all directions. */
    fun loseCones(inside: Inside, changes: Changes) = eachVarying(inside) { numbers, at ->
        for (k in 0 until 4) changes.setNumber(numbers, at + CONE + k, 0f)
        changes.setNumber(numbers, at + CONE + 4, 1f)
    }

    /** Lights have the same strength at any distance. */
    fun loseFalloff(inside: Inside, changes: Changes) = eachVarying(inside) { numbers, at ->
        changes.setNumber(numbers, at + FALLOFF, 0f)
    }

    fun loseEnvironment(inside: Inside, changes: Changes) {
        inside.shader?.let { changes.set(physical(it), "environment", null) }
    }

    /** Calls [action] with the numbers of each light, and their first index. */
    private inline fun eachLight(inside: Inside, action: (numbers: FloatArray, at: Int) -> Unit) =
        eachOwner(inside) { owner ->
            val numbers = Inside.read(checkNotNull(Inside.read(owner, "sources")), "numbers") as FloatArray
            for (at in numbers.indices step STRIDE) action(numbers, at)
        }

    /** The same for the lights whose strength depends on the place. */
    private inline fun eachVarying(inside: Inside, action: (numbers: FloatArray, at: Int) -> Unit) =
        eachLight(inside) { numbers, at -> if (numbers[at + KIND] == VARYING) action(numbers, at) }

    /** Calls [action] with what lights the primitive, with each of the two models of light. */
    private inline fun eachOwner(inside: Inside, action: (Any) -> Unit) {
        val shader = inside.shader ?: return
        action(lighting(shader))
        action(physical(shader))
    }

    private fun lighting(shader: Any): Any = checkNotNull(Inside.read(shader, "lighting"))

    private fun physical(shader: Any): Any = checkNotNull(Inside.read(lighting(shader), "physical"))

    // The layout of the numbers of a light
    private const val KIND = 6
    private const val VARYING = 2f
    private const val FALLOFF = 7
    private const val CONE = 9
    private const val STRIDE = 14
}

/** Mistakes in maps, metallic-roughness materials and tone mapping. */
internal object MapChanges {
    /** Reads all maps at the coordinates of the first set. */
    fun readFirstCoordinates(inside: Inside, changes: Changes) = inside.reshade(changes) { shader ->
        Shader {
            it.u2 = it.u
            it.v2 = it.v
            it.du2dx = it.dudx
            it.dv2dx = it.dvdx
            it.du2dy = it.dudy
            it.dv2dy = it.dvdy
            shader.shade(it)
        }
    }

    /** Reverses the normals of back faces, but not their tangents. */
    fun turnTangentsBack(inside: Inside, changes: Changes) {
        if (!inside.isTurned) return
        inside.reshade(changes) { shader ->
            Shader {
                it.tangentX = -it.tangentX
                it.tangentY = -it.tangentY
                it.tangentZ = -it.tangentZ
                it.tangentW = -it.tangentW
                shader.shade(it)
            }
        }
    }

    fun loseTransforms(inside: Inside, changes: Changes) {
        inside.shader?.let { Inside.read(it, "texture") }?.let { changes.set(it, "isTransformed", false) }
    }

    fun loseOcclusion(inside: Inside, changes: Changes) {
        inside.shader?.let { changes.set(it, "occlusionMap", null) }
    }

    fun loseEmissionMap(inside: Inside, changes: Changes) {
        inside.shader?.let { changes.set(it, "emissionMap", null) }
    }

    fun loseMetalness(inside: Inside, changes: Changes) {
        inside.shader?.let { Inside.read(it, "model") }?.let { changes.set(it, "metallic", 0f) }
    }

    /** Leaves out exposure and tone curve in one kind of primitive. */
    fun loseToneMappingOfSpheres(inside: Inside, changes: Changes) {
        if (inside.isSphere) inside.shader?.let { changes.set(it, "toneMapper", null) }
    }
}
