package dev.lazyz.scenes.stl

import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.scenes.meshes.AwkwardMesh
import dev.lazyz.world.surface.Mesh
import java.nio.ByteBuffer
import java.nio.ByteOrder
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class StlParserTest {
    private val corner = floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f)
    private val neighbour = floatArrayOf(1f, 0f, 0f, 1f, 1f, 0f, 0f, 1f, 0f)

    private fun ascii(vararg facets: FloatArray, name: String = "part one", normal: String = "0 0 1") = buildString {
        append("solid $name\n")
        for (facet in facets) {
            append("  facet normal $normal\n    outer loop\n")
            for (i in facet.indices step 3) append("      vertex ${facet[i]} ${facet[i + 1]} ${facet[i + 2]}\n")
            append("    endloop\n  endfacet\n")
        }
        append("endsolid $name\n")
    }

    private fun binary(vararg facets: FloatArray, header: String = "", count: Int = facets.size): ByteArray {
        val buffer = ByteBuffer.allocate(84 + 50 * facets.size).order(ByteOrder.LITTLE_ENDIAN)
        buffer.put(header.toByteArray()).position(80).putInt(count)
        for (facet in facets) {
            repeat(3) { buffer.putFloat(0f) }
            for (number in facet) buffer.putFloat(number)
            buffer.putShort(0)
        }
        return buffer.array()
    }

    private fun mesh(bytes: ByteArray): Mesh = StlParser.parse(TestSources.of(bytes)).meshes.single()

    private fun mesh(text: String): Mesh = mesh(text.toByteArray())

    @Test
    fun bothFormsGiveTheSameMesh() {
        val text = mesh(ascii(corner, neighbour))
        val bytes = mesh(binary(corner, neighbour))
        assertEquals(corner.toList() + neighbour.toList(), text.corners().flatten())
        assertEquals(text.corners(), bytes.corners())
        assertEquals(text.normals!!.toList(), bytes.normals!!.toList())
        assertEquals("part one", text.material.name)
    }

    @Test
    fun endsolidMayBeMissingAtTheEnd() {
        val far = FloatArray(9) { corner[it] + 1e6f }
        for (facet in listOf(corner, far)) {
            val source = TestSources.of(ascii(facet).substringBefore("endsolid"))
            assertEquals(1, StlParser.parse(source).meshes.single().triangleCount)
            assertTrue(source.warnings.single().contains("endsolid is missing"), source.warnings.toString())
        }
    }

    @Test
    fun cornersAtOnePositionAreOneVertex() {
        assertEquals(4, mesh(binary(corner, neighbour)).vertexCount)
        val negativeZero = neighbour.copyOf().also { it[2] = -0f }
        assertEquals(4, mesh(binary(corner, negativeZero)).vertexCount)
        val near = neighbour.copyOf().also { it[0] = 1.0000001f }
        assertEquals(5, mesh(binary(corner, near)).vertexCount)
    }

    @Test
    fun normalsFollowTheCornersWhateverTheFacetSays() {
        for (normal in listOf("0 0 -1", "0 0 0", "nan nan nan", "5 5 5")) {
            assertEquals(listOf(0f, 0f, 1f), mesh(ascii(corner, normal = normal)).normals!!.take(3), normal)
        }
    }

    @Test
    fun normalsAreSmoothUpToThirtyDegrees() {
        fun normalsOfFold(height: Float): Set<List<Float>> {
            val mesh = mesh(binary(corner, floatArrayOf(1f, 0f, 0f, 1f, 1f, height, 0f, 1f, 0f)))
            return mesh.normals!!.toList().chunked(3).toSet()
        }

        // The second facet leans by the angle whose tangent is height times the root of 2
        assertEquals(3, normalsOfFold(0.3f).size, "23 degrees: two flat ends and the fold")
        assertEquals(2, normalsOfFold(0.6f).size, "40 degrees: a crease")
    }

    @Test
    fun binaryFileMayBeginWithSolid() {
        assertEquals(2, mesh(binary(corner, neighbour, header = "solid part")).triangleCount)
        assertEquals(2, mesh(binary(corner, neighbour, header = "solid part".padEnd(80))).triangleCount)
        val withTail = binary(corner, neighbour, header = "solid part") + ByteArray(7)
        val source = TestSources.of(withTail)
        assertEquals(2, StlParser.parse(source).meshes.single().triangleCount)
        assertTrue(source.warnings.single().contains("7 bytes after the last of 2 facets"), source.warnings.toString())
    }

    @Test
    fun aCountOfZeroStandsForAllFacets() {
        for ((header, tail) in listOf("" to 0, "solid part" to 0, "solid part".padEnd(80) to 7)) {
            val source = TestSources.of(binary(corner, neighbour, header = header, count = 0) + ByteArray(tail))
            val corners = StlParser.parse(source).meshes.single().corners()
            assertEquals(corner.toList() + neighbour.toList(), corners.flatten())
            assertTrue("announces 0 facets; the 2 that" in source.warnings.first(), source.warnings.toString())
            assertEquals(if (tail > 0) 2 else 1, source.warnings.size)
        }
        val empty = TestSources.of(binary())
        assertEquals(0, StlParser.parse(empty).meshes.size)
        assertEquals(listOf("test: there are no facets, so there is nothing to see"), empty.warnings)
    }

    /** A binary file in which as many bytes follow each facet as its word says. */
    private fun withPayload(vararg sizes: Int): ByteArray {
        val facets = Array(sizes.size) { if (it % 2 == 0) corner else neighbour }
        val plain = binary(*facets)
        return sizes.foldIndexed(plain.copyOf(84)) { i, bytes, size ->
            val facet = plain.copyOfRange(84 + 50 * i, 134 + 50 * i).also { it[48] = size.toByte() }
            bytes + facet + ByteArray(size) { 0x41 }
        }
    }

    @Test
    fun bytesThatFollowFacetsAreSkippedIfTheyFitTheFile() {
        for (file in listOf(withPayload(6, 0, 3), withPayload(6, 6, 6), withPayload(0, 0, 200))) {
            val source = TestSources.of(file)
            val mesh = StlParser.parse(source).meshes.single()
            assertEquals(corner.toList() + neighbour.toList() + corner.toList(), mesh.corners().flatten())
            assertEquals(null, mesh.colors)
            assertTrue("the attributes of 3 facets" in source.warnings.single(), source.warnings.toString())
        }
        val source = TestSources.of(withPayload(6, 6).dropLast(1).toByteArray())
        assertEquals(2, StlParser.parse(source).meshes.single().triangleCount)
        assertTrue("11 bytes after the last of 2 facets" in source.warnings.first(), source.warnings.toString())
    }

    @Test
    fun endsCanBeTwoWordsOrHaveTheNameAttached() {
        val text = ascii(corner, neighbour)
        val endings = listOf("end solid part one", "endsolidpart one", "END SOLID", "endsolid_1", "end\nsolid x")
        for (ending in endings) {
            val file = text.replace("endsolid part one", ending).replace("endloop", "end loop")
                .replace("endfacet", "End Facet") + ascii(corner, name = "next")
            val names = StlParser.parse(TestSources.of(file)).meshes.map { it.material.name }
            assertEquals(listOf("part one", "next"), names)
        }
        val error = TestSources.error(StlParser, TestSources.of(text.replaceFirst("endloop", "end lop")))
        assertEquals("\"lop\" stands where loop should", error.problem)
    }

    @Test
    fun shortBinaryFileNamesTheFacetAndTheCount() {
        val error = TestSources.error(StlParser, TestSources.of(binary(corner, neighbour).copyOf(84 + 50 + 20)))
        assertEquals("byte 154", error.location)
        assertTrue(error.problem.contains("within facet 1 of the 2 "), error.problem)
        val huge = TestSources.error(StlParser, TestSources.of(binary(corner, count = -1)))
        assertTrue(huge.problem.contains("4294967295"), huge.problem)
    }

    @Test
    fun whatLooksLikeTextIsReadAsText() {
        val text = ascii(corner, neighbour)
        val commented = "# c\n" + text.replace("\n", " # d\n")
        for (file in listOf("$text\u0000\u0000\u0000", "$text\u001A\n$text", commented, "\n\u0000\n$text")) {
            assertEquals(2, StlParser.parse(TestSources.of(file)).meshes.first().triangleCount, file)
        }
    }

    @Test
    fun wrongWordNamesItsLine() {
        val text = ascii(corner).replace("endloop", "endlop")
        val error = TestSources.error(StlParser, TestSources.of(text))
        assertEquals("line 7", error.location)
        assertTrue(error.problem.contains("endlop"), error.problem)

        val comma = TestSources.error(StlParser, TestSources.of(ascii(corner).replace("1.0 0.0 0.0", "1,0 0,0 0,0")))
        assertEquals("line 5", comma.location)
        assertTrue(comma.remedy!!.contains("decimal point"), comma.remedy)

        val commas = TestSources.error(StlParser, TestSources.of(ascii(corner).replace("1.0 0.0 0.0", "1, 0, 0")))
        assertTrue(commas.remedy!!.contains("spaces between numbers"), commas.remedy)
    }

    @Test
    fun anAwkwardMeshIsTheSameInBothForms() {
        val facets = AwkwardMesh.facets().toTypedArray()
        val text = mesh(ascii(*facets))
        val bytes = mesh(binary(*facets))
        assertEquals(facets.flatMap { it.asList() }, text.corners().flatten())
        assertEquals(text.positions.toList(), bytes.positions.toList())
        assertEquals(text.triangles.toList(), bytes.triangles.toList())
        assertEquals(text.normals!!.toList(), bytes.normals!!.toList())
    }
}
