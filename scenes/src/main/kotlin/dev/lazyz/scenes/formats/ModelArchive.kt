package dev.lazyz.scenes.formats

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.ReferencePolicy
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneReadException
import dev.lazyz.scenes.loading.FileReferences
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.streaming.SpoolSpace
import dev.lazyz.scenes.zip.ZipArchive
import java.io.Closeable
import java.io.IOException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * A ZIP archive with a model and the files that it refers to, such as material libraries, textures and buffers: for
 * models that come as bytes. Its files are in a temporary folder until it is closed.
 *
 * ```
 * val loaded = ModelArchive.open(bytes).use { it.load() }
 * ```
 *
 * It is made for archives from strangers. References do not lead out of the archive. What cannot be meant well is
 * refused before anything is written: names with `..`, of other places, or that differ only in case; links; encrypted
 * files; more than [MOST_FILES] files. All bytes that are unpacked count as decoded data, whatever the archive says
 * about their number, and as temporary files; their checksums are checked. Archives in it are not unpacked. Not thread
 * safe.
 *
 * @property folder the folder with the files
 */
public class ModelArchive private constructor(
    public val folder: Path,
    private val name: String,
    private val files: List<String>,
) : Closeable {
    /**
     * Reads the model called [model] or, if that is null, the only one: a file with the extension of a model.
     *
     * @param format its format, or null if its name or content decides
     * @param options how to read it; references lead to files of the archive, whatever [LoadLimits.references] says
     * @throws SceneFormatException if there is no such model, there are several, or it is wrong
     */
    @JvmOverloads
    @Throws(SceneFormatException::class)
    public fun load(
        model: String? = null,
        format: SceneFormat? = null,
        options: LoadOptions = LoadOptions(),
    ): LoadedScene {
        val path = if (model == null) file(only()) else file(model)
        val own = options.withLimits(options.limits.withReferences(ReferencePolicy.WITHIN_FOLDER))
        val loaded = try {
            SceneReading.read(path, format ?: SceneFormat.ofFileName(path.toString()), Loading(own), folder)
        } catch (failure: SceneFormatException) {
            throw named(failure)
        }
        return loaded.withWarnings(loaded.warnings.map(::named))
    }

    /**
     * Returns the path of the file called [file], whose case does not matter; it lies in [folder].
     *
     * @throws SceneFormatException if there is none
     */
    @Throws(SceneFormatException::class)
    public fun file(file: String): Path {
        val wanted = plain(file)
        val found = files.firstOrNull { it == wanted } ?: files.firstOrNull { it.equals(wanted, ignoreCase = true) }
        return folder.resolve(found ?: refuse(name, "there is no file '$file' in it", "it has ${listed(files)}"))
    }

    /**
     * Returns [failure] with the names of the archive in place of those of temporary files. If these cannot be read, it
     * stays as it is, for those who run the program.
     */
    private fun named(failure: SceneFormatException): SceneFormatException {
        if (failure is SceneReadException) return failure
        val remedy = if (failure.remedy == FileReferences.REMEDY) "put it into the archive" else failure.remedy
        return SceneFormatException(
            named(failure.source), failure.location?.let(::named), named(failure.problem), remedy?.let(::named),
            failure,
        )
    }

    private fun named(text: String): String = text.replace("$folder${folder.fileSystem.separator}", "")
        .replace("$folder", "the archive")

    /** Returns the name of the only model. Programs add files of their own, whose names begin with a dot. */
    private fun only(): String {
        val models = files.filter { file ->
            val format = SceneFormat.ofFileName(file)
            format != null && format != SceneFormat.SCENE && file.split('/').none { it.startsWith('.') || it == MAC }
        }
        if (models.isEmpty()) refuse(name, "no file in it is a model by its name", "it has ${listed(files)}")
        return models.singleOrNull() ?: refuse(name, "it has ${models.size} models, ${listed(models)}", "choose one")
    }

    private fun listed(files: List<String>) =
        files.take(LISTED).joinToString().ifEmpty { "no files" } + if (files.size > LISTED) ", ..." else ""

    /** Deletes the temporary files. Closing again does nothing. */
    override fun close() {
        folder.toFile().deleteRecursively()
    }

    override fun toString(): String = "ModelArchive($name, ${files.size} files)"

    public companion object {
        /** Most files of an archive. */
        public const val MOST_FILES: Int = 1000

        /** Most characters of a path, most bytes of a name in it, as disks have them, and most folders in folders. */
        private const val LONGEST = 250
        private const val LONGEST_NAME = 255
        private const val DEEPEST = 16

        /** Files that a message names. */
        private const val LISTED = 5

        /** The folder in which macOS puts copies of attributes. */
        private const val MAC = "__MACOSX"

        /**
         * Returns whether [bytes] look like an archive with a model. A 3MF file, which is a ZIP archive as well, is a
         * model itself.
         */
        @JvmStatic
        @JvmOverloads
        public fun isOne(bytes: ByteArray, limits: LoadLimits = LoadLimits()): Boolean = isZip(bytes) && try {
            ZipArchive(Source(bytes, "", null, Loading(LoadOptions(limits)))).names.none {
                it.equals("_rels/.rels", ignoreCase = true) || it.endsWith(".model", ignoreCase = true)
            }
        } catch (_: SceneFormatException) {
            false
        }

        /** Returns whether a file whose first bytes are [start] can be a ZIP archive. */
        @JvmStatic
        public fun isZip(start: ByteArray): Boolean =
            start.size >= ZIP.length && ZIP.indices.all { start[it] == ZIP[it].code.toByte() }

        /**
         * Reads the model in [bytes], which are its file, or a ZIP archive with it and what it refers to, and returns
         * what [use] makes of it and of [settings]. The files of the settings are names in the archive; none else can
         * be read. This is how services and Spark read what strangers send.
         *
         * @param format the format of the model, or null if its name or content decides
         * @param name the name of the bytes in messages
         * @param model the name of the model in an archive, or null for the only one
         * @throws SceneFormatException if there is no such model or file, or it is wrong
         */
        @JvmStatic
        @Throws(SceneFormatException::class)
        public fun <T> read(
            bytes: ByteArray,
            format: SceneFormat?,
            name: String,
            model: String?,
            settings: PictureSettings,
            limits: LoadLimits,
            use: (LoadedScene, PictureSettings) -> T,
        ): T {
            if (!isOne(bytes, limits)) {
                val lonely = model?.let { "model" } ?: settings.files.keys.firstOrNull()
                if (lonely != null) {
                    refuse(name, "is no ZIP archive, so '$lonely' has no effect", "send one, or omit it")
                }
                val known = format ?: SceneFormat.ofFileName(name) ?: Scenes.formatOf(bytes)
                    ?: refuse(name, "is of no known format", "name its format, such as format=stl")
                return use(Scenes.load(bytes, known, name, settings.loadOptions(limits)), settings)
            }
            return open(bytes, name, limits).use { archive ->
                val loaded = archive.load(model, format, settings.loadOptions(limits))
                val found = settings.files.entries.fold(settings) { all, (parameter, file) ->
                    all.with(parameter, archive.file("$file"))
                }
                try {
                    use(loaded, found)
                } catch (failure: SceneFormatException) {
                    throw archive.named(failure)
                }
            }
        }

        private const val ZIP = "PK\u0003\u0004"

        /**
         * Unpacks the archive in [bytes].
         *
         * @param name name of the archive in messages
         * @param limits limits on what it can request: items, decoded bytes, temporary files, time
         * @param spool where the temporary folder is made
         * @throws SceneFormatException if it is no archive, is damaged, exceeds a limit or is refused; a
         *   [SceneReadException] if temporary files cannot be written
         */
        @JvmStatic
        @JvmOverloads
        @Throws(SceneFormatException::class)
        public fun open(
            bytes: ByteArray,
            name: String = "<bytes>",
            limits: LoadLimits = LoadLimits(),
            spool: Path = Path.of(System.getProperty("java.io.tmpdir")),
        ): ModelArchive {
            val archive = ZipArchive(Source(bytes, name, null, Loading(LoadOptions(limits))))
            val entries = archive.names.filter { !it.endsWith('/') && !it.endsWith('\\') }
            val files = checked(archive, entries, name)
            val folder = try {
                Files.createTempDirectory(spool, "lazyz-")
            } catch (failure: IOException) {
                throw SceneReadException(name, "there is no folder for its files: ${failure.message}", cause = failure)
            }
            val space = SpoolSpace(spool, name, limits.spoolBytes, instead = "")
            try {
                for ((entry, file) in entries.zip(files)) unpack(archive, entry, folder.resolve(file), space)
            } catch (failure: Throwable) {
                folder.toFile().deleteRecursively()
                if (failure !is IOException || failure is SceneFormatException) throw failure
                val reason = (failure as? FileSystemException)?.reason ?: failure.message
                throw SceneReadException(name, "its files cannot be written: $reason", cause = failure)
            }
            return ModelArchive(folder, name, files)
        }

        private fun unpack(archive: ZipArchive, entry: String, file: Path, space: SpoolSpace) {
            Files.createDirectories(file.parent)
            archive.open(entry, isStrict = true)?.use { input ->
                space.counting(Files.newOutputStream(file)).use { input.transferTo(it) }
            }
        }

        /** Returns the paths of [entries], none of which leads out of the archive or to the place of another. */
        private fun checked(archive: ZipArchive, entries: List<String>, name: String): List<String> {
            val count = entries.size
            if (count > MOST_FILES) refuse(name, "it has $count files, at most $MOST_FILES are possible")
            archive.repeated?.let { refuse(name, "there are two files '$it'") }
            val folders = HashSet<String>()
            val all = HashSet<String>()
            val files = entries.map { entry ->
                if (archive.isLink(entry)) refuse(name, "'$entry' is a link")
                archive.requirePlain(entry)
                val file = plain(entry)
                val parts = file.split('/')
                if (parts.any { it.toByteArray().size > LONGEST_NAME }) {
                    refuse(name, "a name in '$entry' has more than $LONGEST_NAME bytes, as UTF-8", "shorten it")
                }
                if (isElsewhere(file, parts)) refuse(name, "'$entry' is no name of a file in an archive")
                if (!all.add(file.lowercase())) refuse(name, "there are two files '$file'")
                (1 until parts.size).mapTo(folders) { parts.take(it).joinToString("/").lowercase() }
                file
            }
            all.firstOrNull { it in folders }?.let { refuse(name, "'$it' is a file and a folder") }
            return files
        }

        private fun isElsewhere(file: String, parts: List<String>): Boolean {
            // Besides `.` and `..`, what ends like them is another name on some systems
            val isOdd = parts.any { it.isBlank() || it.endsWith('.') || it.endsWith(' ') }
            if (isOdd || parts.size > DEEPEST || file.length > LONGEST) return true
            if (file.any { it.isISOControl() || it in ":*?\"<>|" }) return true
            return try {
                Path.of(file).isAbsolute
            } catch (_: InvalidPathException) {
                true
            }
        }

        private fun plain(name: String): String = name.replace('\\', '/').removePrefix("./")

        private fun refuse(name: String, problem: String, remedy: String = "pack it again"): Nothing =
            throw SceneFormatException(name, null, problem, remedy)
    }
}
