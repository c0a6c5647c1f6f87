package dev.lazyz.conformance.corpus

import dev.lazyz.DepthTest
import dev.lazyz.conformance.oracle.covers
import dev.lazyz.conformance.oracle.fragments

/** Says of a sample whether a certain mistake of a renderer is seen there. */
internal typealias Situation = (CorpusSample) -> Boolean

/** The sample of a [scene] in column [x] and row [y]. */
internal class CorpusSample(private val scene: CorpusScene, private val x: Int, private val y: Int) {
    private val column = 256L * x + 128
    private val row = 256L * y + 128
    private val at = y * scene.raster.width + x

    val depthTest: DepthTest get() = scene.raster.depthTest

    /** The visible shape, or null. */
    val shown: CorpusShape? = scene.shapes.getOrNull(scene.expected.primitive[at])

    /** The shapes that win against the background, nearest first. */
    private val winners: List<CorpusShape> by lazy { scene.frame.fragments(x, y).map { scene.shapes[it] } }

    /** Whether the two nearest shapes have the same depth. */
    val isTie: Boolean get() = winners.size > 1 && depth(winners[0]) == depth(winners[1])

    /** Whether the background shows through what is in front of it. */
    val isBackgroundBlended: Boolean
        get() = scene.background.alpha > 0 && shown?.isTranslucent == true && winners.all { it.isTranslucent }

    /** Whether a shape loses against the background only. */
    val isHiddenByBackground: Boolean
        get() = scene.shapes.any { it !in winners && it.color.alpha > 0 && primitive(it).covers(x, y) }

    /** Whether a shape has the depth of the background, and nothing is nearer. */
    val isBackgroundTie: Boolean
        get() = scene.raster.backgroundDepth.let { depth ->
            scene.expected.depth[at] == depth && scene.shapes.any { primitive(it).covers(x, y) && depth(it) == depth }
        }

    /** The shapes with an edge through the sample, horizontal or not. */
    fun onEdges(isHorizontal: Boolean): List<CorpusShape> = scene.shapes.filter { shape ->
        shape.edges.any { it.isHorizontal == isHorizontal && it.isThrough(column, row) }
    }

    /** Whether floats of 24 bits do not find that the visible shape covers the sample. */
    fun isMissedByFloats(): Boolean = shown?.edges?.any { it.isMissedByFloats(column, row) } == true

    /** Whether integers of 56 bits do not. */
    fun isMissedByIntegers(): Boolean = shown?.edges?.any { it.isMissedByIntegers(column, row) } == true

    /** Whether the visible shape is a sphere with the sample on its outline. */
    fun isOnOutline(): Boolean = (shown as? CorpusSphere)?.height(column, row) == 0L

    /** Whether the visible shape is a line that only the square at this [end] brings to the sample. */
    fun isOnlyAtEnd(end: Int): Boolean = (shown as? CorpusLine)?.isOnlyAtEnd(end, x, y) == true

    private fun primitive(shape: CorpusShape) = scene.frame.primitives[scene.shapes.indexOf(shape)]

    private fun depth(shape: CorpusShape): Int = primitive(shape).depth(x, y)
}

/** Situations for groups of scenes. */
internal object Situations {
    /** On a left or an upper edge, which belongs to the shape; and on a right or a lower one, which does not. */
    val edges: List<Situation> = listOf(false, true).flatMap { isHorizontal ->
        listOf<Situation>(
            { it.shown in it.onEdges(isHorizontal) },
            { it.shown == null && it.onEdges(isHorizontal).isNotEmpty() },
        )
    }

    /** On an edge of two shapes. */
    val sharedEdge: Situation = { it.shown != null && it.onEdges(isHorizontal = false).size > 1 }

    val missedEdges: List<Situation> = listOf({ it.isMissedByFloats() }, { it.isMissedByIntegers() })

    /** A tie with each depth test. */
    val ties: List<Situation> = DepthTest.entries.map { test -> { it.depthTest == test && it.isTie } }

    /** A tie with the background, which wins or loses. */
    val backgroundTies: List<Situation> =
        listOf(true, false).map { isShown -> { it.isBackgroundTie && (it.shown == null) == isShown } }

    val background: Situation = { it.shown == null }

    val lineEnds: List<Situation> =
        listOf({ it.isOnlyAtEnd(0) }, { it.isOnlyAtEnd(1) }, { (it.shown as? CorpusLine)?.isPoint == true })

    val outline: Situation = { it.isOnOutline() }

    /** What is blended with the background: before something hidden by it, each kind, without alpha, mixed, tied. */
    val blended: List<Situation> = listOf<Situation>(
        { it.isHiddenByBackground },
        { it.shown is CorpusPoint },
        { it.shown is CorpusLine },
        { it.shown is CorpusSphere },
        { it.shown?.color?.alpha == 0 },
        { (it.shown as? CorpusPolygon)?.isMixed == true },
        { it.isTie },
    ).map { situation -> { it.isBackgroundBlended && situation(it) } }
}
