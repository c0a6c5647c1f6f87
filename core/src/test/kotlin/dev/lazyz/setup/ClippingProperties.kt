package dev.lazyz.setup

import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RayOracle
import dev.lazyz.SampleScenes
import dev.lazyz.geometry.FillRule
import dev.lazyz.samples
import dev.lazyz.samplesByCursor
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Contract rule 9: polygons that cross the near plane, the far plane and the guard band. */
class ClippingProperties {
    private val raster = Raster(32, 24)
    private val eye = Vector3d(0.0, 0.0, 0.0)

    /** A perspective camera at the origin that looks in a random direction, or along -z if [isUpright]. */
    private fun camera(random: Random, near: Double = 1.0, far: Double = 40.0): Camera {
        val target = Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, -1.0)
        val up = Vector3d(random.nextDouble() - 0.5, 1.0, random.nextDouble() - 0.5)
        return Camera.perspective(eye, target, up, 30.0 + 60 * random.nextDouble(), near, far)
    }

    /** A plane at some distance from the eye, with two directions in it. */
    private class Plane(random: Random) {
        val origin = Vector3d(random.nextDouble() - 0.5, -0.3 - random.nextDouble(), -0.5)
        val along = Vector3d(1.0, (random.nextDouble() - 0.5) * 0.3, (random.nextDouble() - 0.5) * 0.8)
        val away = Vector3d((random.nextDouble() - 0.5) * 0.8, (random.nextDouble() - 0.3) * 0.4, -1.0)

        fun at(u: Double, v: Double): Vector3d = Vector3d(
            origin.x + along.x * u + away.x * v,
            origin.y + along.y * u + away.y * v,
            origin.z + along.z * u + away.z * v,
        )
    }

    private fun vertex(p: Vector3d): Vertex = Vertex(p.x, p.y, p.z)

    @Property(seed = "1995", tries = 200, edgeCases = EdgeCasesMode.NONE)
    fun rule_9_1_neighboursShareTheirCuts(@ForAll random: Random) {
        // A tiled floor that extends behind the viewer, beyond the far plane and beyond the guard band
        val plane = Plane(random)
        val cells = 2 + random.nextInt(5)
        val reach = listOf(6.0, 60.0, 3e4, 1e7)[random.nextInt(4)]
        val lines = {
            List(cells + 1) { (2.0 * it / cells - 1.0) * reach + (random.nextDouble() - 0.5) * reach / cells }
        }
        val us = lines()
        val vs = lines()
        val camera = camera(random)
        val setUp = setUp(raster, camera, emptyList())
        val counts = IntArray(32 * 24)
        for (i in 0 until cells) {
            for (j in 0 until cells) {
                val quad = listOf(
                    plane.at(us[i], vs[j]), plane.at(us[i + 1], vs[j]),
                    plane.at(us[i + 1], vs[j + 1]), plane.at(us[i], vs[j + 1]),
                ).map(::vertex)
                val flip = random.nextBoolean()
                val parts = if (flip) {
                    listOf(listOf(quad[0], quad[1], quad[2]), listOf(quad[0], quad[2], quad[3]))
                } else {
                    listOf(listOf(quad[0], quad[1], quad[3]), listOf(quad[3], quad[1], quad[2]))
                }
                for (part in parts) add(counts, setUp.polygon(Polygon(listOf(part))))
            }
        }
        val outline = listOf(
            plane.at(us[0], vs[0]), plane.at(us[cells], vs[0]),
            plane.at(us[cells], vs[cells]), plane.at(us[0], vs[cells]),
        )
        for (y in 0 until 24) {
            for (x in 0 until 32) {
                val count = counts[y * 32 + x]
                when (RayOracle(camera, raster, outline).verdict(x, y)) {
                    true -> assertEquals(1, count) { "sample $x, $y within the floor" }
                    false -> assertEquals(0, count) { "sample $x, $y outside the floor" }
                    null -> assertTrue(count <= 1) { "sample $x, $y at the border is covered $count times" }
                }
            }
        }
    }

    private fun add(counts: IntArray, primitive: Primitive) {
        val covered = primitive.samples(raster)
        assertEquals(covered, primitive.samplesByCursor(raster, 0))
        for (y in 0 until 24) for (x in 0 until 32) if (covered[x, y]) counts[y * 32 + x]++
    }

    @Property(seed = "1995", tries = 200, edgeCases = EdgeCasesMode.NONE)
    fun rule_9_2_runsAlongThePlaneCancel(@ForAll random: Random) {
        // A comb whose teeth point into view and whose back is behind the viewer, compared with its single teeth
        val plane = Plane(random)
        val teeth = 2 + random.nextInt(4)
        val tips = 2.0 + random.nextDouble() * 10
        val edges = List(2 * teeth) { -3.0 + 6.0 * (it + random.nextDouble() * 0.8) / (2 * teeth) }
        val feet = List(2 * teeth) { -2.0 - random.nextDouble() * 3 }
        val comb = ArrayList<Vector3d>()
        for (i in 0 until teeth) {
            comb.add(plane.at(edges[2 * i], feet[2 * i]))
            comb.add(plane.at(edges[2 * i], tips))
            comb.add(plane.at(edges[2 * i + 1], tips))
            comb.add(plane.at(edges[2 * i + 1], feet[2 * i + 1]))
        }
        comb.add(plane.at(4.0, -9.0))
        comb.add(plane.at(-4.0, -9.0))
        val setUp = setUp(raster, camera(random), emptyList())
        val union = IntArray(32 * 24)
        for (i in 0 until teeth) {
            val tooth = comb.subList(4 * i, 4 * i + 4).map(::vertex)
            add(union, setUp.polygon(Polygon(listOf(tooth))))
        }
        val start = random.nextInt(comb.size)
        val contour = List(comb.size) { vertex(comb[(start + it) % comb.size]) }
        for (rule in FillRule.entries) {
            for (turned in listOf(contour, contour.reversed())) {
                val whole = IntArray(32 * 24)
                add(whole, setUp.polygon(Polygon(listOf(turned), fillRule = rule)))
                assertEquals(union.toList(), whole.toList()) { rule.toString() }
            }
        }
    }

    @Property(seed = "1995", tries = 100, edgeCases = EdgeCasesMode.NONE)
    fun rule_9_3_clippedMeshesNeverLeaveTheDepthRange(@ForAll random: Random) {
        val mesh = SampleScenes.soup(random, 6, Material(), listOf(3.0, 30.0, 3000.0)[random.nextInt(3)])
        for (primitive in Scene(listOf(mesh), viewpoint = camera(random)).frame(raster).primitives) {
            val covered = primitive.samples(raster)
            for (y in 0 until 24) {
                for (x in 0 until 32) {
                    if (!covered[x, y]) continue
                    assertTrue(primitive.depth(x, y) in primitive.leastDepth..primitive.greatestDepth)
                }
            }
        }
    }
}
