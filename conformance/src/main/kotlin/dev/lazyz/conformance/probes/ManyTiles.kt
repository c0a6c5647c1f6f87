package dev.lazyz.conformance.probes

import dev.lazyz.Raster
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.frames.screen.PolygonPiece
import dev.lazyz.conformance.frames.screen.screenCase
import dev.lazyz.geometry.FillRule
import java.util.Random

/**
 * Frames of a mesh of a few small triangles, in different places of rasters of several tiles, each of another height.
 * What a renderer keeps of one of them has the wrong size, or the wrong content, for the next. The last five are of one
 * height: two have the same vertices, but not the same number of triangles, two the same mesh, one with another, and
 * one has a mesh without triangles before a mesh.
 */
internal fun tallMeshes(salt: Long): List<FrameCase> {
    val random = Random(salt)
    val (first, second) = List(FRAMES) { tallMesh(FIRST_HEIGHT + HIGHER * it, random) }
        .partition { random.nextBoolean() }
    val raster = Raster(WIDTH, FIRST_HEIGHT)
    fun positions() = triangles(raster, random) { WIDTH / 2 }.flatten().toFloatArray()
    val vertices = positions()
    val meshes = List(2) { inOrder(positions(), TRIANGLES) }
    return first + second + listOf(TRIANGLES / 2, TRIANGLES).map { screenMesh(raster, vertices, it) } +
        listOf(meshes.take(1), meshes, listOf(inOrder(vertices, 0), meshes[1])).map { screenMeshes(raster, it) }
}

private const val FRAMES = 10
private const val WIDTH = 64
private const val FIRST_HEIGHT = 128
private const val HIGHER = 64
private const val TRIANGLES = 15

private fun tallMesh(height: Int, random: Random): FrameCase {
    // One of three is as large as a tile
    return scattered(Raster(WIDTH, height), random) { if (random.nextInt(3) == 0) WIDTH else 2 }
}

/** A mesh of a few triangles anywhere in [raster], each of a [size]. */
private fun scattered(raster: Raster, random: Random, size: () -> Int): FrameCase =
    screenMesh(raster, triangles(raster, random, size))

private fun triangles(raster: Raster, random: Random, size: () -> Int) = List(TRIANGLES) {
    val side = size()
    val x = random.nextInt(raster.width - side + 1)
    val y = random.nextInt(raster.height - side + 1)
    triangle(x, y, side, random.nextInt(DEPTHS) / DEPTHS.toFloat())
}

/**
 * Frames of a few triangles, in random order, on rasters of very many rows, and of very many columns: one for each
 * power of two, so that numbers of tiles have all numbers of digits. Each has the triangles one by one, and smaller
 * ones as a mesh.
 */
internal fun longRasters(salt: Long): List<FrameCase> {
    val random = Random(salt)
    val lengths = LENGTHS.map { it + random.nextInt(it) }
    return lengths.flatMap { listOf(Raster(SHORT, it), Raster(it, SHORT)) }.flatMap { raster ->
        val pieces = List(TRIANGLES) {
            val x = random.nextInt(raster.width - SHORT + 1).toDouble()
            val y = random.nextInt(raster.height - SHORT + 1).toDouble()
            val z = random.nextInt(DEPTHS) / DEPTHS.toDouble()
            val contour = doubleArrayOf(x, y, z, x + SHORT, y, z, x, y + SHORT, z)
            PolygonPiece(listOf(contour), FillRule.NON_ZERO)
        }
        listOf(screenCase(raster, pieces), scattered(raster, random) { 1 + random.nextInt(SHORT) })
    }
}

/** A frame of a mesh of small and larger triangles, on a raster of several tiles of any size, in random order. */
internal fun wideMesh(salt: Long): FrameCase {
    val random = Random(salt)
    val side = WIDE + random.nextInt(WIDE / 4)
    val corners = List(MANY_TRIANGLES) {
        val size = 1 + random.nextInt(if (random.nextInt(8) == 0) WIDE / 8 else SHORT)
        val z = random.nextInt(DEPTHS) / DEPTHS.toFloat()
        triangle(random.nextInt(side - size + 1), random.nextInt(side - size + 1), size, z)
    }
    return screenMesh(Raster(side, side), corners)
}

