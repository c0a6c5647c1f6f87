package dev.lazyz.mcp

import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.NamedValues
import dev.lazyz.scenes.pictures.ParameterGroup
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureParameter
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.NoSuchFileException
import java.nio.file.Path

/**
 * What a tool can be asked: its own arguments, and parameters of pictures.
 *
 * @param isBrief whether another tool says what the parameters do: a client keeps the schemas of all
 */
internal class ToolInput(
    private val own: List<Argument>,
    private val parameters: List<PictureParameter<*>>,
    private val isBrief: Boolean = false,
) {
    /** An argument of a tool that is no parameter of pictures. It is required unless [isOptional]. */
    class Argument(val name: String, val type: String, val help: String, val isOptional: Boolean = false)

    /** The JSON Schema. */
    fun schema(): Map<String, Any> {
        val mine = own.associate { it.name to mapOf("type" to it.type, "description" to it.help) }
        return mapOf(
            "type" to "object",
            "properties" to mine + parameters.associate { it.name to schema(it) },
            "required" to own.filterNot { it.isOptional }.map { it.name },
            "additionalProperties" to false,
        )
    }

    private fun schema(parameter: PictureParameter<*>): Map<String, Any> {
        val values = parameter.values
        val text = values.form?.let { "$it. " }.orEmpty() + parameter.text("")
        val type = when {
            values.form == null -> "boolean"
            values.isNumber -> "number"
            else -> "string"
        }
        val one = if (values is NamedValues && !values.isNumber) {
            mapOf("type" to type, "enum" to values.words)
        } else {
            mapOf("type" to type)
        }
        val all = if (parameter === PictureParameters.CUT) mapOf("type" to "array", "items" to one) else one
        return if (isBrief) all else all + ("description" to text)
    }

    /** Reads the arguments of a call. Throws a [Refusal], or an [IllegalArgumentException], if they are wrong. */
    fun read(arguments: Map<String, Any?>?): Call {
        val given = arguments.orEmpty().mapValues { (name, value) -> words(name, value) }
        val known = own.map { it.name } + parameters.map { it.name }
        given.keys.firstOrNull { it !in known }?.let { name ->
            refuse("there is no parameter '${name.take(LONGEST)}'; there are ${known.joinToString()}")
        }
        for (argument in own) {
            val isMissing = given[argument.name].isNullOrEmpty()
            if (isMissing && !argument.isOptional) refuse("${argument.name} is missing: ${argument.help}")
        }
        val (mine, others) = given.entries.partition { entry -> own.any { it.name == entry.key } }
        val pairs = others.flatMap { (name, values) -> values.map { name to it } }
        val settings = PictureDoor.COMMAND_LINE.read(PictureSettings(), pairs).apply { check() }
        return Call(mine.associate { it.key to it.value.joinToString(",") }, settings)
    }

    private fun words(name: String, value: Any?): List<String> = when (value) {
        null -> emptyList()
        is Boolean, is Number -> listOf("$value")
        is String -> listOf(value)
        is List<*> -> value.flatMap { if (it is List<*>) refuse("$name: a list has no lists") else words(name, it) }
        else -> refuse("$name: the value must be a text, a number, true or false")
    }.onEach { if (it.length > LONGEST) refuse("$name: a value has at most $LONGEST characters") }

    /** The arguments of a call: a tool's [own], as text, and what they say about the picture. */
    class Call(val own: Map<String, String>, val settings: PictureSettings) {
        operator fun get(name: String): String = own.getValue(name)

        /** Returns the pixel column or row called [name]. */
        fun number(name: String): Int =
            this[name].toIntOrNull() ?: refuse("$name: '${this[name]}' is no whole number")
    }

    companion object {
        private const val LONGEST = 1000
        private val views = PictureOutput.Word.VIEWS

        private fun file(name: String, what: String) = Argument(name, "string", "Path of the $what, in the folder")

        val RENDER = ToolInput(
            listOf(
                file("file", "model"),
                Argument(views.id, "string", "${views.form}. ${views.help}", isOptional = true),
                Argument("drawing", "boolean", "Lines as SVG in place of pixels; needs edges", isOptional = true),
            ),
            PictureParameters.all,
        )
        val COMPARE = ToolInput(
            listOf(file("old", "old model"), file("new", "new model")),
            PictureParameters.all - ParameterGroup.PAPER.parameters.toSet(),
            isBrief = true,
        )
        val MEASURE = ToolInput(listOf(file("file", "model")), ParameterGroup.READING.parameters)
        val PICK = ToolInput(
            listOf(
                file("file", "model"),
                Argument("x", "integer", "Column of the pixel, from 0 at the left"),
                Argument("y", "integer", "Row of the pixel, from 0 at the top"),
            ),
            COMPARE.parameters,
            isBrief = true,
        )
    }
}

/** The files in [folder], each of at most [mostBytes]. */
internal class ModelFolder(folder: Path, private val mostBytes: Long) {
    private val root: Path = folder.toRealPath()

    /** Returns the path of the file [name], absolute or relative to the folder, links resolved. */
    fun file(name: String): Path = try {
        val path = root.resolve(name).normalize()
        if (!path.startsWith(root)) outside(name)
        val real = path.toRealPath()
        if (!real.startsWith(root)) outside(name)
        if (!Files.isRegularFile(real)) refuse("'$name' is no file")
        if (Files.size(real) > mostBytes) refuse("'$name' has more than $mostBytes bytes, the limit of this server")
        real
    } catch (_: InvalidPathException) {
        refuse("'$name' is no name of a file")
    } catch (_: NoSuchFileException) {
        refuse("there is no file '$name' in the folder")
    } catch (_: IOException) {
        refuse("'$name' cannot be read")
    }

    /** Returns [settings] with the paths of the files that they name. */
    fun files(settings: PictureSettings): PictureSettings =
        settings.files.entries.fold(settings) { all, (parameter, file) -> all.with(parameter, file("$file")) }

    /** Returns [text] with names relative to the folder. */
    fun plain(text: String): String = text.replace("$root${root.fileSystem.separator}", "")

    private fun outside(name: String): Nothing = refuse("'$name' is outside of the folder of this server")
}
