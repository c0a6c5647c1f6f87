package dev.lazyz.scenes.pictures

import dev.lazyz.Rgba
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.shared.PictureWords
import dev.lazyz.strategies.tiled.TiledRenderer
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PictureParametersTest {
    /** The tests of the doors try these words, so that none can lack a parameter of its own. */
    @Test
    fun wordsOfEachParameterAreTried() {
        assertEquals(PictureParameters.all.map { it.name }, PictureWords.all.keys.toList())
        for (parameter in PictureParameters.all) {
            val words = PictureWords.all.getValue(parameter.name)
            words.dropLast(1).forEach { parameter.values.read(it) }
            assertThrows(IllegalArgumentException::class.java, { parameter.values.read(words.last()) }, parameter.name)
        }
    }

    /** What settings choose can be written as options, and these choose the same. */
    @Test
    fun optionsOfSettingsAreReadBack() {
        fun read(options: List<String>) = options.fold(PictureSettings()) { all, option ->
            val parameter = PictureParameters.all.single { option.substringBefore('=') == "--${it.name}" }
            all.withWord(parameter, if ('=' in option) option.substringAfter('=') else "true")
        }
        for (parameter in PictureParameters.all) {
            for (word in PictureWords.all.getValue(parameter.name).dropLast(1)) {
                val settings = PictureSettings().withWord(parameter, word)
                val again = read(settings.options)
                assertEquals("${settings[parameter]}", "${again[parameter]}", "${settings.options}")
                assertEquals(settings.options, again.options)
            }
        }
        assertEquals(listOf("--cut=x=1", "--cut=-z=10%"), read(listOf("--cut=x=1", "--cut=-z=10%")).options)
        assertEquals(emptyList<String>(), PictureSettings().withWord(PictureParameters.EDGES, "false").options)
    }

    /** Pictures of one observer that differ in the camera alone have the pixels of pictures of their own. */
    @Test
    fun anObserverKeepsWhatPicturesHaveInCommon() {
        val model = LoadedScene(Scenes.teapot(2), emptyList())
        val cut = PictureSettings(40, 30).withWord(PictureParameters.CUT, "x=40%")
            .with(PictureParameters.EDGES, true)
        val observer = PictureObserver()
        val colored = cut.with(PictureParameters.COLOR, Rgba.BLACK)
        for (settings in listOf(cut, cut.with(PictureParameters.AZIMUTH, 80.0), cut.with(PictureParameters.AA, 1))) {
            val frame = settings.frame(model, observer = observer)
            assertEquals(settings.frame(model).render(TiledRenderer()), frame.render(TiledRenderer()), "$settings")
        }
        val kept = colored.frame(model, observer = observer).render(TiledRenderer())
        assertEquals(colored.frame(model).render(TiledRenderer()), kept)
    }

    @Test
    fun aDoorWithoutAParameterHasAReason() {
        assertTrue(PictureParameters.all.flatMap { it.missing.values }.all { " " in it })
        assertEquals(PictureParameters.all, PictureDoor.COMMAND_LINE.parameters)
    }

    @Test
    fun valuesOfProgramsAreCheckedToo() {
        val usual = PictureSettings(40, 30)
        val zoom = assertThrows(IllegalArgumentException::class.java) { usual.with(PictureParameters.ZOOM, 0.0) }
        assertEquals("zoom must be in 0.001..1000: 0.0", zoom.message)
        assertThrows(IllegalArgumentException::class.java) { usual.with(PictureParameters.AA, 3) }
        assertThrows(IllegalArgumentException::class.java) { usual.withDefault(PictureParameters.COLOR, Rgba.WHITE) }
    }

    /** `docs/parameters.md` has a row for each parameter; `-Dlazyz.update=true` writes them. */
    @Test
    fun thePageShowsTheTable() {
        val page = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
            .map { it.resolve("docs/parameters.md") }.first { Files.exists(it) }
        val text = page.readText()
        val table = PictureParameters.all.groupBy { it.group }.map { (group, rows) ->
            "## ${group.title}\n\n" +
                "| parameter | what it does | service | Spark | scene file |\n|---|---|---|---|---|\n" +
                rows.joinToString("") { row(it) }
        }.joinToString("\n")
        val expected = text.substringBefore("## ${ParameterGroup.READING.title}\n") + table
        if (System.getProperty("lazyz.update") == "true") page.writeText(expected)
        assertEquals(expected, page.readText(), "write it with -Dlazyz.update=true")
    }

    private fun row(parameter: PictureParameter<*>): String {
        val term = listOfNotNull(parameter.name, parameter.values.form).joinToString(" ")
        val doors = (PictureDoor.entries - PictureDoor.COMMAND_LINE).joinToString(" | ") {
            parameter.missing[it] ?: "✓"
        }
        return "| `--$term` | ${parameter.text().replace("INPUT", "the input")} | $doors |\n"
    }
}
