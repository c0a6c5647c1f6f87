package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Rgba
import dev.lazyz.Shader
import dev.lazyz.strategies.lists.Lists
import dev.lazyz.strategies.zbuffer.ZBuffer
import dev.lazyz.world.material.TextureFilter

/** Renderers that are correct except for normals, light, textures, masks and blending. */
object BrokenShading {
    fun normalsNotTurned() = wrong("normals-not-turned", Inside.Companion::turnNormals)

    fun highlightsLost() = wrong("highlights-lost", Inside.Companion::loseHighlight)

    fun vertexAlphaIgnored() = blending("vertex-alpha-ignored") { inside, changes ->
        inside.eachCorner { data, at -> changes.setNumber(data, at + Inside.COLOR + 3, 1.0) }
    }

    /** Renders correctly, but primitives that are changed by [change]. */
    internal fun wrong(id: String, change: (Inside, Changes) -> Unit) = BrokenRenderer(id) { frame, sink ->
        changed(frame, change) { ZBuffer().render(frame, sink) }
    }

    private fun blending(id: String, change: (Inside, Changes) -> Unit) =
        BrokenRenderer(id, setOf(Capability.TRANSPARENCY)) { frame, sink ->
            changed(frame, change) { Lists().render(frame, sink) }
        }

    /** Calls [block] while the frame's primitives are changed. */
    internal fun <T> changed(frame: Frame, change: (Inside, Changes) -> Unit, block: () -> T): T =
        Changes().use { changes ->
            for (primitive in frame.primitives) change(Inside(primitive), changes)
            block()
        }
}

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
            inside.texture?.let { changes.set(it, "filter", TextureFilter.NEAREST) }
        }

        fun interpolateOnScreen(inside: Inside, changes: Changes) =
            inside.eachCorner { data, at -> changes.setNumber(data, at + W, 1.0) }
    }
}
