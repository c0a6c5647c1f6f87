package dev.lazyz.conformance.frames.world

import dev.lazyz.Raster
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.world.Light
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Surface
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import net.jqwik.api.RandomDistribution

/**
 * Generates frames of 3D scenes: shapes within a few units of the origin, lights, a camera among or in front of them,
 * and sometimes an environment, tone mapping, a visibility of ambient light, or more or less light.
 */
internal object WorldFrames {
    private val shapes = WorldShapes(WorldMaterials.opaque())
    private val meshes = WorldMeshes(WorldMaterials.opaque())
    private val dots = WorldPoints(WorldMaterials.opaque())

    fun polygon(): Arbitrary<Coded<Surface>> = shapes.polygon()

    fun holed(): Arbitrary<Coded<Surface>> = shapes.holed()

    fun nearPlane(): Arbitrary<Coded<Surface>> = shapes.nearPlane()

    fun sphere(): Arbitrary<Coded<Surface>> = shapes.sphere()

    fun mesh(): Arbitrary<Coded<Surface>> = meshes.any()

    fun points(): Arbitrary<Coded<Surface>> = dots.points()

    fun lines(): Arbitrary<Coded<Surface>> = dots.lines()

    /** Generates frames of all kinds of surfaces, without translucency. */
    fun cases(rasters: Arbitrary<Raster>, maxSurfaces: Int): Arbitrary<FrameCase> =
        cases(rasters, surfaces(shapes, meshes, dots, maxSurfaces))

    /** Generates frames of all kinds of surfaces, some of them translucent. */
    fun blended(rasters: Arbitrary<Raster>, maxSurfaces: Int): Arbitrary<FrameCase> {
        val materials = WorldMaterials.blended()
        val surfaces =
            surfaces(WorldShapes(materials), WorldMeshes(materials), WorldPoints(materials), maxSurfaces)
        return cases(rasters, surfaces)
    }

    /** Generates frames of meshes with normals, seen from both sides, with light from a direction or a point. */
    fun turned(rasters: Arbitrary<Raster>): Arbitrary<FrameCase> {
        val surfaces = WorldMeshes(WorldMaterials.twoSided()).turned().list().ofMinSize(1).ofMaxSize(3)
        return cases(rasters, surfaces, WorldLights.directed())
    }

    /** Generates frames of points, in front of and among meshes, without translucency. */
    fun dotted(rasters: Arbitrary<Raster>): Arbitrary<FrameCase> =
        cases(rasters, among(dots.points()))

    /** Generates frames of lines, in front of and among meshes, without translucency. */
    fun lined(rasters: Arbitrary<Raster>): Arbitrary<FrameCase> =
        cases(rasters, among(dots.lines()))

    /** Generates frames of points and lines, most of which blend, among meshes. */
    fun blendedDots(rasters: Arbitrary<Raster>): Arbitrary<FrameCase> {
        val some = WorldPoints(WorldMaterials.blended())
        return cases(rasters, among(mixed(1 to some.points(), 1 to some.lines())))
    }

    /** Generates some of these surfaces, mostly with a mesh in front of, among or behind them. */
    private fun among(surfaces: Arbitrary<Coded<Surface>>): Arbitrary<List<Coded<Surface>>> {
        val others = mixed(2 to meshes.backdrop(), 1 to meshes.any(), 1 to shapes.sphere())
        return Combinators.combine(surfaces.list().ofMinSize(1).ofMaxSize(4), others, ints(0, 5))
            .`as` { list, other, place ->
                if (place == 5) list else list.toMutableList().apply { add(minOf(place, size), other) }.toList()
            }
    }

    /** Generates frames of these surfaces. */
    fun cases(rasters: Arbitrary<Raster>, surfaces: Arbitrary<List<Coded<Surface>>>): Arbitrary<FrameCase> =
        cases(rasters, surfaces, WorldLights.any())

    private fun cases(
        rasters: Arbitrary<Raster>,
        surfaces: Arbitrary<List<Coded<Surface>>>,
        lights: Arbitrary<List<Coded<Light>>>,
    ): Arbitrary<FrameCase> =
        Combinators.combine(rasters, surfaces, lights, WorldCameras.aims(), WorldExposure.any())
            .`as` { raster, list, sources, aim, exposure ->
                val camera = aim.on(raster)
                val scene = exposure.value(Scene(list.map { it.value }, sources.map { it.value }, camera.value))
                val parts = "${lines(list)},\n    ${lines(sources)},\n    ${camera.code}"
                FrameCase(
                    scene.frame(raster),
                    "Scene(\n    $parts,\n)${exposure.code}.frame(${code(raster)})",
                    scene,
                )
            }

    private fun lines(list: List<Coded<*>>): String =
        if (list.isEmpty()) "listOf()" else list.joinToString("", "listOf(", "\n    )") { "\n        ${it.code}," }

    /** Generates surfaces, mostly including a backdrop. */
    private fun surfaces(
        shapes: WorldShapes,
        meshes: WorldMeshes,
        dots: WorldPoints,
        max: Int,
    ): Arbitrary<List<Coded<Surface>>> {
        if (max == 0) return Arbitraries.just(emptyList())
        val large = mixed(
            5 to meshes.any(),
            3 to shapes.polygon(),
            2 to shapes.holed(),
            3 to shapes.sphere(),
            1 to shapes.nearPlane(),
        )
        val kinds = mixed(19 to large, 1 to mixed(1 to dots.points(), 1 to dots.lines()))
        val others = kinds.list().ofMaxSize(max - 1).withSizeDistribution(RandomDistribution.uniform())
        val first = mixed(1 to large, 4 to meshes.backdrop())
        val some = Combinators.combine(others, first, ints(0, max)).`as` { list, one, place ->
            list.toMutableList().apply { add(minOf(place, size), one) }.toList()
        }
        return mixed(60 to some, 1 to Arbitraries.just(emptyList()))
    }

    /**
     * Generates rasters, square or not, but mostly neither a row nor a column, which would show little of a scene; and
     * mostly with the default depth of the background, which hides nothing.
     */
    fun rasters(maxSide: Int): Arbitrary<Raster> =
        Combinators.combine(Rasters.any(maxSide, maxSide), ints(0, 3)).`as` { raster, choice ->
            if (choice == 3) {
                raster
            } else {
                raster.withSize(maxOf(raster.width, raster.height / 2), maxOf(raster.height, raster.width / 2))
                    .withBackgroundDepth(Rasters.behindAll(raster.depthTest))
            }
        }
}
