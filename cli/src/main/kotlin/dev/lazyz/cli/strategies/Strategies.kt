package dev.lazyz.cli.strategies

import dev.lazyz.Capability
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.scenes.text.EditDistance
import dev.lazyz.strategies.Renderers

/** Finds renderers by id and by capability, and checks before the rendering whether a picture fits into memory. */
internal object Strategies {
    /**
     * Returns all renderers.
     *
     * @throws Mistake if two have the same id, or one cannot be loaded
     */
    fun all(): List<Renderer> = try {
        Renderers.all()
    } catch (clash: IllegalStateException) {
        throw Mistake(clash.message.orEmpty())
    } catch (broken: LinkageError) {
        throw Mistake("a renderer on the class path cannot be loaded: $broken\nIs a jar that it needs missing?")
    }

    /** Returns the ids of all renderers. */
    fun ids(): List<String> = all().map { it.id }

    fun find(id: String): Renderer {
        val all = all()
        return all.firstOrNull { it.id == id } ?: throw Mistake(
            "no strategy '$id'${EditDistance.hint(id, ids())}\nSee 'zcli strategies'.",
        )
    }

    /** Returns whether the strategy [id] is built in. */
    fun isBuiltIn(id: String): Boolean = Renderers.builtIn.any { it.id == id }

    /** Returns text about the strategies with [capability]: `hybrid does`, `lazy, flow do`, `no strategy does`. */
    fun supporters(capability: Capability): String {
        val ids = all().filter { capability in it.capabilities }.map { it.id }
        return if (ids.size > 1) ids.joinToString() + " do" else (ids.singleOrNull() ?: "no strategy") + " does"
    }

    /** Returns those of [needs] that are not in [capabilities], each with the strategies that support it; or null. */
    fun missing(needs: Map<String, Capability>, capabilities: Set<Capability>): String? =
        needs.filterValues { it !in capabilities }.ifEmpty { null }?.let { withSupporters(it) }

    /**
     * Returns the options of [needs], each with the strategies that support it: `--select (lists does), --threads (no
     * strategy does)`.
     */
    fun withSupporters(needs: Map<String, Capability>): String =
        needs.entries.joinToString { (option, capability) -> "$option (${supporters(capability)})" }

    /**
     * Throws [Mistake] if [strategy] needs more than the [available] bytes for [picture], including the [kept] bytes
     * per pixel that the caller keeps. [picture] has [aa] x [aa] samples a pixel.
     */
    fun requireMemory(
        strategy: Renderer,
        picture: Region,
        kept: Long = 0,
        available: Long = Runtime.getRuntime().maxMemory(),
        aa: Int = 1,
    ) {
        // Small pictures fit with any strategy
        if (picture.size * (PLENTY + kept) <= available && picture.size <= MAX_ARRAY) return
        val bytes = RenderPlanner.bytesPerSample(strategy) + kept
        val need = bytes * picture.size
        val what = "a picture of ${picture.width}x${picture.height} with strategy '${strategy.id}'"
        if (bytes >= Int.SIZE_BYTES && picture.size > MAX_ARRAY) {
            throw Mistake("$what would have ${picture.size} pixels, and the maximum is $MAX_ARRAY; ${remedy(kept, aa)}")
        }
        if (need > available) {
            val gigabytes = need / (1L shl 30) + 2
            throw Mistake(
                "$what needs ${Bytes.readable(need)} of memory, and Java may use ${Bytes.readable(available)}; " +
                    "${remedy(kept, aa)}, or run it with 'java -Xmx${gigabytes}g -jar zcli.jar ...'",
            )
        }
    }

    private fun remedy(kept: Long, aa: Int): String {
        val fewer = if (aa > 1) "--aa 1 in place of --aa $aa, " else ""
        val smaller = "choose ${fewer}a smaller --size or a --region"
        if (kept > 0) return smaller
        val streaming = all().filter { Capability.CONSTANT_MEMORY in it.capabilities }.map { it.id }
        return "$smaller, or a --strategy that does not keep the picture (${streaming.joinToString()})"
    }

    private const val MAX_ARRAY = Int.MAX_VALUE - 8L

    /** More bytes than any strategy is expected to keep for a pixel. */
    private const val PLENTY = 64L
}
