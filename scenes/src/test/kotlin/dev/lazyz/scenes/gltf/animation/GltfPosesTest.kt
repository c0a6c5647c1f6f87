package dev.lazyz.scenes.gltf.animation

import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.gltf.GltfFiles
import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.UBYTE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.USHORT
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.surface.Mesh
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Skins, morph targets and animations in glTF files. */
class GltfPosesTest {
    private val triangle = listOf(0, 0, 0, 1, 0, 0, 0, 1, 0)
    private val up = listOf(0, 0, 1, 0, 0, 1, 0, 0, 1)

    private fun source(json: String, time: Double? = null) =
        Source(json.toByteArray(), "test", null, Loading(LoadOptions(animationTime = time)))

    private fun mesh(json: String, time: Double? = null): Mesh = GltfParser.parse(source(json, time)).meshes.single()

    /** Two joints, the second moved up by 5; the mesh hangs below a node that is elsewhere. */
    private fun skinned(
        joints: List<Number> = listOf(0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0),
        weights: List<Number> = listOf(1, 0, 0, 0, 1, 0, 0, 0, 2, 2, 0, 0),
        type: Int = FLOAT,
        jointType: Int = UBYTE,
        skin: String = """{"joints":[1,2]}""",
        more: String = "",
    ): String {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, triangle)
        files.accessor("VEC3", FLOAT, up)
        files.accessor("VEC4", jointType, joints)
        files.accessor("VEC4", type, weights, if (type == FLOAT) "" else ",\"normalized\":true")
        files.accessor("VEC4", UBYTE, List(12) { if (it == 0) 1 else 0 })
        files.accessor("VEC4", FLOAT, List(12) { if (it == 0) 3 else 0 })
        val bind = files.view(files.encode(FLOAT, List(32) { if (it % 5 == 0 && it < 16) 1 else 0 }))
        files.accessor("""{"bufferView":$bind,"componentType":$FLOAT,"count":2,"type":"MAT4"}""")
        files.accessor("SCALAR", FLOAT, listOf(0, 2))
        files.accessor("VEC3", FLOAT, listOf(0, 5, 0, 0, 9, 0))
        val attributes = """"POSITION":0,"NORMAL":1,"JOINTS_0":2,"WEIGHTS_0":3$more"""
        return files.json(
            """"nodes":[{"mesh":0,"skin":0,"translation":[99,0,0]},{"children":[2]},{"translation":[0,5,0]}],
            "meshes":[{"primitives":[{"attributes":{$attributes}}]}],"skins":[$skin],
            "animations":[{"channels":[{"sampler":0,"target":{"node":2,"path":"translation"}}],
                "samplers":[{"input":7,"output":8}]}]""",
        )
    }

    @Test
    fun verticesFollowTheirJointsByWeightsOfSumOne() {
        val expected = listOf(0f, 0f, 0f, 1f, 5f, 0f, 0f, 3.5f, 0f)
        val mesh = mesh(skinned())
        assertEquals(expected, mesh.positions.toList())
        assertEquals(up.map { it.toFloat() }, mesh.normals!!.toList())
        val weights = listOf(255, 0, 0, 0, 255, 0, 0, 0, 128, 128, 0, 0)
        val bytes = skinned(weights = weights, type = UBYTE, jointType = USHORT)
        assertEquals(expected, mesh(bytes).positions.toList())
    }

    @Test
    fun inverseBindMatricesComeFirst() {
        // The first is the identity, and the second has nothing but zeros
        val bound = mesh(skinned(skin = """{"joints":[1,2],"inverseBindMatrices":6}"""))
        assertEquals(listOf(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0.5f, 0f), bound.positions.toList())
    }

    @Test
    fun jointsThatDoNotExistAreErrors() {
        fun fails(json: String, location: String, part: String) {
            val error = TestSources.error(GltfParser, source(json))
            assertEquals(location, error.location, error.message)
            assertTrue(part in error.message!!, error.message)
        }
        val attributes = "meshes[0].primitives[0].attributes"
        fails(skinned(joints = List(12) { 2 }), attributes, "vertex 0 follows joint 2, but there are 2")
        fails(skinned(skin = """{"joints":[1,7]}"""), "skins[0].joints[1]", "nodes[7]")
        val short = """{"joints":[1,2,1],"inverseBindMatrices":6}"""
        fails(skinned(skin = short), "skins[0].inverseBindMatrices", "2 matrices for 3 joints")
        fails(skinned().replace("\"skin\":0", "\"skin\":3"), "nodes[0].skin", "skins[3]")
        val circle = skinned().replace("\"children\":[2]", "\"children\":[2,1]")
        val scene = "\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
        fails(circle.replace("\"nodes\":", "$scene\"nodes\":"), "skins[0].joints[0]", "itself")
    }

    @Test
    fun animationMovesJoints() {
        assertEquals(7f, mesh(skinned(), 1.0).positions[4])
        assertEquals(9f, mesh(skinned(), 100.0).positions[4])
        assertEquals(5f, mesh(skinned(), 0.0).positions[4])
    }

    /** A triangle that grows by two targets, with what else is said of nodes, meshes and animations. */
    private fun morphed(mesh: String = "", node: String = "", more: String = ""): String {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, triangle)
        files.accessor("VEC3", FLOAT, up)
        files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 2, 0, 0, 0, 0, 0))
        files.accessor("VEC3", FLOAT, listOf(0, 0, 8, 0, 0, 8, 0, 0, 8))
        files.accessor("VEC3", FLOAT, listOf(1, 0, -1, 0, 0, 0, 0, 0, 0))
        files.accessor("SCALAR", FLOAT, listOf(0, 1))
        files.accessor("SCALAR", FLOAT, listOf(0, 0, 1, 0.5))
        files.accessor("SCALAR", FLOAT, listOf(0, 0, 1))
        val targets = """[{"POSITION":2,"NORMAL":4},{"POSITION":3}]"""
        return files.json(
            """"nodes":[{"mesh":0$node}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},
            "targets":$targets}]$mesh}]$more""",
        )
    }

    @Test
    fun morphTargetsAreAddedByTheirWeights() {
        assertEquals(triangle.map { it.toFloat() }, mesh(morphed()).positions.toList())
        val ofMesh = ""","weights":[1,0.5]"""
        val mesh = mesh(morphed(ofMesh))
        assertEquals(listOf(0f, 0f, 4f, 3f, 0f, 4f, 0f, 1f, 4f), mesh.positions.toList())
        assertEquals(listOf(1f, 0f, 0f), mesh.normals!!.take(3))
        assertEquals(listOf(2f, 0f, 0f), mesh(morphed(ofMesh, ""","weights":[0.5,0]""")).positions.slice(3..5))
    }

    @Test
    fun animationChangesWeights() {
        val animation = { sampler: String ->
            ""","animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],"samplers":[$sampler]}]"""
        }
        val json = morphed(more = animation("""{"input":5,"output":6}"""))
        assertEquals(listOf(2f, 0f, 2f), mesh(json, 0.5).positions.slice(3..5))
        assertEquals(listOf(1f, 0f, 0f), mesh(json).positions.slice(3..5))

        val wrong = morphed(more = animation("""{"input":5,"output":7}"""))
        val error = TestSources.error(GltfParser, source(wrong, 0.5))
        assertEquals("animations[0].samplers[0]", error.location)
        assertTrue("3 numbers for 2 moments, not 4" in error.message!!, error.message)
        val unknown = morphed(more = animation("""{"input":5,"output":6,"interpolation":"MAGIC"}"""))
        assertTrue(warnings(unknown, 0.5).single().contains("interpolation"))
    }

    @Test
    fun warningsSayWhatIsNotApplied() {
        assertEquals(listOf("animations are not applied: 1"), warnings(skinned(), null).map { it.substringBefore(';') })
        assertEquals(emptyList<String>(), warnings(skinned(), 1.0))
        val two = skinned().replace("\"animations\":[", "\"animations\":[{\"channels\":[],\"samplers\":[]},")
        assertTrue(warnings(two, 1.0).any { "only the first of 2 animations" in it })
        assertTrue(warnings(morphed(), 1.0).single().startsWith("there is no animation"))
    }

    private fun warnings(json: String, time: Double?): List<String> =
        source(json, time).also { GltfParser.parse(it) }.warnings.map { it.removePrefix("test: ") }

    @Test
    fun damageIsReportedAndNothingElse() {
        val bytes = skinned().toByteArray()
        for (at in bytes.indices step 3) {
            val bad = bytes.copyOf().also { it[at] = (it[at].toInt() xor 1).toByte() }
            try {
                GltfParser.parse(source(String(bad, Charsets.ISO_8859_1), 1.0))
            } catch (_: SceneFormatException) {
                // The one exception that is allowed
            }
        }
    }
}
