package dev.lazyz.conformance.probes

import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.code
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Mesh
import java.util.Random
import org.joml.Vector3d

// Meshes in space, seen by a camera

/**
 * A mesh of tilted sheets, mostly less than a unit of depth apart: the camera's near plane is so close to it that
 * depths are coarse. Which sheet is in front somewhere, or equal, is not the same everywhere.
 */
internal fun withinAUnit(salt: Long): FrameCase {
    val random = Random(salt)
    val (tiltX, tiltY) = List(2) { random.nextFloat() - 0.5f }
    val corners = List(SHEETS) {
        val side = 0.5f + random.nextFloat()
        val (x, y) = List(2) { random.nextFloat() - side / 2 }
        val z = UNIT * random.nextInt(16) / 4
        listOf(x to y, x + side to y, x to y + side).map { (x, y) -> listOf(x, y, z + tiltX * x + tiltY * y) }.flatten()
    }
    val eye = Vector3d(0.0, 0.0, 4.0)
    val sheets = inOrder(corners.flatten().toFloatArray(), SHEETS)
    return meshCase(Raster(SHORT, SHORT), listOf(sheets), perspective(eye, near = TOO_NEAR))
}

private fun perspective(eye: Vector3d, target: Vector3d = Vector3d(), near: Double = NEAR_PLANE): Coded<Camera> {
    val camera = Camera.perspective(eye, target, UP, ANGLE, near, FAR_PLANE)
    return Coded(camera, "Camera.perspective(${code(eye)}, ${code(target)}, ${code(UP)}, $ANGLE, $near, $FAR_PLANE)")
}

/**
 * A fan of triangles around a point, whose rim is a spiral about the diagonal of space. Every plane along an axis cuts
 * most of them, and that of a triangle has few others on one side: a tree of planes is dozens of levels high.
 */
internal fun spiral(salt: Long): FrameCase {
    val rim = List(BLADES + 1) {
        val angle = 2 * Math.PI * it / BLADES_OF_A_TURN
        val part = 1 - 0.1 * it / BLADES
        val (right, up) = listOf(StrictMath.cos(angle), StrictMath.sin(angle)).map { side -> 0.5 * part * side }
        listOf(1 + right + up / 2, 1 - right + up / 2, 1 - up).map { side -> side.toFloat() }
    }
    val corners = rim.zipWithNext { a, b -> listOf(0f, 0f, 0f) + a + b }.flatten().toFloatArray()
    val random = Random(salt)
    val (x, y, z) = List(3) { 3 + 3 * random.nextDouble() }
    val camera = perspective(Vector3d(x, y, z), target = Vector3d(0.8))
    return meshCase(Raster(SHORT, SHORT), listOf(inOrder(corners, BLADES)), camera)
}

private const val BLADES = 3000
private const val BLADES_OF_A_TURN = 23

/**
 * The same two meshes, one of which shows front sides only and is in the scene twice, from all sides: from afar, and so
 * near that triangles are clipped. With any depth test.
 */
internal fun fromAllSides(salt: Long): List<FrameCase> {
    val random = Random(salt)
    val (front, both) = listOf(ONE_SIDED, Material()).map { material ->
        inOrder(FloatArray(9 * SHEETS) { 2 * random.nextFloat() - 1 }, SHEETS, material)
    }
    return SIDES.flatMap { side -> listOf(0.75, 3.0).map { Vector3d(side).mul(it) } }.map { eye ->
        val test = DepthTest.entries[random.nextInt(DepthTest.entries.size)]
        val raster = Raster(SHORT, SHORT).withDepthTest(test).withBackgroundDepth(Rasters.behindAll(test))
        meshCase(raster, listOf(front, both, front), perspective(eye))
    }
}

private val SIDES = listOf(1.0, -1.0).flatMap {
    listOf(Vector3d(it, 0.0, 0.0), Vector3d(0.0, it, 0.1), Vector3d(0.0, 0.0, it))
}

/**
 * Meshes of a few triangles of any size that a float has, with a far plane as far as possible: the depths are all
 * equal, and products are near to the ends of the numbers.
 */
