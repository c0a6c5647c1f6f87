package dev.lazyz.scenes.formats

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.ReferencePolicy
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.threemf.ThreeMfFiles
import dev.lazyz.shared.PictureWords
import dev.lazyz.world.surface.Mesh
import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import org.junit.jupiter.api.AfterEach
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

class ModelArchiveTest {
    @TempDir
    lateinit var spool: Path

    private val triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
    private val picture = PictureWords.picture()

    /** Whatever happens, nothing is left. */
    @AfterEach
    fun nothingIsLeft() = assertEquals(emptyList<Path>(), spool.listDirectoryEntries())

    private fun open(zip: ByteArray, limits: LoadLimits = LoadLimits()) = ModelArchive.open(zip, "a.zip", limits, spool)

    private fun obj(text: String = "f 1 2 3\n") = (triangle + text).toByteArray()

    private fun refused(zip: ByteArray, message: String, model: String? = null, limits: LoadLimits = LoadLimits()) {
        val refused = assertThrows(SceneFormatException::class.java, {
            open(zip, limits).use { it.load(model) }
        }, message)
        assertFalse("binary STL" in refused.message.orEmpty(), refused.message)
        assertTrue(message in refused.message.orEmpty(), refused.message)
        assertFalse("$spool" in refused.message.orEmpty(), refused.message)
        assertFalse(refused is SceneReadException, refused.message)
    }

    @Test
    fun whatAModelRefersToIsInTheArchive() {
        val text = "mtllib ../looks/LOOK.mtl\nusemtl look\nf 1/1 2/2 3/3\n"
        val zip = RawZip().add("part/a.obj", obj(text), isPacked = true).add("looks/", mode = 0x4000)
            .add("looks\\look.MTL", "newmtl look\nmap_Kd picture.png\n".toByteArray())
            .add("./looks/picture.png", picture).add("__MACOSX/part/._a.obj", ByteArray(3)).add(".b.obj", ByteArray(3))
        assertTrue(ModelArchive.isOne(zip.bytes()))
        val loaded = open(zip.bytes()).use { it.load() }
        assertEquals(emptyList<String>(), loaded.warnings)
        assertEquals(SceneFormat.OBJ, loaded.format)
        assertNotNull((loaded.scene.surfaces.single() as Mesh).material.textureMap)

        // What is missing is named as in the archive
        val missing = RawZip().add("part/a.obj", obj("mtllib ../../b.mtl\nmtllib no.mtl\nusemtl b\nf 1 2 3\n"))
        val warnings = open(missing.bytes()).use { it.load() }.warnings
        assertTrue(warnings.none { "$spool" in it } && warnings.any { "no.mtl" in it && "part" in it }, "$warnings")
    }

    @Test
    fun referencesDoNotLeadOut() {
        Files.createDirectories(spool.resolve("lazyz-outside"))
        Files.writeString(spool.resolve("lazyz-outside/b.mtl"), "newmtl b\nKd 1 0 0\n")
        try {
            val zip = RawZip().add("a.obj", obj("mtllib ../lazyz-outside/b.mtl\nusemtl b\nf 1 2 3\n")).bytes()
            val options = LoadOptions(LoadLimits(references = ReferencePolicy.ANYWHERE))
            val loaded = open(zip).use { it.load(options = options) }
            assertTrue(loaded.warnings.any { "lies outside the archive" in it }, "${loaded.warnings}")
            val scene = """{"asset": {"version": "2.0"},
                "buffers": [{"byteLength": 12, "uri": "../lazyz-outside/b.mtl"}],
                "accessors": [{"bufferView": 0, "componentType": 5126, "count": 1, "type": "VEC3"}],
                "bufferViews": [{"buffer": 0, "byteLength": 12}], "meshes": [{"primitives": [{"attributes":
                {"POSITION": 0}}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0}"""
            val gltf = RawZip().add("a.gltf", scene.toByteArray()).bytes()
            refused(gltf, "b.mtl lies outside the archive; put it into the archive")
        } finally {
            spool.resolve("lazyz-outside").toFile().deleteRecursively()
        }
    }

