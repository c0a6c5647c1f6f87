package dev.lazyz.conformance.probes

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.code
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Surface
import java.util.Random
import org.joml.Vector3d

// Meshes, most of them given on the screen, on rasters of several tiles

/** The frame of a mesh of triangles, each given by x, y and z of its corners: samples, and a part of the depths. */
internal fun screenMesh(raster: Raster, triangles: List<List<Float>>): FrameCase =
    screenMesh(raster, triangles.flatten().toFloatArray(), triangles.size)

/** The frame of a mesh of the first [drawn] triangles whose corners are in [positions]. */
internal fun screenMesh(raster: Raster, positions: FloatArray, drawn: Int): FrameCase =
    screenMeshes(raster, listOf(inOrder(positions, drawn)))

/** The frame of [meshes], each of which is [inOrder]. */
internal fun screenMeshes(raster: Raster, meshes: List<Mesh>): FrameCase =
    meshCase(raster, meshes, Coded(Camera.screen(), "Camera.screen()"))

/** The mesh of the first [drawn] triangles whose corners, three each, are in [positions]. */
internal fun inOrder(positions: FloatArray, drawn: Int, material: Material = Material()): Mesh =
    Mesh(positions, IntArray(3 * drawn) { it }, material)

private val GLASS = Material(Rgba(1f, 0.5f, 0.25f, 0.5f), alphaMode = AlphaMode.BLEND)
private val ONE_SIDED = Material(sides = Material.Sides.FRONT)

private fun meshCase(raster: Raster, meshes: List<Mesh>, camera: Coded<Camera>): FrameCase {
    val scene = Scene.builder().apply { meshes.forEach { add(it) } }.viewpoint(camera.value).build()
    val code = meshes.joinToString("", "Scene.builder()") {
        val material = when (it.material) {
            GLASS -> ", Material(${code(GLASS.baseColor)}, alphaMode = AlphaMode.BLEND)"
            ONE_SIDED -> ", Material(sides = Material.Sides.FRONT)"
            else -> ""
        }
        ".add(Mesh(${code(it.positions)}, IntArray(${it.triangles.size}) { it }$material))"
    } + ".viewpoint(${camera.code}).build()"
    return FrameCase(Coded(scene, code), raster)
}

/**
 * A wall over several tiles, and many triangles that are hardly in front of it or hardly behind it, in random order.
 * Others are far from it, so that a rough order of all depths does not tell the near ones apart.
 */
internal fun closeToAWall(salt: Long): FrameCase {
    val random = Random(salt)
    val wall = 0.3f + 0.4f * random.nextFloat()
    val triangles = List(CLOSE) {
        val size = 5 + random.nextInt(20)
        val x = random.nextInt(FEW - size)
        val y = random.nextInt(FEW - size)
        val z = wall + (1 + random.nextInt(8)) * LITTLE * if (random.nextBoolean()) 1 else -1
        triangle(x, y, size, z)
    }
    val far = List(FAR) {
        triangle(random.nextInt(FEW - 8), random.nextInt(FEW - 8), 8, if (random.nextBoolean()) 0.01f else 0.99f)
    }
    val edge = 4f * FEW
    val walls = listOf(listOf(-1f, -1f, wall, edge, -1f, wall, -1f, edge, wall))
    return screenMesh(Raster(FEW, FEW), (triangles + far + walls).shuffled(random))
}

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
    val up = Vector3d(0.0, 1.0, 0.0)
    val camera = Camera.perspective(eye, Vector3d(), up, ANGLE, TOO_NEAR, FAR_PLANE)
    val code = "Camera.perspective(${code(eye)}, Vector3d(), ${code(up)}, $ANGLE, $TOO_NEAR, $FAR_PLANE)"
    val sheets = inOrder(corners.flatten().toFloatArray(), SHEETS)
    return meshCase(Raster(SHORT, SHORT), listOf(sheets), Coded(camera, code))
}

/**
 * A fan of triangles around a point, whose rim is a spiral about the diagonal of space. Every plane along an axis cuts
 * most of them, and that of a triangle has few others on one side: a tree of planes is dozens of levels high.
 */
