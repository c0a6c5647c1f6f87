package dev.lazyz.spark

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.spark.triangles.SerializableCamera
import dev.lazyz.spark.triangles.TriangleScene
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Surface
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import org.apache.spark.SparkException
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.functions.col
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

class TrianglePictureTest {
    private val spark = TestSpark.session

    /** The scene of the tests, for any of the triangles. The camera is the one that is fitted to the teapot. */
    private class Upright(width: Int, height: Int) : TriangleScene {
        private val camera = SerializableCamera(fitted(teapot).camera(width, height))

        override fun scene(triangles: Surface): Scene = fitted(triangles).withViewpoint(camera.camera())

        companion object {
            private const val serialVersionUID = 1L
            private val teapot by lazy {
                val plain = LoadOptions(smoothNormals = false)
                Scenes.load(Models.stl(), SceneFormat.STL, options = plain).scene.surfaces[0]
            }

            fun fitted(triangles: Surface): Scene =
                Scene(listOf(triangles), background = Rgba.ofRgb(0x203040)).withUpAxis(UpAxis.Z)
        }
    }

    private fun stl(folder: Path, segments: Int = 6): Path =
        folder.resolve("teapot.stl").also { it.writeBytes(Models.stl(segments)) }

    /** What one JVM renders, with all triangles in memory. */
    private fun frame(file: Path, width: Int, height: Int): Frame {
        val loaded = Scenes.load(file, LoadOptions(smoothNormals = false)).scene.surfaces.single()
        return Upright.fitted(loaded).frame(width, height)
    }

    private fun image(picture: TrianglePicture): Pair<Image, TriangleReport> {
        val collector = Image.Collector(Region(0, 0, picture.width, picture.height))
        val report = picture.render(collector)
        return collector.toImage(report.counters) to report
    }

