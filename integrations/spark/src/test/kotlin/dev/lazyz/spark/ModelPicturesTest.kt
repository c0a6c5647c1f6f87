package dev.lazyz.spark

import dev.lazyz.Image
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.camera.Camera
import java.nio.ByteBuffer
import java.nio.file.Path
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Row
import org.apache.spark.sql.functions.col
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

class ModelPicturesTest {
    private val spark = TestSpark.session

    private fun files(folder: Path): Dataset<Row> =
        spark.read().format("binaryFile").load("${Models.collection(folder)}")

    private fun Row.string(name: String): String? = getAs(name)

    /** The rows by the file's name. */
    private fun Dataset<Row>.byName(): Map<String, Row> =
        collectAsList().associateBy { it.string("name")!!.substringAfterLast('/') }

    /** What one JVM renders, without Spark. */
    private fun expected(bytes: ByteArray, format: SceneFormat, up: UpAxis): Image {
        val loaded = Scenes.load(bytes, format)
        val scene = loaded.scene.withViewpoint(Camera.fit()).withUpAxis(up)
        return ZBufferRenderer().render(scene.frame(loaded.raster(64, 48)))
    }

    private val plain = "size=64x48 aa=1 light-intensity=1"

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun picturesAreThoseOfOneJvm(@TempDir folder: Path) {
        val rows = ModelPictures.render(files(folder), "$plain output=png+pixels+depth").byName()
        val teapot = expected(Models.stl(), SceneFormat.STL, UpAxis.Z)
        val row = rows.getValue("teapot.stl")
        assertEquals(teapot.pixelHash(), row.string("hash"))
        assertArrayEquals(teapot.toPng(), row.getAs<ByteArray>("png"))
        assertArrayEquals(teapot.argb, row.ints("pixels"))
        assertArrayEquals(teapot.depth, row.ints("depth"))
        val counters = row.getAs<Row>("counters")
        assertEquals(teapot.counters.primitives, counters.getAs("primitives"))
        assertTrue(counters.getAs<Long>("shadingCalls") >= teapot.visible)
        val tetrahedron = expected(Models.OBJ.toByteArray(), SceneFormat.OBJ, UpAxis.Y)
        assertEquals(tetrahedron.pixelHash(), rows.getValue("tetrahedron.obj").string("hash"))
    }

    private fun Row.ints(name: String) = IntArray(64 * 48).also {
        ByteBuffer.wrap(getAs<ByteArray>(name)).asIntBuffer().get(it)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun badModelsAreRowsWithTheirErrors(@TempDir folder: Path) {
        val rows = ModelPictures.render(files(folder), plain).byName()
        assertEquals(5, rows.size)
        for ((name, words) in listOf(
            "cut.stl" to "ends within facet", "missing.obj" to "no vertex",
            "words.ply" to "ply"
        )) {
            val row = rows.getValue(name)
            assertTrue(words in row.string("error")!!, row.string("error"))
            assertNull(row.string("hash"), name)
            assertNull(row.getAs<ByteArray>("png"), name)
        }
        assertNull(rows.getValue("teapot.stl").string("error"))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun limitsApply(@TempDir folder: Path) {
        val limits = LoadLimits(triangles = 100)
        val rows = ModelPictures.render(files(folder), plain, limits).byName()
        assertTrue("triangles" in rows.getValue("teapot.stl").string("error")!!)
        assertNotNull(rows.getValue("tetrahedron.obj").string("hash"))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun manyViewsSurviveParquet(@TempDir folder: Path) {
        files(folder).createOrReplaceTempView("models")
        spark.sql("SELECT explode(array('view=front', 'view=top')) AS view").createOrReplaceTempView("views")
        val joined = spark.sql("SELECT path, content, '$plain ' || view AS options FROM models CROSS JOIN views")
        val written = folder.resolve("pictures.parquet")
        ModelPictures.render(joined).write().parquet("$written")
        val read = spark.read().parquet("$written")
        assertEquals(10, read.count())
        assertEquals(4, read.filter(col("error").isNull).count())
        assertEquals(4, read.select("hash").filter(col("hash").isNotNull).distinct().count())
    }

    @Test
    fun sqlHasAFunction(@TempDir folder: Path) {
        ModelPictures.register(spark)
        files(folder).createOrReplaceTempView("models")
        val rows = spark.sql(
            "SELECT path, p.hash, p.error FROM (SELECT path, lazyz_render(content, path, '$plain') AS p FROM models)",
        ).collectAsList().associate { it.getString(0).substringAfterLast('/') to it }
        assertEquals(expected(Models.stl(), SceneFormat.STL, UpAxis.Z).pixelHash(), rows["teapot.stl"]!!.string("hash"))
        assertNotNull(rows["cut.stl"]!!.string("error"))
        val nothing = spark.sql("SELECT lazyz_render(NULL, 'x.stl', '').error").first().getString(0)
        assertTrue("no bytes" in nothing, nothing)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun mistakesInOptionsAreReportedByTheDriver(@TempDir folder: Path) {
        val files = files(folder)
        for ((words, part) in listOf("size=0" to "width", "colour=red" to "'colour=red'", "aa=3" to "1, 2, 4, 8")) {
            val error = assertThrows(IllegalArgumentException::class.java) { ModelPictures.render(files, words) }
            assertTrue(part in error.message!!, error.message)
        }
        assertThrows(IllegalArgumentException::class.java) { ModelPictures.render(files.select("path")) }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun sheetsShowAllModelsInOrder(@TempDir folder: Path) {
        val sheets = ModelPictures.sheets(files(folder), plain, columns = 2, rows = 2).sort("sheet").collectAsList()
        assertEquals(listOf(0L, 1L), sheets.map { it.getAs<Long>("sheet") })
        val names = sheets.flatMap { it.getList<String>(2) }.map { it.substringAfterLast('/') }
        assertEquals(listOf("cut.stl", "missing.obj", "teapot.stl", "tetrahedron.obj", "words.ply"), names)
        val first = Picture.decode(sheets[0].getAs<ByteArray>("png"))
        assertEquals(6 + 2 * 70, first.width)
        val teapot = expected(Models.stl(), SceneFormat.STL, UpAxis.Z)

        // The first cell of the second row
        val cell = (0 until 48).flatMap { y -> (0 until 64).map { x -> first.color(6 + x, 6 + 48 + 15 + 6 + y) } }
        val same = Picture.of(teapot)
        assertEquals((0 until 48).flatMap { y -> (0 until 64).map { x -> same.color(x, y) } }, cell)
    }
}
