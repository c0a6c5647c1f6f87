package dev.lazyz.conformance.probes

import dev.lazyz.Capability
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.changed.withinAny
import dev.lazyz.conformance.judgement.Judgement
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.geometry.Box
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.StreamedMesh.MeshSource
import java.util.Random
import org.joml.Vector3dc

/** Returns options that change how a streamed frame is drawn: any coherence, budget, threads, tiles and bands. */
internal fun optionsForStreams(salt: Long): RenderOptions {
    val random = Random(salt)
    fun <T> List<T>.any(): T = this[random.nextInt(size)]
    return RenderOptions(
        coherence = Coherence.entries.any(),
        memoryBudget = listOf(null, 0L, 1000L).any(),
        threads = listOf(1, 2, 3).any(),
        tileSize = listOf(8, 16, 64).any(),
        bandBytes = listOf(null, SOME_ROWS).any(),
    )
}

/**
 * Fails if [renderer] draws a streamed frame otherwise than the same frame in memory. It may refuse the frame. The
 * frame is of several meshes, each of several parts, whose triangles often have the same depth. If the renderer blends,
 * some meshes are translucent.
 */
internal fun streamedIsTheSame(renderer: Renderer, salt: Long) {
    val canBlend = Capability.TRANSPARENCY in renderer.capabilities
    val (frame, same) = streamed(salt, canBlend)
    val refused = answer { renderer.inTime(frame) { _, _, _, _ -> } }
    if (refused is IllegalArgumentException) return
    val expected = Recording.of(ReferenceRenderer(), same).image
    Judgement(renderer, FrameCase(frame, "SuiteFrames.streamed(${salt}L, $canBlend)"), "streamed meshes")
        .equalsPicture(expected)
}

/** Returns a streamed frame, and the same frame in memory. */
internal fun streamed(salt: Long, canBlend: Boolean): Pair<Frame, Frame> {
    val random = Random(salt)
    val convention = DepthConvention.entries[random.nextInt(DepthConvention.entries.size)]
    val test = DepthTest.entries[random.nextInt(DepthTest.entries.size)]
    val (width, height) = List(2) { 1 + random.nextInt(MOST_SIDE) }
    val background = if (random.nextInt(4) == 0) Int.MAX_VALUE / 2 else Rasters.behindAll(test)
    val raster = Raster(width, height, Rgba.WHITE, convention, test, background)
    val parts = List(1 + random.nextInt(MOST_MESHES)) {
        List(1 + random.nextInt(1 + random.nextInt(MOST_PARTS))) { part(raster, random) }
    }
    val isBlending = canBlend && random.nextBoolean()
    val materials = parts.map {
        val color = Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat(), random.nextFloat())
        Material(color).withAlphaMode(if (isBlending && random.nextBoolean()) AlphaMode.BLEND else AlphaMode.OPAQUE)
    }
    fun scene(add: Scene.Builder.(parts: List<Mesh>, material: Material) -> Unit) = Scene.builder()
        .apply { for ((i, mesh) in parts.withIndex()) add(mesh, materials[i]) }
        .viewpoint(Camera.screen()).build()

    val whole = scene { mesh, material -> add(joined(mesh, material)) }
    val streamed = scene { mesh, material -> add(StreamedMesh(Parts(mesh), material)) }
    val all = streamed.frame(raster)
    val frame = if (random.nextBoolean()) all else FrameCase(all, "").withinAny(random).frame
    return frame to whole.frame(raster).within(frame.region)
}

/** Bytes of a few rows of such a picture. */
private const val SOME_ROWS = 1000L
private const val MOST_SIDE = 24
private const val MOST_MESHES = 4
private const val MOST_PARTS = 3
private const val MOST_TRIANGLES = 4
private const val DEPTHS = 3

/** One of so many triangles has a corner outside the planes, which are at 0 and 1. */
private const val CLIPPED = 2

/** Returns some triangles on whole positions, some of them across the near or the far plane, where they are clipped. */
private fun part(raster: Raster, random: Random): Mesh {
    val count = 1 + random.nextInt(1 + random.nextInt(MOST_TRIANGLES))
    val positions = FloatArray(9 * count)
    for (triangle in 0 until count) {
        val z = (1 + random.nextInt(DEPTHS)) / (1 + DEPTHS).toFloat()
        val outside = if (random.nextInt(CLIPPED) == 0) random.nextInt(3) else -1
        for (corner in 0 until 3) {
            val at = 9 * triangle + 3 * corner
            positions[at] = random.nextInt(raster.width + 1).toFloat()
            positions[at + 1] = random.nextInt(raster.height + 1).toFloat()
            positions[at + 2] = if (corner == outside) beyond(z) else z
        }
    }
    return Mesh(positions, IntArray(3 * count) { it })
}

/** Returns the depth that is as far beyond the nearer one of the planes as [z] is before it. */
private fun beyond(z: Float): Float = if (z <= 0.5f) -z else 2 - z

private fun joined(parts: List<Mesh>, material: Material = Material()): Mesh {
    val positions = parts.flatMap { it.positions.toList() }.toFloatArray()
    return Mesh(positions, IntArray(positions.size / 3) { it }, material)
}

/** Reads parts that are in memory. */
private class Parts(private val parts: List<Mesh>) : MeshSource {
    override val triangleCount: Int = parts.sumOf { it.triangleCount }
    override val hasColors: Boolean get() = false
    override val partCount: Int get() = parts.size
    override val origin: Vector3dc get() = parts.first().origin

    override fun triangleCount(number: Int): Int = parts[number].triangleCount

    override fun bounds(number: Int): Box? = parts[number].bounds

    override fun read(first: Int, count: Int): Mesh = joined(parts.subList(first, first + count))
}