    @ParameterizedTest
    @CsvSource("LAST, EAGER", "LAST, LAZY", "MIDDLE, EAGER")
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun bitsAreThoseOfOneJvm(order: SortOrder, shading: SortedShading, @TempDir folder: Path) {
        val file = stl(folder)
        val frame = frame(file, 300, 200)
        val expected = ZBufferRenderer().render(frame)

        // Twelve partitions, so that they are merged in two steps, and in another order
        val triangles = TriangleTable.readStl(spark, "$file", partitionBytes = 6000).repartition(12, col("x0"))
        val (image, report) = image(TrianglePicture(triangles, 300, 200, Upright(300, 200), order, shading))
        assertEquals(expected, image)
        assertEquals(expected.pixelHash(), image.pixelHash())
        assertEquals(frame.primitives.size.toLong(), report.counters.primitives)
        assertEquals(order, report.order)
        assertTrue(report.movedBytes > 0)
        if (shading == SortedShading.LAZY || order == SortOrder.MIDDLE) {
            assertEquals(expected.visible.toLong(), report.counters.shadingCalls)
        } else {
            assertTrue(report.counters.shadingCalls > expected.visible, "${report.counters}")
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun camerasAreFittedToAllTriangles(@TempDir folder: Path) {
        val file = stl(folder)
        val triangles = TriangleTable.readStl(spark, "$file", partitionBytes = 60_000).cache()
        val picture = TrianglePicture(triangles, 90, 80, TriangleScene { Upright.fitted(it) })
        assertEquals(ZBufferRenderer().render(frame(file, 90, 80)), image(picture).first)
    }

    /** Equal triangles in different partitions: the smallest index wins. */
    @ParameterizedTest
    @CsvSource("LAST, EAGER", "LAST, LAZY", "MIDDLE, EAGER")
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun tiesGoToTheFirstSubmitted(order: SortOrder, shading: SortedShading) {
        val corners = listOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f)
        val rows = listOf(7L, 3L, 5L).map { RowFactory.create(it, *corners.toTypedArray()) }
        val triangles = spark.createDataFrame(rows, TriangleTable.schema).repartition(3, col("index"))
        val flat = TriangleScene {
            val (eye, up) = listOf(Vector3d(0.5, 0.5, 3.0), Vector3d(0.0, 1.0, 0.0))
            Scene(listOf(it), viewpoint = Camera.perspective(eye, Vector3d(0.5, 0.5, 0.0), up, 40.0, 0.1, 10.0))
        }
        val (image, _) = image(TrianglePicture(triangles, 40, 30, flat, order, shading))
        assertEquals(setOf(-1, 3), image.primitive.toSet())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun severalBandsAreThoseOfOneJvm(@TempDir folder: Path) {
        val file = stl(folder)
        val expected = ZBufferRenderer().render(frame(file, 1300, 1000))
        val triangles = TriangleTable.readStl(spark, "$file", partitionBytes = 40_000).cache()
        for (order in SortOrder.entries) {
            val (image, _) = image(TrianglePicture(triangles, 1300, 1000, Upright(1300, 1000), order))
            assertEquals(expected.pixelHash(), image.pixelHash(), "$order")
        }
    }

    /** A camera among the triangles, so that some are behind it and some are cut. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun trianglesBehindTheCameraAreCut(@TempDir folder: Path) {
        val file = stl(folder)
        val eye = Vector3d(0.2, 0.4, 0.1)
        val inside = TriangleScene {
            val up = Vector3d(0.0, 1.0, 0.0)
            val camera = Camera.perspective(eye, Vector3d(5.0, 0.0, 1.0), up, 70.0, 0.01, 100.0)
            Upright.fitted(it).withViewpoint(camera)
        }
        val loaded = Scenes.load(file, LoadOptions(smoothNormals = false)).scene.surfaces.single()
        val expected = ZBufferRenderer().render(inside.scene(loaded).frame(200, 150))
        check(expected.visible > 1000)
        val triangles = TriangleTable.readStl(spark, "$file", partitionBytes = 40_000)
        for (order in SortOrder.entries) {
            assertEquals(expected, image(TrianglePicture(triangles, 200, 150, inside, order)).first, "$order")
        }
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun parquetAndPngAreThoseOfOneJvm(@TempDir folder: Path) {
        val file = stl(folder)
        TriangleTable.readStl(spark, "$file", partitionBytes = 40_000).write().parquet("${folder.resolve("t.parquet")}")
        val triangles = spark.read().parquet("${folder.resolve("t.parquet")}")
        val error = assertThrows(IllegalArgumentException::class.java) {
            TrianglePicture(triangles.drop("z2"), 120, 80, Upright(120, 80))
        }
        assertTrue("column 'z2' of type float" in error.message!!, error.message)
        val right = TrianglePicture(triangles, 120, 80, Upright(120, 80))
        right.writePng(folder.resolve("t.png"))
        assertArrayEquals(ZBufferRenderer().render(frame(file, 120, 80)).toPng(), folder.resolve("t.png").readBytes())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun plyIsThatOfOneJvm(@TempDir folder: Path) {
        for (order in listOf(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN)) {
            val file = folder.resolve("teapot.ply").also { it.writeBytes(ply(order)) }
            val triangles = TriangleTable.readPly(spark, "$file", partitionBytes = 9000)
            val loaded = Scenes.load(file, LoadOptions(smoothNormals = false)).scene.surfaces.single()
            val camera = Upright.fitted(loaded).camera(160, 120)
            val values = SerializableCamera(camera)
            val scene = TriangleScene { Upright.fitted(it).withViewpoint(values.camera()) }
            val expected = ZBufferRenderer().render(scene.scene(loaded).frame(160, 120))
            assertEquals(expected, image(TrianglePicture(triangles, 160, 120, scene)).first)
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun headersOfPlyAreReadAsScenesReadsThem(@TempDir folder: Path) {
        fun read(name: String, header: (String) -> String): Dataset<Row> {
            val bytes = ply(ByteOrder.LITTLE_ENDIAN)
            val old = String(bytes, Charsets.ISO_8859_1).substringBefore(END) + END
            val body = bytes.copyOfRange(old.length, bytes.size)
            val file = folder.resolve(name).also { it.writeBytes(header(old).toByteArray() + body) }
            return TriangleTable.readPly(spark, "$file")
        }

        // Lines may end as on Windows, and words may be apart by tabs and several spaces
        val plain = read("plain.ply") { it }.count()
        assertEquals(plain, read("windows.ply") { it.replace("\n", "\r\n") }.count())
        assertEquals(plain, read("spaces.ply") { it.replace("property ", "property \t ") }.count())

        // Whatever name Scenes.load has for colours and texture coordinates
        val names = listOf("diffuse_red diffuse_green diffuse_blue", "r g b", "texture_u texture_v", "nx ny nz")
        for (columns in names) {
            val properties = columns.split(' ').joinToString("") { "property float $it\n" }
            val error = assertThrows(SceneFormatException::class.java) {
                read("columns.ply") { it.replace("element face", "${properties}element face") }
            }
            val first = columns.substringBefore(' ')
            assertTrue("vertices have '$first'" in error.message!!, error.message)
        }
    }

    private fun ply(order: ByteOrder, corners: Int = 3): ByteArray {
        val mesh = Scenes.teapot(4).surfaces.filterIsInstance<Mesh>().first()
        val name = if (order == ByteOrder.BIG_ENDIAN) "big" else "little"
        val header = "ply\nformat binary_${name}_endian 1.0\ncomment a teapot\nelement vertex ${mesh.vertexCount}\n" +
            "property float x\nproperty float y\nproperty float z\nelement face ${mesh.triangleCount}\n" +
            "property list uchar int vertex_indices\nend_header\n"
        val size = header.length + 12 * mesh.vertexCount + 13 * mesh.triangleCount
        val bytes = ByteBuffer.allocate(size).order(order).put(header.toByteArray())
        for (number in mesh.positions) bytes.putFloat(number)
        for (i in mesh.triangles.indices) {
            if (i % 3 == 0) bytes.put(corners.toByte())
            bytes.putInt(mesh.triangles[i])
        }
        return bytes.array()
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun thePlannerSaysWhy(@TempDir folder: Path) {
        val triangles = TriangleTable.readStl(spark, "${stl(folder)}", partitionBytes = 20_000)
        val small = TrianglePicture(triangles, 20, 20, Upright(20, 20)).explain()
        assertTrue("LAST is used: it moves fewer bytes" in small, small)
        val large = TrianglePicture(triangles, 4000, 4000, Upright(4000, 4000)).explain()
        assertTrue("MIDDLE is used: it moves fewer bytes" in large, large)
        assertTrue("bytes of fragments" in large && "bytes of triangles" in large, large)
        val forced = TrianglePicture(triangles, 4000, 4000, Upright(4000, 4000), SortOrder.LAST).explain()
        assertTrue("it was asked for" in forced, forced)
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun whatCannotBeMergedIsRefused(@TempDir folder: Path) {
        val triangles = TriangleTable.readStl(spark, "${stl(folder)}")
        val glass = TriangleScene { triangles ->
            Scene(listOf(triangles)).withMaterials { Material(Rgba(1f, 1f, 1f, 0.5f), alphaMode = AlphaMode.BLEND) }
        }
        for (order in SortOrder.entries) {
            val error = assertThrows(IllegalArgumentException::class.java) {
                TrianglePicture(triangles, 20, 20, glass, order).render { _, _, _, _ -> }
            }
            assertTrue("DistributedPicture (sort-first)" in error.message!!, error.message)
        }
        val two = TriangleScene { Scene(listOf(it, it)) }
        val error = assertThrows(IllegalArgumentException::class.java) {
            TrianglePicture(triangles, 20, 20, two).render { _, _, _, _ -> }
        }
        assertTrue("only surface" in error.message!!, error.message)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun badFilesAreReported(@TempDir folder: Path) {
        fun problem(name: String, bytes: ByteArray, read: (String) -> Dataset<Row>): String {
            val file = folder.resolve(name).also { it.writeBytes(bytes) }
            var error: Throwable = assertThrows(Exception::class.java) { read("$file").count() }
            while (error is SparkException) error = error.cause!!
            return (error as SceneFormatException).message!!
        }
        val stl = Models.stl(2)
        val readStl = { path: String -> TriangleTable.readStl(spark, path) }
        val readPly = { path: String -> TriangleTable.readPly(spark, path) }
        assertTrue("byte 1000: the file ends within facet 18" in problem("cut.stl", stl.copyOf(1000), readStl))
        val colored = stl.clone().also { it[182] = 1 }
        assertTrue("byte 182: the facet has a colour" in problem("color.stl", colored, readStl))
        val ply = ply(ByteOrder.LITTLE_ENDIAN)
        assertTrue("would have" in problem("cut.ply", ply.copyOf(ply.size - 1), readPly))
        assertTrue("corners, and not 3" in problem("quads.ply", ply(ByteOrder.LITTLE_ENDIAN, 4), readPly))
        val wild = ply.clone().also { ByteBuffer.wrap(it).order(ByteOrder.LITTLE_ENDIAN).putInt(it.size - 4, 99999) }
        assertTrue("no vertex 99999" in problem("wild.ply", wild, readPly))
        val missing = assertThrows(SceneFormatException::class.java) { readStl("${folder.resolve("none.stl")}") }
        assertTrue("cannot be read" in missing.message!!)
    }

    private companion object {
        const val END = "end_header\n"
    }
}
