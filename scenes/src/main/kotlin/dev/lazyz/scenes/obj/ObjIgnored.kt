package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.loading.Source

/** Counts the statements that have no effect, for one warning about each kind. */
internal class ObjIgnored {
    private val freeForm = KindCounts()
    private val unknown = KindCounts()

    fun add(keyword: String) {
        when (keyword) {
            in FREE_FORM -> freeForm.add(keyword)
            !in IRRELEVANT -> unknown.add(keyword)
        }
    }

    /** Reports the statements. */
    fun warn(source: Source) {
        if (freeForm.total > 0) {
            source.warn("free-form curves and surfaces are not drawn; their statements are passed over: $freeForm")
        }
        if (unknown.total > 0) source.warn("unknown statements are passed over: $unknown")
    }

    private companion object {
        val FREE_FORM = setOf(
            "bmat", "bsp", "bzp", "cdc", "cdp", "con", "cstype", "ctech", "curv", "curv2", "deg", "end", "hole", "parm",
            "res", "scrv", "sp", "stech", "step", "surf", "trim", "vp",
        )

        /** Statements that do not affect the rendering of polygons: grouping, and display settings of some programs. */
        val IRRELEVANT = setOf("bevel", "c_interp", "d_interp", "lod", "mg")
    }
}