internal fun spiral(): FrameCase {
    val (u, v) = listOf(Vector3d(1.0, -1.0, 0.0), Vector3d(1.0, 1.0, -2.0)).map { it.normalize(0.6) }
    val rim = List(BLADES + 1) {
        val angle = 2 * Math.PI * it / BLADES_OF_A_TURN
        val part = 1 - 0.1 * it / BLADES
        val place = Vector3d(1.0).fma(part * StrictMath.cos(angle), u).fma(part * StrictMath.sin(angle), v)
        listOf(place.x, place.y, place.z).map { side -> side.toFloat() }
    }
    val corners = rim.zipWithNext { a, b -> listOf(0f, 0f, 0f) + a + b }.flatten().toFloatArray()
    val eye = Vector3d(4.0, 3.0, 6.0)
    val target = Vector3d(0.8)
    val camera = Camera.perspective(eye, target, UP, ANGLE, NEAR_PLANE, FAR_PLANE)
    val code = "Camera.perspective(${code(eye)}, Vector3d(0.8), ${code(UP)}, $ANGLE, $NEAR_PLANE, $FAR_PLANE)"
    return meshCase(Raster(SHORT, SHORT), listOf(inOrder(corners, BLADES)), Coded(camera, code))
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
        val camera = Camera.perspective(eye, Vector3d(), UP, ANGLE, NEAR_PLANE, FAR_PLANE)
        val code = "Camera.perspective(${code(eye)}, Vector3d(), ${code(UP)}, $ANGLE, $NEAR_PLANE, $FAR_PLANE)"
        val test = DepthTest.entries[random.nextInt(DepthTest.entries.size)]
        val raster = Raster(SHORT, SHORT).withDepthTest(test).withBackgroundDepth(Rasters.behindAll(test))
        meshCase(raster, listOf(front, both, front), Coded(camera, code))
    }
}

private val SIDES = listOf(1.0, -1.0).flatMap {
    listOf(Vector3d(it, 0.0, 0.0), Vector3d(0.0, it, 0.1), Vector3d(0.0, 0.0, it))
}
private const val NEAR_PLANE = 0.5

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
        val line = "Vector3d(), Vector3d(0.0, 0.0, -1.0), Vector3d(0.0, 1.0, 0.0)"
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
private val UP = Vector3d(0.0, 1.0, 0.0)

/**
 * A mesh of inclined triangles, and of slivers that are seen nearly edge-on between them: from the near to the far
 * plane in less than four samples, so that each has the depth of its first vertex. If [withGlass], translucent
 * triangles are between them, too.
 */
internal fun slivers(salt: Long, withGlass: Boolean): FrameCase {
    val random = Random(salt)
    fun inclined() = List(SHEETS) {
        List(3) { List(2) { 2 * SHORT * random.nextFloat() - SHORT / 2 } + random.nextFloat() }
    }
    val plates = inclined()
    val slivers = List(2 * SHEETS) {
        val (x, y) = List(2) { SHORT * random.nextFloat() }
        listOf(listOf(x, y, 0f), listOf(x + 3, y, 1f), listOf(x, y + SHORT / 4, 0.5f * random.nextFloat()))
            .shuffled(random)
    }
    val opaque = inOrder((plates + slivers).map { it.flatten() }.shuffled(random).flatten().toFloatArray(), 3 * SHEETS)
    val glass = inOrder(inclined().flatten().flatten().toFloatArray(), SHEETS, GLASS)
    return screenMeshes(Raster(SHORT, SHORT), listOfNotNull(opaque, glass.takeIf { withGlass }))
}

/** A mesh of inclined triangles at all distances, on a [raster] of few samples. */
internal fun fewTriangles(salt: Long, raster: Raster): FrameCase {
    val random = Random(salt)
    val triangles = List(SHEETS) {
        val z = random.nextFloat()
        List(3) {
            List(2) { raster.width * (2 * random.nextFloat() - 0.5f) } + (z + random.nextFloat() / 4) / 2
        }.flatten()
    }
    return screenMesh(raster, triangles)
}

/** The frame of a mesh of [grains] small triangles in random order, on few samples. */
internal fun dust(salt: Long, grains: Int): Frame {
    val random = Random(salt)
    val positions = FloatArray(9 * grains)
    for (i in positions.indices) {
        val most = if (i % 3 == 2) DUSTY_DEPTH else DUSTY.width.toFloat()
        positions[i] = if (i % 9 < 3) most * random.nextFloat() else positions[i - 3] + random.nextFloat() / 8
    }
    return Scene(listOf(inOrder(positions, grains)), viewpoint = Camera.screen()).frame(DUSTY)
}

