package dev.lazyz.conformance.probes

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.code
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Surface
import java.util.Random

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
internal val ONE_SIDED = Material(sides = Material.Sides.FRONT)

/** The frame of [meshes], each of which is [inOrder], with one of the materials above or the default one. */
internal fun meshCase(raster: Raster, meshes: List<Mesh>, camera: Coded<Camera>): FrameCase {
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

/** The frame of a mesh of [grains] small triangles in random order, on [side] x [side] samples. */
internal fun dust(salt: Long, grains: Int, side: Int = 8): Frame {
    val random = Random(salt)
    val positions = FloatArray(9 * grains)
    for (i in positions.indices) {
        // So near to the near plane that nothing is clipped
        val most = if (i % 3 == 2) 0.75f else side.toFloat()
        val part = most * random.nextFloat()
        positions[i] = if (i % 9 < 3) part else positions[i - 3] + part / 64
    }
    return Scene(listOf(inOrder(positions, grains)), viewpoint = Camera.screen()).frame(Raster(side, side))
}

/** The frame of a mesh of [teeth] triangles in the first three of [rows] rows. */
internal fun saw(teeth: Int, rows: Int): Frame {
    val corners = List(teeth) { triangle(it, 0, 3, (it * 7 % 100) / 100f) }.flatten().toFloatArray()
    return Scene(listOf(inOrder(corners, teeth)), viewpoint = Camera.screen()).frame(Raster(teeth, rows))
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

/** Nine tiles of 64. */
private const val FEW = 136
private const val CLOSE = 80
private const val FAR = 6

private const val SHEETS = 16
private const val SHORT = 40

private const val SURFACES = 24

/** Greatest number of triangles of a mesh. */
private const val MOST_OF_A_MESH = 40

/** 512 units of depth, which a float can still tell apart. */
private const val LITTLE = 1f / (1 shl 22)
