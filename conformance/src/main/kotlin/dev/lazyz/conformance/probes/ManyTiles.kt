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

/** More than the largest side of a tile. */
private const val WIDE = 520

/** Few enough for a renderer that looks at each of them at each sample. */
private const val MANY_TRIANGLES = 130
private const val SHORT = 8
private val LENGTHS = List(8) { 1024 shl it }
private const val DEPTHS = 16