/** Returns a triangle with its right angle at ([x], [y]), whose short sides have [size] samples, at the depth [z]. */
internal fun triangle(x: Int, y: Int, size: Int, z: Float): List<Float> =
    listOf(x, y, z, x + size, y, z, x, y + size, z).map { it.toFloat() }

/** Shows every attribute of a fragment. */
private object EveryAttribute : Shader {
    override fun shade(fragment: Fragment) = with(fragment) {
        setColor(u + normalX / 2 + worldX / 512, v + normalY / 2 + u2 / 4, vertexRed / 2 + v2 / 4 + tangentX / 2)
    }
}

/** As [EveryAttribute], for many fragments. */
private object EveryAttributeOfMany : BatchShader {
    override fun shade(batch: FragmentBatch) = with(batch) {
        for (i in 0 until size) {
            red[i] = u[i] + normalX[i] / 2 + worldX[i] / 512
            green[i] = v[i] + normalY[i] / 2 + u2[i] / 4
            blue[i] = vertexRed[i] / 2 + v2[i] / 4 + tangentX[i] / 2
        }
    }
}

/**
 * Meshes and polygons with different attributes, side by side and on top of each other, whose material has the same
 * shader. There are hundreds of triangles, so that their indices agree in many bits.
 */
internal fun surfacesOfOneShader(salt: Long): FrameCase {
    val random = Random(salt)
    val shader = if (random.nextBoolean()) EveryAttribute else EveryAttributeOfMany
    val builder = Scene.builder().viewpoint(Camera.screen())
    repeat(SURFACES) { builder.add(someSurface(random, Material(shader = shader))) }
    val scene = builder.build()
    // Without the scene: a scene file cannot express the shader
    return FrameCase(scene.frame(FEW, FEW), "SuiteFrames.surfacesOfOneShader(${salt}L)")
}

private fun someSurface(random: Random, material: Material): Surface {
    if (random.nextInt(4) == 0) return somePolygon(random, material)
    val triangles = List(1 + random.nextInt(MOST_OF_A_MESH)) {
        val size = if (random.nextBoolean()) 3 + random.nextInt(4) else 20 + random.nextInt(60)
        triangle(random.nextInt(FEW - size), random.nextInt(FEW - size), size, random.nextFloat())
    }
    val corners = 3 * triangles.size

    fun some(each: Int): FloatArray? =
        if (random.nextBoolean()) FloatArray(each * corners) { random.nextFloat() } else null
    val uvs = some(2)
    return Mesh(
        triangles.flatten().toFloatArray(),
        IntArray(corners) { it },
        material,
        normals = some(3),
        uvs = uvs,
        colors = some(4),
        uvs2 = if (uvs == null) null else some(2),
    )
}

/** Returns a hexagon with a colour and texture coordinates at each corner. */
private fun somePolygon(random: Random, material: Material): Polygon {
    val size = 10 + random.nextInt(60)
    val (x, y) = List(2) { (size + random.nextInt(FEW)).toDouble() / 2 }
    val z = random.nextDouble()
    val corners = List(6) {
        val angle = it * Math.PI / 3
        val color = Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat())
        val (u, v) = List(2) { random.nextFloat() }
        Vertex(x + size * StrictMath.cos(angle) / 2, y + size * StrictMath.sin(angle) / 2, z, u, v, color)
    }
    return Polygon(listOf(corners), material)
}

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
private const val CLOSE = 80
private const val FAR = 6

/** The sheets, the samples on which they are, and about a unit of depth, in the world of their camera. */
private const val SHEETS = 16
private const val SHORT = 40
private const val UNIT = 0.07f
private const val ANGLE = 30.0
private const val TOO_NEAR = 1e-7
private const val FAR_PLANE = 100.0

private val DUSTY = Raster(8, 8)

/** So near to the near plane that nothing is clipped. */
private const val DUSTY_DEPTH = 0.75f

private const val SURFACES = 24

/** Greatest number of triangles of a mesh. */
private const val MOST_OF_A_MESH = 40

/** 512 units of depth, which a float can still tell apart. */
private const val LITTLE = 1f / (1 shl 22)