internal fun immense(salt: Long): List<FrameCase> {
    val random = Random(salt)
    return SCALES.flatMap { scale ->
        val corners = FloatArray(9 * SHEETS) {
            (3 * scale * (random.nextFloat() - 0.5f) - if (it % 3 == 2) 5 * scale else 0.0).toFloat()
        }
        val line = "Vector3d(), ${code(AHEAD)}, ${code(UP)}"
        FAR_PLANES.map { far ->
            val camera = Camera.orthographic(Vector3d(), AHEAD, UP, 4 * scale, 0.0, far)
            val code = "Camera.orthographic($line, ${4 * scale}, 0.0, $far)"
            meshCase(Raster(SHORT, SHORT), listOf(inOrder(corners, SHEETS)), Coded(camera, code))
        }
    }
}

private val SCALES = listOf(1e-30, 1.0, 1e15, 1e30)
private val FAR_PLANES = listOf(1e33, 1e300)
private val AHEAD = Vector3d(0.0, 0.0, -1.0)

/**
 * An uneven sheet of triangles of a few samples, from the near left to the far right, and some large triangles above
 * it. Each texture has a mip filter or none, and is read with footprints of less than a texel to many of them.
 */
internal fun textured(salt: Long): FrameCase {
    val random = Random(salt)
    val fine = random.nextInt(20) + 30
    val sheet = grid(random, fine, height = 0f, unevenness = 0.3f)
    val builder = Scene.builder().add(sheet)
    repeat(random.nextInt(3) + 1) { builder.add(grid(random, cells = 2, height = 0.2f, unevenness = 1f)) }
    val eye = Vector3d(-1.0, 0.5 + random.nextDouble(), 2.0)
    builder.viewpoint(Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), 60.0, 0.1, 100.0))
    val scene = builder.build()
    return FrameCase(scene.frame(FEW, FEW), "SuiteFrames.textured(${salt}L)", scene)
}

/** Returns a mesh of [cells] x [cells] x 2 triangles, 2 units wide, whose heights and texture are random. */
private fun grid(random: Random, cells: Int, height: Float, unevenness: Float): Mesh {
    val side = cells + 1
    val places = List(side * side) { (it % side).toFloat() / cells to (it / side).toFloat() / cells }
    val density = listOf(0.5f, 2f, 8f)[random.nextInt(3)]
    fun uneven() = unevenness * (random.nextFloat() - 0.5f) / cells
    val positions = places.flatMap { (x, z) -> listOf(2 * x - 1 + uneven(), height + uneven(), 2 * z - 1 + uneven()) }
    val uvs = places.flatMap { (x, z) -> listOf(density * (x + uneven()), density * (z + uneven())) }
    val corners = (0..<cells * cells).flatMap {
        val first = it / cells * side + it % cells
        listOf(first, first + 1, first + side, first + side, first + 1, first + side + 1)
    }
    val texture = Texture(
        TEXELS, TEXELS, IntArray(TEXELS * TEXELS) { random.nextInt() or Rgba.BLACK.toArgb() },
        filter = Texture.Filter.entries[random.nextInt(Texture.Filter.entries.size)],
        mipFilter = MipFilter.entries[random.nextInt(MipFilter.entries.size)],
    )
    val shading = if (random.nextBoolean()) Shading.CONSTANT else Shading.PHONG
    val material = Material(texture = texture, shading = shading)
    return Mesh(positions.toFloatArray(), corners.toIntArray(), material, uvs = uvs.toFloatArray())
}

private const val TEXELS = 16

/** Nine tiles of 64. */
private const val FEW = 136

/** The triangles of a mesh, the samples on which they are, and about a unit of depth, in the world of their camera. */
private const val SHEETS = 16
private const val SHORT = 40
private const val UNIT = 0.07f
private const val ANGLE = 30.0
private const val TOO_NEAR = 1e-7
private const val NEAR_PLANE = 0.5
private const val FAR_PLANE = 100.0
private val UP = Vector3d(0.0, 1.0, 0.0)