    @Test
    fun oneModelIsChosen() {
        val two = RawZip().add("a.obj", obj()).add("B.stl", obj()).add("notes.txt", obj()).add("c.json", obj()).bytes()
        refused(two, "a.zip: it has 2 models, a.obj, B.stl; choose one")
        refused(two, "there is no file 'd.obj' in it; it has a.obj, B.stl, notes.txt, c.json", "d.obj")
        refused(two, "there is no file '../a.obj'", "../a.obj")
        assertEquals(SceneFormat.OBJ, open(two).use { it.load("A.obj") }.format)
        assertEquals(SceneFormat.OBJ, open(two).use { it.load("notes.txt", SceneFormat.OBJ) }.format)
        refused(RawZip().add("a.png", picture).bytes(), "no file in it is a model by its name; it has a.png")
        refused(RawZip().add("a/", mode = 0x4000).bytes(), "no file in it is a model by its name; it has no files")
        refused(RawZip().add("in.zip", RawZip().add("a.obj", obj()).bytes()).bytes(), "no file in it is a model")
    }

    @Test
    fun namesThatMeanOtherPlacesAreRefused() {
        val names = listOf(
            "../a.obj", "b/../../a.obj", "/a.obj", "\\a.obj", "C:\\a.obj", "c:a.obj", "a.obj\u0000", "b//a.obj",
            "a\n.obj", "...", "b/./a.obj", "a.obj ", "n".repeat(251), "d/".repeat(20) + "a.obj", "a?.obj",
        )
        for (name in names) refused(RawZip().add(name, obj()).bytes(), "is no name of a file in an archive")
        for (second in listOf("a.obj", "A.OBJ", "./a.obj", "/a.obj")) {
            val zip = RawZip().add("a.obj", obj()).add(second, obj()).bytes()
            refused(zip, if (second == "/a.obj") "a.obj'" else "there are two files '")
        }
        refused(RawZip().add("a.obj", obj()).add("A.obj/b.txt").bytes(), "'a.obj' is a file and a folder")
        refused(RawZip().add("a.obj", "/etc/passwd".toByteArray(), mode = 0xA1FF).bytes(), "'a.obj' is a link")

        // Before there is a folder
        val secret = RawZip().add("a.obj", obj()).add("b.obj", obj(), flags = 1).bytes()
        val encrypted = assertThrows(SceneFormatException::class.java) {
            ModelArchive.open(secret, "a.zip", LoadLimits(), spool.resolve("none"))
        }
        assertTrue("b.obj: is encrypted" in encrypted.message.orEmpty(), encrypted.message)
    }

    @Test
    fun bombsAreRefused() {
        val few = LoadLimits(decodedBytes = 4L shl 20)
        val zeros = ByteArray(1 shl 23)
        refused(RawZip().add("a.obj", zeros, isPacked = true).bytes(), "decodedBytes", limits = few)

        // A thousand files that share the same bytes
        val shared = RawZip().add("a.obj", ByteArray(1 shl 16))
        for (i in 1 until 1000) shared.add("b$i", ByteArray(1 shl 16), place = 0)
        refused(shared.bytes(), "decodedBytes", limits = few)
        val room = LoadLimits(spoolBytes = 99_999)
        val advice = "temporary files of more than 99999 bytes; raise LoadLimits.spoolBytes (zcli: --max-spool)"
        refused(shared.bytes(), advice, limits = room)

        val many = RawZip()
        for (i in 1..100_000) many.add("$i")
        refused(many.bytes(), "it has 100000 files, at most 1000 are possible")
        refused(many.bytes(), "items", limits = LoadLimits(items = 5000))
        refused(RawZip().add("a.obj", obj()).bytes(claimed = Long.MAX_VALUE), "directory is damaged")
        refused(RawZip().add("a.obj", obj()).bytes(claimed = -1), "no file in it is a model")
        refused(RawZip().add("a.obj", obj(), place = -1).bytes(), "directory is damaged")
        refused(RawZip().add("a.obj", obj(), place = 1 shl 30).bytes(), "directory is damaged")
        refused(RawZip().add("a.obj", obj()).bytes().copyOf(60), "no ZIP archive, or is cut short")
        val damaged = RawZip().add("a.obj", zeros, isPacked = true).bytes().also { it[40] = 7 }
        refused(damaged, "a.zip, a.obj: is damaged: invalid")
        val other = RawZip().add("a.obj", obj()).bytes().also { it[37] = '7'.code.toByte() }
        refused(other, "a.zip, a.obj: is damaged: its checksum is another; pack it again")
        Thread.currentThread().interrupt()
        refused(RawZip().add("a.obj", zeros, isPacked = true).bytes(), "interrupted")
        assertTrue(Thread.interrupted())
    }

