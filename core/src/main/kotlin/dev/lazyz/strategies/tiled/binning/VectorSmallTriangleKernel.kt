package dev.lazyz.strategies.tiled.binning

import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.strategies.tiled.raster.SmallCoverage
import jdk.incubator.vector.IntVector
import jdk.incubator.vector.VectorOperators
import jdk.incubator.vector.VectorSpecies

private val INTS: VectorSpecies<Int> = IntVector.SPECIES_PREFERRED
private val LANES: Int = INTS.length()

/**
 * Processes as many triangles at once as a vector has lanes; see [SmallCoverage] for the arithmetic. Can only be loaded
 * if the JVM has the module `jdk.incubator.vector`.
 */
internal class VectorSmallTriangleKernel : SmallTriangleKernel() {
    private val ax = IntArray(COUNT)
    private val ay = IntArray(COUNT)
    private val bx = IntArray(COUNT)
    private val by = IntArray(COUNT)
    private val cx = IntArray(COUNT)
    private val cy = IntArray(COUNT)

    /** Samples along the sides of each triangle's bounds. */
    private val width = IntArray(COUNT)
    private val height = IntArray(COUNT)

    /** All bits set where a triangle has an area. */
    private val solid = IntArray(COUNT)

    /** The samples of each square that are outside an edge. */
    private val outside = IntArray(COUNT)

    /** An edge function at the first sample of a row, and its steps by column and row. */
    private val value = IntArray(COUNT)
    private val stepX = IntArray(COUNT)
    private val stepY = IntArray(COUNT)

    /** Distances from one triangle's vertex number to the next one's. */
    private val steps = IntArray(LANES) { 3 * it }
    private val places = IntArray(LANES)

    override fun cover(batch: TriangleBatch, first: Int, count: Int) {
        val whole = count / LANES * LANES
        fetch(batch, first, whole, 0, ax, ay)
        fetch(batch, first, whole, 1, bx, by)
        fetch(batch, first, whole, 2, cx, cy)
        bound(whole, ax, bx, cx, left, width)
        bound(whole, ay, by, cy, top, height)
        turn(whole)
        outside.fill(0, 0, whole)
        markOutside(whole, ax, ay, bx, by)
        markOutside(whole, bx, by, cx, cy)
        markOutside(whole, cx, cy, ax, ay)
        finish(whole)
        for (i in whole until count) coverOne(batch, first + i, i)
    }

    /** Loads vertex number [corner] of each triangle. */
    private fun fetch(batch: TriangleBatch, first: Int, count: Int, corner: Int, x: IntArray, y: IntArray) {
        var i = 0
        while (i < count) {
            IntVector.fromArray(INTS, batch.corners, 3 * (first + i) + corner, steps, 0).mul(TriangleBatch.STRIDE)
                .intoArray(places, 0)
            IntVector.fromArray(INTS, batch.grid, 0, places, 0).intoArray(x, i)
            IntVector.fromArray(INTS, batch.grid, 1, places, 0).intoArray(y, i)
            i += LANES
        }
    }

    /** Computes the first sample of the bounds, and the number of samples, in one direction. */
    private fun bound(count: Int, a: IntArray, b: IntArray, c: IntArray, first: IntArray, size: IntArray) {
        var i = 0
        while (i < count) {
            val va = IntVector.fromArray(INTS, a, i)
            val vb = IntVector.fromArray(INTS, b, i)
            val vc = IntVector.fromArray(INTS, c, i)
            val start = va.min(vb).min(vc).add(TO_FIRST).lanewise(VectorOperators.ASHR, ScreenGrid.SHIFT)
            val end = va.max(vb).max(vc).add(TO_FIRST).lanewise(VectorOperators.ASHR, ScreenGrid.SHIFT)
            start.intoArray(first, i)
            end.sub(start).intoArray(size, i)
            i += LANES
        }
    }

