package dev.lazyz.conformance.cases

import dev.lazyz.Primitive
import dev.lazyz.scenes.Tint
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Shader
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.Spans

/**
 * A primitive without any coherence: coverage, depth and colour of a sample are hashes of the sample.
 *
 * It is valid (contract rule 2.8) and the opposite of a polygon: many spans in a row, loose bounds, depth without a
 * linear form, ties at random. A renderer that renders confetti correctly relies only on what the contract guarantees.
 * Immutable and thread safe.
 *
 * @param seed seed of the samples, depths and colours
 * @param levels number of different depths, spread evenly over 0..2^31-1, including both ends; a single depth is in the
 *   middle. 1..2^20
 * @param depthForm depth that replaces the levels, or null. Samples at which its integer part is negative are not
 *   covered. It may therefore be arbitrarily steep, and may wrap around in between
 * @throws IllegalArgumentException if [levels] is out of range
 */
public class Confetti @JvmOverloads constructor(
    private val seed: Int,
    override val columnStart: Int,
    override val columnEnd: Int,
    override val rowStart: Int,
    override val rowEnd: Int,
    private val levels: Int,
    override val depthForm: LinearForm? = null,
) : Primitive {
    private val shader: Shader = Tint(seed)

    init {
        require(levels in 1..MAX_LEVELS) { "levels must be in 1..$MAX_LEVELS: $levels" }
    }

    /** With a single depth, the bounds are as tight as possible: that depth. */
    override val leastDepth: Int get() = if (isLevel) depth(columnStart, rowStart) else 0
    override val greatestDepth: Int get() = if (isLevel) depth(columnStart, rowStart) else Int.MAX_VALUE

    private val isLevel: Boolean
        get() = if (depthForm == null) levels == 1 else depthForm.run { dx == 0L && dy == 0L && c >= 0 }

    override fun spans(y: Int, spans: Spans) {
        if (y < rowStart || y >= rowEnd) return
        for (x in columnStart until columnEnd) if (isCovered(x, y)) spans.add(x, x + 1)
    }

    private fun isCovered(x: Int, y: Int): Boolean =
        Tint.hash(seed, x, y, 0) % 3 != 0 && (depthForm == null || depthForm.at(x, y) >= 0)

    override fun depth(x: Int, y: Int): Int = when {
        depthForm != null -> (depthForm.at(x, y) shr 32).toInt()
        levels == 1 -> Int.MAX_VALUE / 2
        else -> (Tint.hash(seed, x, y, 1).toLong() % levels * Int.MAX_VALUE / (levels - 1)).toInt()
    }

    override fun shade(fragment: Fragment): Unit = shader.shade(fragment)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor = CountingCursor(shader, x, y)

    override fun toString(): String {
        val form = depthForm?.let { ", LinearForm(${code(it.c)}, ${code(it.dx)}, ${code(it.dy)})" }.orEmpty()
        return "Confetti($seed, $columnStart, $columnEnd, $rowStart, $rowEnd, $levels$form)"
    }

    private companion object {
        const val MAX_LEVELS = 1 shl 20
    }
}

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
