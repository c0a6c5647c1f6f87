package dev.lazyz.conformance.cases

import dev.lazyz.Fragment
import dev.lazyz.Shader
import dev.lazyz.ShadingCursor

/**
 * Steps by counting columns, from the sample at [column], [y] on, so that a renderer that makes one step too many gets
 * another colour.
 */
internal class CountingCursor(private val shader: Shader, private var column: Int, private val y: Int) :
    ShadingCursor {
    override fun step() {
        column++
    }

    override fun shade(fragment: Fragment) {
        fragment.moveTo(column, y)
        shader.shade(fragment)
    }
}