    /** Exchanges two vertices of each triangle that is not clockwise on the screen. */
    private fun turn(count: Int) {
        var i = 0
        while (i < count) {
            val vax = IntVector.fromArray(INTS, ax, i)
            val vay = IntVector.fromArray(INTS, ay, i)
            val vbx = IntVector.fromArray(INTS, bx, i)
            val vby = IntVector.fromArray(INTS, by, i)
            val vcx = IntVector.fromArray(INTS, cx, i)
            val vcy = IntVector.fromArray(INTS, cy, i)
            val area = vbx.sub(vax).mul(vcy.sub(vay)).sub(vcx.sub(vax).mul(vby.sub(vay)))
            area.neg().or(area).lanewise(VectorOperators.ASHR, Int.SIZE_BITS - 1).intoArray(solid, i)
            val isCounterclockwise = area.lanewise(VectorOperators.ASHR, Int.SIZE_BITS - 1)
            val turnX = vbx.lanewise(VectorOperators.XOR, vcx).and(isCounterclockwise)
            val turnY = vby.lanewise(VectorOperators.XOR, vcy).and(isCounterclockwise)
            vbx.lanewise(VectorOperators.XOR, turnX).intoArray(bx, i)
            vby.lanewise(VectorOperators.XOR, turnY).intoArray(by, i)
            vcx.lanewise(VectorOperators.XOR, turnX).intoArray(cx, i)
            vcy.lanewise(VectorOperators.XOR, turnY).intoArray(cy, i)
            i += LANES
        }
    }

    /** Marks the samples of the square that are outside an edge. */
    private fun markOutside(count: Int, fromX: IntArray, fromY: IntArray, toX: IntArray, toY: IntArray) {
        begin(count, fromX, fromY, toX, toY)
        for (row in 0 until SmallCoverage.SIDE) markOutsideInRow(count, SmallCoverage.SIDE * row)
    }

    /** Sets the edge function at the square's first sample, and its steps. */
    private fun begin(count: Int, fromX: IntArray, fromY: IntArray, toX: IntArray, toY: IntArray) {
        var i = 0
        while (i < count) {
            val x = IntVector.fromArray(INTS, fromX, i)
            val y = IntVector.fromArray(INTS, fromY, i)
            val runX = IntVector.fromArray(INTS, toX, i).sub(x)
            val runY = IntVector.fromArray(INTS, toY, i).sub(y)
            val right = IntVector.fromArray(INTS, left, i).lanewise(VectorOperators.LSHL, ScreenGrid.SHIFT).sub(x)
            val down = IntVector.fromArray(INTS, top, i).lanewise(VectorOperators.LSHL, ScreenGrid.SHIFT).sub(y)
            val isOwner = runY.or(runY.sub(1).and(runX.neg())).lanewise(VectorOperators.LSHR, Int.SIZE_BITS - 1)
            runX.mul(down.add(ScreenGrid.CENTER)).sub(runY.mul(right.add(ScreenGrid.CENTER))).sub(1).add(isOwner)
                .intoArray(value, i)
            runY.neg().lanewise(VectorOperators.LSHL, ScreenGrid.SHIFT).intoArray(stepX, i)
            runX.lanewise(VectorOperators.LSHL, ScreenGrid.SHIFT).intoArray(stepY, i)
            i += LANES
        }
    }

    /** Marks the samples of a row that are outside, the first of them at bit [bit], and moves to the next row. */
    private fun markOutsideInRow(count: Int, bit: Int) {
        var i = 0
        while (i < count) {
            val step = IntVector.fromArray(INTS, stepX, i)
            val first = IntVector.fromArray(INTS, value, i)
            val second = first.add(step)
            val third = second.add(step)
            val signs = first.lanewise(VectorOperators.LSHR, Int.SIZE_BITS - 1)
                .or(second.lanewise(VectorOperators.LSHR, Int.SIZE_BITS - 1).lanewise(VectorOperators.LSHL, 1))
                .or(third.lanewise(VectorOperators.LSHR, Int.SIZE_BITS - 1).lanewise(VectorOperators.LSHL, 2))
            signs.lanewise(VectorOperators.LSHL, bit).or(IntVector.fromArray(INTS, outside, i)).intoArray(outside, i)
            first.add(IntVector.fromArray(INTS, stepY, i)).intoArray(value, i)
            i += LANES
        }
    }

    /** Computes the result from the samples that are outside. */
    private fun finish(count: Int) {
        var i = 0
        while (i < count) {
            val bits = IntVector.fromArray(INTS, outside, i).lanewise(VectorOperators.XOR, SmallCoverage.ALL)
                .and(IntVector.fromArray(INTS, solid, i))
            val side = IntVector.fromArray(INTS, width, i).max(IntVector.fromArray(INTS, height, i))
            // All bits, which equals LARGE, if a side is longer than the square
            val isLarge = side.neg().add(SmallCoverage.SIDE).lanewise(VectorOperators.ASHR, Int.SIZE_BITS - 1)
            bits.or(isLarge).intoArray(covered, i)
            i += LANES
        }
    }

    private companion object {
        /** The number that [ScreenGrid.firstSample] adds before it shifts. */
        const val TO_FIRST = ScreenGrid.STEPS - 1 - ScreenGrid.CENTER
    }
}
