package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.gltf.GltfFiles
import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.surface.Mesh
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** `EXT_mesh_gpu_instancing` and `CESIUM_RTC`. */
class GltfInstancesTest {
    private val files = GltfFiles().also { it.accessor("VEC3", FLOAT, listOf(0, 0, 0, 1, 0, 0, 0, 1, 0)) }

    private fun json(attributes: String, more: String = ""): String {
        val extension = """"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{$attributes}}}"""
        val nodes = """"nodes":[{"translation":[10,0,0],"children":[1]},{"mesh":0,"scale":[2,2,2],$extension}]"""
        val scenes = """"scene":0,"scenes":[{"nodes":[0]}],"extensionsRequired":["EXT_mesh_gpu_instancing"]"""
        return files.json("""$scenes,$nodes,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]$more""")
    }

    private fun parse(json: String, limits: LoadLimits = LoadLimits()) = GltfParser.parse(source(json, limits)).meshes

    private fun source(json: String, limits: LoadLimits) =
        Source(json.toByteArray(), "test", null, Loading(LoadOptions(limits)))

    private fun corners(mesh: Mesh): List<Float> = mesh.positions.indices.map {
        (mesh.positions[it] + mesh.origin.get(it % 3)).toFloat()
    }

    @Test
    fun eachInstanceIsMovedBeforeItsNode() {
        val moves = files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 0, 0, 5))
        val turns = files.accessor("VEC4", FLOAT, listOf(0, 0, 0, 1, 0, 0, 1, 0))
        val scales = files.accessor("VEC3", FLOAT, listOf(1, 1, 1, 3, 1, 1))
        val all = parse(json(""""TRANSLATION":$moves,"ROTATION":$turns,"SCALE":$scales,"_ID":$moves"""))
        assertEquals(
            listOf(listOf(10f, 0f, 0f, 12f, 0f, 0f, 10f, 2f, 0f), listOf(10f, 0f, 10f, 4f, 0f, 10f, 10f, -2f, 10f)),
            all.map(::corners),
        )
    }

    @Test
    fun instancesHaveEquallyManyElements() {
        val moves = files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 0, 0, 5))
        val scales = files.accessor("VEC3", FLOAT, listOf(1, 1, 1))
        val json = json(""""TRANSLATION":$moves,"SCALE":$scales""")
        val error = TestSources.error(GltfParser, TestSources.of(json))
        assertEquals("nodes[1].extensions.EXT_mesh_gpu_instancing.attributes", error.location)
        assertTrue("different lengths: 2, 1" in error.message!!, error.message)
    }

    @Test
    fun limitsApplyToAllInstances() {
        val moves = files.accessor("VEC3", FLOAT, List(30) { it })
        val json = json(""""TRANSLATION":$moves""")
        assertEquals(10, parse(json, LoadLimits(triangles = 10, vertices = 33)).size)
        val few = TestSources.error(GltfParser, source(json, LoadLimits(triangles = 9)))
        assertTrue("more than 9 triangles: 10 at least" in few.message!!, few.message)
        val vertices = TestSources.error(GltfParser, source(json, LoadLimits(vertices = 32)))
        assertTrue("more than 32 vertices" in vertices.message!!, vertices.message)
    }

    @Test
    fun instancesThatAreNoNumbersAreLeftOut() {
        val moves = files.accessor("VEC3", FLOAT, listOf(0, 0, 0, Float.NaN, 0, 5, 1e38f, 0, 0))
        val scales = files.accessor("VEC3", FLOAT, listOf(1, 1, 1, 1, 1, 1, 1, Float.POSITIVE_INFINITY, 1))
        val source = TestSources.of(json(""""TRANSLATION":$moves,"SCALE":$scales"""))
        assertEquals(1, GltfParser.parse(source).surfaces.size)
        assertEquals(listOf("test: instances whose transform is not finite are left out: 2"), source.warnings)
    }

    @Test
    fun theWholeModelIsRelativeToItsCenter() {
        val center = ""","extensions":{"CESIUM_RTC":{"center":[4280244.25,0,-1]}}"""
        val moved = json("", center).replace("[\"EXT_mesh_gpu_instancing\"]", "[\"CESIUM_RTC\"]")
        val mesh = parse(moved).single()
        assertEquals(4280254.25, mesh.bounds!!.minX)
        assertEquals(4280256.25, mesh.bounds!!.maxX)
        assertEquals(-1.0, mesh.bounds!!.maxZ)
        val error = TestSources.error(GltfParser, TestSources.of(json("", center.replace(",-1", ""))))
        assertEquals("extensions.CESIUM_RTC.center", error.location)
    }
}
