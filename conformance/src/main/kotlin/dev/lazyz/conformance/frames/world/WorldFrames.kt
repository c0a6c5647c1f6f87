package dev.lazyz.conformance.frames.world

import dev.lazyz.Raster
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import net.jqwik.api.RandomDistribution
import org.joml.Vector3d

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
        val surfaces = surfaces(WorldShapes(materials), WorldMeshes(materials), WorldPoints(materials), maxSurfaces)
        return cases(rasters, surfaces)
    }

    /** Generates frames of meshes with normals, seen from both sides, with light from a direction or a point. */
    fun turned(rasters: Arbitrary<Raster>): Arbitrary<FrameCase> {
        val surfaces = WorldMeshes(WorldMaterials.twoSided()).turned().list().ofMinSize(1).ofMaxSize(3)
        return cases(rasters, surfaces, WorldLights.directed())
    }

    /** Generates frames of points, in front of and among meshes, without translucency. */
    fun dotted(rasters: Arbitrary<Raster>): Arbitrary<FrameCase> = cases(rasters, among(dots.points()))

    /** Generates frames of lines, in front of and among meshes, without translucency. */
    fun lined(rasters: Arbitrary<Raster>): Arbitrary<FrameCase> = cases(rasters, among(dots.lines()))

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
                FrameCase(Coded(scene, "Scene(\n    $parts,\n)${exposure.code}"), raster)
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

/** Generates clouds of points, and lines between points. Sizes are from less than a pixel to more than a tile. */
internal class WorldPoints(private val materials: Arbitrary<Coded<Material>>) {
    private val sizes: Arbitrary<Double> =
        mixed(4 to oneOf(1.0, 2.0, 3.0), 2 to oneOf(0.25, 1.5, 5.3), 1 to oneOf(24.0))

    fun points(): Arbitrary<Coded<Surface>> = Combinators
        .combine(positions(1), sizes, materials, WorldAttributes.any()).`as` { positions, size, material, attributes ->
            val normals = attributes.normals(positions)
            val colors = attributes.colors(positions)
            val words = listOfNotNull(
                code(positions), code(size), material.code, normals?.let { "normals = ${code(it)}" },
                colors?.let { "colors = ${code(it)}" },
            )
            Coded(Points(positions, size, material.value, normals, colors), words.joinToString(", ", "Points(", ")"))
        }

    /** Mostly polylines, otherwise arbitrary segments, including segments of length zero. */
    fun lines(): Arbitrary<Coded<Surface>> = Combinators
        .combine(positions(2), ints(0, 5).list().ofMinSize(1).ofMaxSize(8), sizes, materials, WorldAttributes.any())
        .`as` { positions, turns, width, material, attributes ->
            val count = positions.size / 3
            val segments = turns.flatMapIndexed { i, turn ->
                val first = i % count
                listOf(first, if (turn < 4) (first + 1) % count else (first + turn) % count)
            }.toIntArray()
            val colors = attributes.colors(positions)
            val words = listOfNotNull(
                code(positions), "intArrayOf(${segments.joinToString()})", code(width), material.code,
                colors?.let { "colors = ${code(it)}" },
            )
            Coded(Lines(positions, segments, width, material.value, colors), words.joinToString(", ", "Lines(", ")"))
        }

    private fun positions(least: Int): Arbitrary<FloatArray> =
        WorldShapes.points.list().ofMinSize(least).ofMaxSize(12).map { list ->
            list.flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }.toFloatArray()
        }
}

/**
 * Generates cameras that look at the origin, around which the shapes are. Their field of view is about as large as the
 * shapes.
 */
internal object WorldCameras {
    /** A camera without a raster. The wider the raster, the smaller the field of view from top to bottom. */
    class Aim(private val eye: Vector3d, private val lens: Lens) {
        fun on(raster: Raster): Coded<Camera> {
            val part = minOf(1.0, raster.height.toDouble() / raster.width)
            val line = "${code(eye)}, Vector3d(), Vector3d(0.0, 1.0, 0.0)"
            val up = Vector3d(0.0, 1.0, 0.0)
            if (lens.angle > 0.0) {
                val angle = lens.angle * part
                val camera = Camera.perspective(eye, Vector3d(), up, angle, NEAR, FAR)
                return Coded(camera, "Camera.perspective($line, $angle, $NEAR, $FAR)")
            }
            val height = lens.height * part
            val camera = Camera.orthographic(eye, Vector3d(), up, height, NEAR, FAR)
            return Coded(camera, "Camera.orthographic($line, $height, $NEAR, $FAR)")
        }
    }

    /** The vertical field of view in degrees or, if that is 0, the height in world units. */
    enum class Lens(val angle: Double, val height: Double) {
        USUAL(40.0, 0.0),
        PARALLEL(0.0, 4.0),
        WIDE(60.0, 0.0),
        CLOSE(0.0, 3.0),
    }

    /** Half of the cameras look along the z axis, so that surfaces of constant z are parallel to the screen. */
    fun aims(): Arbitrary<Aim> {
        val straight = ints(3, 6).map { Vector3d(0.0, 0.0, it.toDouble()) }
        val oblique = Combinators.combine(ints(-3, 3), ints(-3, 3), ints(2, 5))
            .`as` { x, y, z -> Vector3d(x.toDouble(), y.toDouble(), z.toDouble()) }
        return Combinators.combine(mixed(1 to straight, 1 to oblique), oneOf(*Lens.values())).`as`(::Aim)
    }

    private const val NEAR = 0.5
    private const val FAR = 10.0
}
