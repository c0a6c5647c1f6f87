package dev.lazyz.scenes.obj

import dev.lazyz.Rgba
import dev.lazyz.scenes.loading.PartNames
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.scenes.meshes.AwkwardMesh
import dev.lazyz.world.surface.Mesh
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ObjParserTest {
    private val square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

    private fun parse(text: String): Pair<List<Mesh>, Source> =
        TestSources.of(text).let { ObjParser.parse(it).meshes to it }

    private fun meshes(text: String): List<Mesh> = parse(text).first

    private fun mesh(text: String): Mesh = meshes(text).single()

    /** The x and y of all corners as one digit each. */
    private fun outline(mesh: Mesh) = mesh.corners().joinToString(" ") { "${it[0].toInt()}${it[1].toInt()}" }

    @Test
    fun objectsAndGroupsAreParts() {
        val text = square + "f 1 2 3\nusemtl red\no car\nf 1 2 3\ng door left\nf 1 2 4\ng\nf 1 3 4\ng door left\n" +
            "f 2 3 4\no road\nf 1 2 3\nl 1 2\nl 2 3\ng edge\np 1\n"
        val surfaces = ObjParser.parse(TestSources.of(text)).surfaces
        assertEquals(
            listOf("", "car", "car/door left", "road", "road/edge", "road"),
            surfaces.map { it.name },
        )
        assertEquals(listOf(1, 2, 2, 1), surfaces.filterIsInstance<Mesh>().map { it.triangleCount })
    }

    /** The normals of a group at its border are those of the whole object. */
    @Test
    fun aChangeOfGroupMakesNoCrease() {
        val roof = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0.2\nv 1 2 0.2\nf 1 2 3 4\n%sf 4 3 6 5\n"
        val whole = mesh(roof.format(""))
        val parts = meshes(roof.format("g top\n"))
        fun normals(mesh: Mesh) = mesh.triangles.map { vertex -> List(3) { mesh.normals!![3 * vertex + it] } }
        assertEquals(normals(whole), parts.flatMap { normals(it) })
    }

    /** A group with a long name around many others would otherwise need memory for it in each of them. */
    @Test
    fun pathsAreCutAndCounted() {
        val text = square + "o ${"long".repeat(1000)}\n" + (1..3).joinToString("") { "g $it\nf 1 2 3\n" }
        val source = TestSources.of(text)
        val names = ObjParser.parse(source).surfaces.map { it.name }
        assertEquals(listOf("1", "2", "3"), names.map { it.substringAfterLast('/') })
        for (name in names) assertEquals("...", name.take(3))
        assertEquals(setOf(PartNames.LONGEST), names.map { it.length }.toSet())
        assertTrue(source.loading.used.decoded > 3 * PartNames.bytes(names[0]))
    }

    /** Faces of plain numbers are read in one go, others, such as those that count backward, word by word. */
    @Test
    fun bothWaysToReadFacesAgree() {
        val text = square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nvn 0 1 0\n"
        val faces = listOf(
            "1 2 3 4" to "-4 -3 -2 -1",
            "1/1 2/2 3/3 4/4" to "-4/-4 -3/-3 -2/-2 -1/-1",
            "1//1 2//1 3//2 4//2" to "1//-2 2//1 3//2 4//2",
            "1/1/1 2/2/1 3/3/2 4/4/2" to "1/1/1 2/2/1 3/-2/2 4/4/2",
            "1/ 2/ 3/ 4/" to "-4/ 2 3// 4",
            "1 2 3/3 4" to "-4 2 3 4",
            "1 2 3 4 # 5" to "-4 2 3 4 # 5",
            "1 2 \\\n 3\t4" to "1 -3 3 4",
            "0000000001 2 3 4" to "1 2 3 4",
        )
        for ((plain, other) in faces) {
            val (first, second) = listOf(plain, other).map { mesh("${text}f $it \n") }
            assertArrayEquals(second.positions, first.positions, plain)
            assertArrayEquals(second.triangles, first.triangles, plain)
            assertArrayEquals(second.normals, first.normals, plain)
            assertArrayEquals(second.uvs, first.uvs, plain)
        }
        for (bad in listOf("1/2/3/ 2/2/2 3/3/3", "1 2 3x", "1 2 0", "1 2 99999999999", "1 2 1e1", "1/0 2/0 3/0")) {
            val source = TestSources.of("${text}f $bad\n")
            if ('/' in bad && "0" in bad) {
                ObjParser.parse(source)
                assertEquals(1, source.warnings.size, bad)
            } else {
                assertEquals("line 11", TestSources.error(ObjParser, source).location, bad)
            }
        }
    }

    @Test
    fun concaveFaceIsCutAtItsNotch() {
        val mesh = mesh("v 0 0 0\nv 4 2 0\nv 0 4 0\nv 1 2 0\nf 1 2 3 4\n")
        val triangles = outline(mesh).split(' ').chunked(3).map { it.toSet() }.toSet()
        assertEquals(setOf(setOf("00", "42", "12"), setOf("42", "04", "12")), triangles)
    }

    @Test
    fun normalsAreMadeSmoothUpToFortyFiveDegreesOrFlatAfterSOff() {
        fun fold(height: String, statement: String = ""): Int? {
            val mesh = mesh("v 0 0 0\nv 1 0 0\nv 1 1 $height\nv 0 1 0\n${statement}f 1 2 4\nf 2 3 4\n")
            return mesh.normals?.toList()?.chunked(3)?.toSet()?.size
        }
        assertEquals(3, fold("0.6"), "40 degrees")
        assertEquals(2, fold("0.8"), "49 degrees")
        assertEquals(3, fold("0.6", "s 1\n"))
        assertNull(fold("0.6", "s off\n"))
        assertNull(fold("0.6", "s 0\n"))
    }

    @Test
    fun facesWithoutTextureCoordinatesOrNormalsAreMeshesOfTheirOwn() {
        val text = square + "vt 0.5 0.25\nvn 0 0 -1\nf 1/1 2/1 3/1\nf 1 3 4\nf 1//1 3//1 4//1\nf 2/1 3/1 4/1\n"
        val meshes = meshes(text)
        assertEquals(listOf(2, 1, 1), meshes.map { it.triangleCount })
        assertEquals(listOf(true, false, false), meshes.map { it.uvs != null })
        assertEquals(listOf(0.5f, 0.75f), meshes[0].uvs!!.take(2))
        assertEquals(-1f, meshes[2].normals!![2])
        assertEquals(1f, meshes[1].normals!![2])
    }

    @Test
    fun attributesThatSomeCornersLackAreLeftOut() {
        // The parser behind would give corner 2 what the face before had there
        val mesh = meshes(square + "vt 0 0\nvt 1 1\nvn 0 0 -1\nf 1/2/1 2/2/1 3/2/1\nf 1/1 2 3/1\nf 1//1 2 3//1\n")
        assertEquals(listOf(true, false), mesh.map { it.uvs != null })
        assertEquals(2, mesh[1].triangleCount)
        assertEquals(1f, mesh[1].normals!![2])
    }

    @Test
    fun linesMayBeContinued() {
        // Not even the character before the backslash is lost
        assertEquals("00 10 11", outline(mesh(square + "f 1 2\\\n3\n")))
        assertEquals("00 10 11", outline(mesh(square + "f 1 \\\r\n 2 \\\r\n 3\r\n")))
        assertEquals("00 10 11", outline(mesh(square + "f 1 2 3 \\")))
        assertEquals("00 10 11", outline(mesh(square + "\\\n\\\nf 1 2 3")))
    }

    @Test
    fun vertexColoursAreDecoded() {
        val mesh = mesh("v 0 0 0 1 0.5 0\nv 1 0 0\nv 1 1 0 0 0 1\nf 1 2 3\n")
        val half = Rgba.ofRgb(0x808080).red
        assertEquals(listOf(1f, 0f, 1f), listOf(mesh.colors!![0], mesh.colors!![2], mesh.colors!![3]))
        assertEquals(half, mesh.colors!![1], 0.003f)
        assertEquals(listOf(1f, 1f, 1f, 1f, 0f, 0f, 1f, 1f), mesh.colors!!.drop(4))
        assertNull(mesh(square + "f 1 2 3\n").colors)
        assertNull(mesh("v 0 0 0 1\nv 1 0 0 1\nv 1 1 0 1\nf 1 2 3\n").colors, "a fourth number is a weight")
    }

    @Test
    fun whatIsNotDrawnGivesOneWarningAKind() {
        val text = "curv 0 1 1 2\nCURV 0 1 2 3\nvp 1\nxyz\ng a\nlod 1\nf 1 2\nf 1 2 3\n"
        val (meshes, source) = parse(square + text)
        assertEquals(1, meshes.single().triangleCount)
        assertEquals(3, source.warnings.size, source.warnings.toString())
        assertTrue(source.warnings.any { "line 11: a face of 2 corners" in it })
        assertTrue(source.warnings.any { it.endsWith("their statements are passed over: 2 curv, 1 vp") })
        assertTrue(source.warnings.any { it.endsWith("unknown statements are passed over: 1 xyz") })
    }

    @Test
    fun anAwkwardMeshIsWhole() {
        val count = AwkwardMesh.positions.size / 3
        val text = buildString {
            append("# by hand\r\no ball\r\ng all\r\ns 1\r\n")
            for (v in AwkwardMesh.positions.toList().chunked(3)) append("v  ${v.joinToString(" ")}\r\n")
            for (vt in AwkwardMesh.uvs.toList().chunked(2)) append("vt ${vt.joinToString(" ")} 0.0\r\n")
            for (vn in AwkwardMesh.directions.toList().chunked(3)) append("vn ${vn.joinToString(" ")}\r\n")
            for ((i, face) in AwkwardMesh.triangles.toList().chunked(3).withIndex()) {
                // Counted from the first vertex or from the last
                val numbers = face.map { if (i % 2 == 0) it + 1 else it - count }
                append(numbers.joinToString(" ", "f ", "\r\n") { "$it/$it/$it" })
            }
        }
        val (meshes, source) = parse(text)
        assertEquals(emptyList<String>(), source.warnings)
        val mesh = meshes.single()
        val corners = mesh.triangles.toList()
        assertEquals(AwkwardMesh.corners(AwkwardMesh.positions, 3), mesh.corners())
        assertEquals(
            AwkwardMesh.corners(AwkwardMesh.directions, 3),
            corners.map { mesh.normals!!.slice(3 * it until 3 * it + 3) },
        )
        assertEquals(
            AwkwardMesh.corners(AwkwardMesh.uvs, 2).map { (u, v) -> listOf(u, 1 - v) },
            corners.map { mesh.uvs!!.slice(2 * it until 2 * it + 2) },
        )
    }
}
