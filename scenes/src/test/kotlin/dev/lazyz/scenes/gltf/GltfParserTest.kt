package dev.lazyz.scenes.gltf

import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.ONE_NODE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.UBYTE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.UINT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.USHORT
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class GltfParserTest {
    private val triangle = listOf(0, 0, 0, 1, 0, 0, 0, 1, 0)

    private fun parse(json: String, folder: Path? = null): Scene = GltfParser.parse(TestSources.of(json, folder))

    private fun mesh(json: String): Mesh = parse(json).meshes.single()

    private fun file(rest: String): String {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, triangle)
        return files.json(""""meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],$rest""")
    }

    @Test
    fun bothFormsGiveTheSameMesh() {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, triangle)
        val rest = """$ONE_NODE,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]"""
        val text = mesh(files.json(rest))
        assertEquals(triangle.map { it.toFloat() }, text.corners().flatten())
        assertNull(text.normals, "flat without normals")
        val binary = GltfParser.parse(TestSources.of(files.glb(rest))).meshes.single()
        assertEquals(text.corners(), binary.corners())
    }

    @Test
    fun indicesOfAllTypesAndAllKindsOfTriangles() {
        val square = listOf(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0)
        val expected = mapOf(4 to listOf(0, 1, 2), 5 to listOf(0, 1, 2, 1, 3, 2), 6 to listOf(1, 2, 0, 2, 3, 0))
        for ((mode, triangles) in expected) {
            for (type in listOf(UBYTE, USHORT, UINT, null)) {
                val files = GltfFiles()
                files.accessor("VEC3", FLOAT, square)
                if (type != null) files.accessor("SCALAR", type, if (mode == 4) listOf(0, 1, 2) else listOf(0, 1, 2, 3))
                val indices = if (type == null) "" else ",\"indices\":1"
                val part = """{"attributes":{"POSITION":0},"mode":$mode$indices}"""
                val mesh = mesh(files.json("""$ONE_NODE,"meshes":[{"primitives":[$part]}]"""))
                assertArrayEquals(triangles.toIntArray(), mesh.triangles, "mode $mode, type $type")
            }
        }
    }

    @Test
    fun surfacesHaveThePathOfTheirNode() {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, triangle)
        val part = """{"attributes":{"POSITION":0}}"""
        val nodes = """[{"name":"car","children":[1,2]},{"children":[3]},{"mesh":0},{"name":"wheel","mesh":0,""" +
            """"translation":[1,0,0],"children":[4]},{"name":" ","mesh":1}]"""
        val meshes = """[{"name":"tyre","primitives":[$part,$part]},{"primitives":[$part]}]"""
        val scene = parse(files.json(""""nodes":$nodes,"meshes":$meshes"""))
        assertEquals(
            listOf("car/wheel", "car/wheel", "car/wheel", "car/tyre", "car/tyre"),
            scene.surfaces.map { it.name },
        )
    }

    @Test
    fun transformsComposeFromTheRootDown() {
        // Half a turn around z, after a stretch; then the parent moves it
        val json = file(
            """"nodes":[{"children":[1],"translation":[10,0,0]},{"mesh":0,"scale":[2,3,4],"rotation":[0,0,1,0]}]""",
        )
        assertEquals(listOf(10f, 0f, 0f, 8f, 0f, 0f, 10f, -3f, 0f), mesh(json).corners().flatten().map { it + 0f })
    }

    @Test
    fun quarterTurnsFollowTheRightHand() {
        val h = 0.70710677
        val turned = mapOf(
            "[$h,0,0,$h]" to listOf(listOf(1f, 0f, 0f), listOf(0f, 0f, 1f)),
            "[0,$h,0,$h]" to listOf(listOf(0f, 0f, -1f), listOf(0f, 1f, 0f)),
            "[0,0,$h,$h]" to listOf(listOf(0f, 1f, 0f), listOf(-1f, 0f, 0f)),
        )
        for ((rotation, ends) in turned) {
            val corners = mesh(file(""""nodes":[{"mesh":0,"rotation":$rotation}]""")).corners()
            for (i in 0 until 6) assertEquals(ends.flatten()[i], corners.drop(1).flatten()[i], 1e-6f, rotation)
        }
    }

    @Test
    fun mirrorKeepsTheOutsideOutside() {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, triangle)
        files.accessor("VEC3", FLOAT, listOf(0, 0, 1, 0, 0, 1, 0, 0, 1))
        val part = """{"attributes":{"POSITION":0,"NORMAL":1}}"""
        val json = files.json(""""nodes":[{"mesh":0,"scale":[-1,1,1]}],"meshes":[{"primitives":[$part]}]""")
        val mesh = mesh(json)
        val (a, b, c) = mesh.corners()
        assertTrue((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0f, "counter-clockwise seen from +z")
        assertEquals(1f, mesh.normals!![2])
    }

    @Test
    fun onlyTheDefaultSceneIsSeenOrElseAllRoots() {
        val nodes = """"nodes":[{"mesh":0},{"mesh":0,"children":[2]},{"mesh":0}]"""
        assertEquals(2, parse(file("""$nodes,"scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}]""")).surfaces.size)
        assertEquals(3, parse(file(nodes)).surfaces.size)
    }

    @Test
    fun hiddenNodesAreNotShownNorTheirDescendants() {
        fun node(x: Int, visible: Boolean?, more: String = "") = """{"mesh":0,"translation":[$x,0,0]$more""" +
            (visible?.let { ""","extensions":{"KHR_node_visibility":{"visible":$it}}""" } ?: "") + "}"
        val required = ""","extensionsUsed":["KHR_node_visibility"],"extensionsRequired":["KHR_node_visibility"]"""

        fun shown(vararg nodes: String): Pair<List<Float>, List<String>> {
            val source = TestSources.of(file(""""nodes":[${nodes.joinToString()}]$required"""))
            return GltfParser.parse(source).meshes.map { it.positions[0] } to source.warnings
        }
        val child = ""","children":[3]"""
        val nodes = arrayOf(node(1, null), node(2, true), node(3, false, child), node(9, true))
        assertEquals(listOf(1f, 2f) to emptyList<String>(), shown(*nodes))
        val empty = """{"extensions":{"KHR_node_visibility":{}},"mesh":0}"""
        assertEquals(listOf(0f) to emptyList<String>(), shown(empty))
        val hidden = "test: all nodes with meshes are hidden, so there is nothing to see"
        assertEquals(emptyList<Float>() to listOf(hidden), shown(node(1, false)))
        val none = "test: no node of the scene has a mesh, so there is nothing to see"
        assertEquals(emptyList<Float>() to listOf(none), shown("{}"))
    }

    @Test
    fun onePrimitiveIsOneMesh() {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, triangle)
        val part = """{"attributes":{"POSITION":0}"""
        val parts = """$part,"material":1},$part,"mode":1},$part,"material":0}"""
        val materials = """"materials":[{"name":"a"},{"name":"b"}]"""
        val json = files.json("""$ONE_NODE,"meshes":[{"primitives":[$parts]}],$materials""")
        val source = TestSources.of(json)
        val surfaces = GltfParser.parse(source).surfaces
        assertEquals(listOf("b", "a"), surfaces.filterIsInstance<Mesh>().map { it.material.name })
        assertTrue(surfaces[1] is Lines)
        assertEquals(emptyList<String>(), source.warnings)
    }

    @Test
    fun externalBuffersAreFoundBesideTheFile(@TempDir folder: Path) {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, triangle)
        Files.write(folder.resolve("my data.bin"), files.buffer())
        val rest = """$ONE_NODE,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]"""
        val json = files.json(rest, "my%20data.bin")
        assertEquals(1, parse(json, folder).surfaces.size)
        assertTrue("my%20data.bin" in TestSources.error(GltfParser, TestSources.of(json)).message!!)
    }

    @Test
    fun cameraOfTheFileIsTheViewpoint() {
        fun scene(camera: String) =
            parse(file(""""nodes":[{"mesh":0},{"camera":0,"translation":[0,0,5]}],"cameras":[{$camera}]"""))
        val perspective = """"type":"perspective","perspective":"""
        val withFar = scene("""$perspective{"yfov":1.5707963,"znear":0.5,"zfar":50}""").viewpoint as Camera
        assertEquals(listOf(0.0, 0.0, 5.0), withFar.eye.let { listOf(it.x(), it.y(), it.z()) })
        assertEquals(90.0, (withFar.projection as Projection.Perspective).verticalFieldOfView, 1e-5)
        assertEquals(0.5 to 50.0, withFar.near to withFar.far)
        assertEquals(-1.0, withFar.toWorldDirection(0.0, 0.0, -1.0).z)

        val endless = scene("""$perspective{"yfov":1,"znear":0.5}""").camera(4, 3)
        assertTrue(endless.far in 5.09..5.3, "${endless.far}")
        val orthographic = """"type":"orthographic","orthographic":"""
        val flat = scene("""$orthographic{"xmag":3,"ymag":2,"znear":0,"zfar":9}""").viewpoint as Camera
        assertEquals(4.0, (flat.projection as Projection.Orthographic).height)
    }

    @Test
    fun allCamerasAreListedInTheOrderOfTheNodes() {
        val perspective = """{"type":"perspective","name":"NAME","perspective":{"yfov":1,"znear":1,"zfar":2}}"""
        val nodes = """"nodes":[{"mesh":0},{"camera":1,"name":"b"},{"camera":0,"name":"a"},{"camera":2,"name":"c"}]"""
        val json = """$nodes,"cameras":[${perspective.replace("NAME", "first")},{"type":"orthographic",
            "orthographic":{"xmag":1,"ymag":1,"znear":0,"zfar":5}},{"type":"perspective"}]"""
        val source = TestSources.of(file(json))
        val scene = GltfParser.parse(source)
        assertEquals(listOf("b", "first"), source.cameras.map { it.name })
        assertTrue(source.cameras[0].camera.projection is Projection.Orthographic)
        assertSame(source.cameras[0].camera, scene.viewpoint)
        assertTrue("cameras[2]" in source.warnings.single(), source.warnings.toString())
    }

    @Test
    fun impossibleCameraGivesAWarning() {
        val camera = """{"type":"perspective","perspective":{"yfov":0.5,"znear":5,"zfar":1}}"""
        val source = TestSources.of(file(""""nodes":[{"mesh":0},{"camera":0}],"cameras":[$camera]"""))
        assertTrue(GltfParser.parse(source).viewpoint !is Camera)
        assertTrue("cameras[0]" in source.warnings.single(), source.warnings.toString())
    }
}