    /** Whatever is damaged, there is a scene or a message. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun damagedArchivesAreRefusedOrRead() {
        val text = obj("mtllib b.mtl\nusemtl b\nf 1/1 2/2 3/3\n")
        val looks = "newmtl b\nmap_Kd picture.png\n".toByteArray()
        val zip = RawZip().add("a.obj", text, isPacked = true).add("b.mtl", looks).add("picture.png", picture).bytes()
        val random = Random(1)
        var read = 0
        repeat(500) {
            val damaged = zip.clone()
            repeat(1 + random.nextInt(4)) { damaged[random.nextInt(damaged.size)] = random.nextInt().toByte() }
            try {
                open(damaged, LoadLimits(decodedBytes = 1L shl 20)).use { it.load() }
                read++
            } catch (refused: SceneFormatException) {
                assertFalse("$spool" in refused.message.orEmpty(), refused.message)
            }
        }
        assertTrue(read in 20..480, "$read")
        val long = RawZip().add("a/" + "\u6728".repeat(86), obj()).bytes()
        refused(long, "has more than 255 bytes, as UTF-8; shorten it")
    }

    @Test
    fun filesOfSettingsAreThoseOfTheArchive() {
        val settings = PictureSettings().withWord(PictureParameters.MATCAP, "Picture.png")
        val zip = RawZip().add("a.obj", obj()).add("picture.png", picture).bytes()
        fun read(bytes: ByteArray, asked: PictureSettings, model: String? = null, format: SceneFormat? = null) =
            ModelArchive.read(bytes, format, "model", model, asked, LoadLimits()) { loaded, found ->
                found[PictureParameters.MATCAP].also { file ->
                    val observer = PictureObserver()
                    found.frame(loaded, observer = observer)

                    // An observer reads it once
                    file?.deleteExisting()
                    found.frame(loaded, observer = observer)
                }
            }
        val file = read(zip, settings)!!
        assertEquals("picture.png", "${file.fileName}")
        assertFalse(file.parent.exists())
        val outside = settings.withWord(PictureParameters.MATCAP, "${spool.toAbsolutePath()}")
        val absent = assertThrows(SceneFormatException::class.java) { read(zip, outside) }
        assertTrue("there is no file '" in absent.message.orEmpty(), absent.message)
        assertTrue("in it; it has a.obj, picture.png" in absent.message.orEmpty(), absent.message)
        val broken = RawZip().add("a.obj", obj()).add("picture.png", obj()).bytes()
        val noPicture = assertThrows(SceneFormatException::class.java) { read(broken, settings) }
        assertTrue(noPicture.message.orEmpty().startsWith("picture.png: is not an image"), noPicture.message)
        val alone = assertThrows(SceneFormatException::class.java) { read(obj(), settings) }
        assertTrue("is no ZIP archive, so 'matcap' has no effect" in alone.message.orEmpty(), alone.message)
        val named = assertThrows(SceneFormatException::class.java) { read(obj(), PictureSettings(), "a.obj") }
        assertTrue("'model' has no effect" in named.message.orEmpty(), named.message)
        read(obj(), PictureSettings())
        read(zip, PictureSettings(), "a.obj", SceneFormat.OBJ)

        // A 3MF file in an archive is a model like others
        val mesh = "<object id=\"1\">${ThreeMfFiles.TRIANGLE}</object>"
        val part = ThreeMfFiles.of(ThreeMfFiles.model(mesh, "<item objectid=\"1\"/>"))
        val packed = RawZip().add("part.3mf", part).bytes()
        assertNull(read(packed, PictureSettings(), format = SceneFormat.THREE_MF))
        assertFalse(ModelArchive.isOne(RawZip().add("_rels/.rels").bytes()))
        assertFalse(ModelArchive.isOne(obj()))
        assertThrows(SceneFormatException::class.java) { read("?".toByteArray(), PictureSettings()) }
    }
}