/** A mesh of triangles of a few samples each over several tiles, most of which have no other triangles. */
internal fun specks(salt: Long): FrameCase {
    val random = Random(salt)
    val triangles = List(SPECKS) {
        val size = 1 + random.nextInt(4)
        triangle(random.nextInt(SIDE - size), random.nextInt(SIDE - size), size, random.nextFloat())
    }
    return screenMesh(Raster(SIDE, SIDE), triangles)
}

/** A mesh of more than four thousand triangles within one tile, each of which covers one sample, mostly alone. */
internal fun crowdedTile(salt: Long): FrameCase {
    val random = Random(salt)
    val places = List(TILE * TILE) { it } + List(HIDDEN) { random.nextInt(TILE * TILE) }
    val triangles = places.shuffled(random).map { place ->
        val (x, y) = listOf(place % TILE, place / TILE).map { it.toFloat() }
        val z = random.nextFloat()
        listOf(x, y, z, x + ONE_SAMPLE, y, z, x, y + ONE_SAMPLE, z)
    }
    return screenMesh(Raster(TILE, TILE), triangles)
}

/**
 * Wide triangles with an edge that goes exactly through the samples of the last column, or row, of tiles, which belong
 * to the triangle only if the top-left rule says so. Wide triangles behind them are visible there.
 */
internal fun edgesAtTheEndsOfTiles(salt: Long): List<FrameCase> {
    val random = Random(salt)
    return List(EDGES) {
        val end = 8 * (1 + random.nextInt(SIDE / 8 - 1)) - 1
        // Half of them are at the ends of tiles of any usual size
        val at = (if (random.nextBoolean()) end or 63 else end) + 0.5f
        val isColumn = random.nextBoolean()
        val isAfter = random.nextInt(4) == 0
        val front = halfPlane(at, isAfter, isColumn, middle = SIDE * random.nextFloat(), random.nextFloat() / 2)
        val behind = listOf(-1f, -1f, 0.75f, 4f * SIDE, -1f, 0.75f, -1f, 4f * SIDE, 0.75f)
        screenMesh(Raster(SIDE, SIDE), listOf(front, behind).shuffled(random))
    }
}

/** A triangle at the depth [z] that covers all columns, or rows, after or before a place on the raster. */
private fun halfPlane(at: Float, isAfter: Boolean, isColumn: Boolean, middle: Float, z: Float): List<Float> {
    val tip = if (isAfter) at + FAR_AWAY else at - FAR_AWAY
    return listOf(at to middle - FAR_AWAY, at to middle + FAR_AWAY, tip to middle).flatMap { (along, across) ->
        if (isColumn) listOf(along, across, z) else listOf(across, along, z)
    }
}

/** Triangles of many sizes behind two nearer ones, which leave a gap of a few columns, or rows, between them. */
internal fun seenThroughGaps(salt: Long): List<FrameCase> {
    val random = Random(salt)
    return List(EDGES) {
        val gap = random.nextInt(SIDE - TILE)
        val end = gap + 1 + random.nextInt(TILE / 4)
        val isColumn = random.nextBoolean()
        val sides = listOf(false to gap, true to end).map { (isAfter, at) ->
            halfPlane(at.toFloat(), isAfter, isColumn, SIDE / 2f, random.nextFloat() / 4)
        }
        val behind = List(BEHIND) {
            val size = 1 + random.nextInt(SIDE)
            val along = maxOf(0, gap - random.nextInt(size))
            val across = random.nextInt(SIDE)
            val z = 0.5f + random.nextFloat() / 2
            if (isColumn) triangle(along, across, size, z) else triangle(across, along, size, z)
        }
        screenMesh(Raster(SIDE, SIDE), (sides + behind).shuffled(random))
    }
}

/** Sixteen tiles of 64, so that triangles can be wide. */
private const val SIDE = 200

private const val EDGES = 16
private const val BEHIND = 6
private const val SPECKS = 60
private const val TILE = 64
private const val HIDDEN = 200

/** Side of a triangle that covers the sample at its right angle, and not those beside and below it. */
private const val ONE_SAMPLE = 1.5f
private const val FAR_AWAY = 4000f

/** More than the largest side of a tile. */
private const val WIDE = 520

/** Few enough for a renderer that looks at each of them at each sample. */
private const val MANY_TRIANGLES = 130
private const val SHORT = 8
private val LENGTHS = List(8) { 1024 shl it }
private const val DEPTHS = 16
