package dev.lazyz.testing

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.pictures.PictureDifference
import dev.lazyz.scenes.writers.toPng
import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.streams.asSequence
import org.opentest4j.AssertionFailedError
import org.opentest4j.FileInfo

/** The golden files of a project: compares pictures with them, or writes them. Thread safe. */
internal class Goldens(private val settings: GoldenSettings) {
    /**
     * Compares [actual] with the file [golden], as [PictureAssertion.matches] describes it.
     *
     * @param threshold the greatest difference of a channel that is accepted, 0..255
     */
    fun check(golden: String, actual: ActualPicture, threshold: Double) {
        val file = settings.root.resolve(golden).normalize()
        val test = CallingTest.name()
        val report = TestReport(settings, test)
        report.begin()
        if (settings.isUpdate && updates(file, actual, threshold)) return
        val expected = if (Files.exists(file)) read(file) else null
        val difference = expected?.let { difference(file, it, actual, threshold) }
        if (difference?.isMatch == true) return

        // Write what helps to understand it
        val problem = when {
            difference != null -> "the picture differs from the golden file\n${difference.summary}"
            expected != null -> "the golden file is no image that can be decoded"
            else -> "there is no golden file"
        }
        val failure = GoldenFailure(golden, problem, expected, actual, difference?.let(::marked))
        val files = report.add(failure)
        val message = message(file, problem, files, test)
        settings.workspace?.let { settings.print(Annotation.of(it, file, message)) }
        throw AssertionFailedError(
            message,
            FileInfo("$file", expected ?: ByteArray(0)),
            FileInfo("${files.actual}", actual.png),
        )
    }

    private fun read(file: Path): ByteArray = try {
        Files.readAllBytes(file)
    } catch (failure: IOException) {
        throw UncheckedIOException("cannot read $file: ${failure.message}", failure)
    }

    /** Returns the difference from the file, or null if it cannot be decoded. */
    private fun difference(file: Path, bytes: ByteArray, actual: ActualPicture, threshold: Double) = try {
        PictureDifference.between(Picture.decode(bytes, "$file"), actual.picture, threshold)
    } catch (_: SceneFormatException) {
        null
    }

    /** Returns a picture of the [difference] as PNG, or null if it has too many pixels. */
    private fun marked(difference: PictureDifference): ByteArray? = try {
        difference.toImage().toPng()
    } catch (_: IllegalArgumentException) {
        null
    }

    private fun message(file: Path, problem: String, files: TestReport.Written, test: String): String = buildString {
        appendLine(problem)
        appendLine("  expected    $file")
        appendLine("  actual      ${files.actual}")
        if (files.difference != null) appendLine("  difference  ${files.difference}")
        appendLine("  side by side in ${files.page}")
        append("If the actual picture is right, make it the golden file: ${settings.updateCommand(test)}")
    }

    /**
     * Writes [file] unless it matches. Returns false if this process has already accepted or written it, for another
     * picture: both must be the same, so the file is compared as usual.
     */
    private fun updates(file: Path, actual: ActualPicture, threshold: Double): Boolean = synchronized(accepted) {
        if (!accepted.add(file)) return false
        val isThere = Files.exists(file)
        val matches = isThere && difference(file, read(file), actual, threshold)?.isMatch == true
        if (!matches) {
            WholeFile.write(file, actual.png)
            val size = "${actual.picture.width}x${actual.picture.height}"
            settings.print("lazyz: ${if (isThere) "replaced" else "wrote"} golden file $file, $size")
        }
        return true
    }

    companion object {
        /** The golden files that this process has written, or left as they are, in update mode. */
        private val accepted = HashSet<Path>()

        /** Returns the golden files of the project whose tests run in this process. */
        fun current(): Goldens = Goldens(GoldenSettings.current())
    }
}

/** Messages that a GitHub workflow shows beside a file: "Workflow commands" in the documentation of GitHub Actions. */
internal object Annotation {
    /**
     * Returns the line that shows [message] as an error of [file].
     *
     * @param workspace the root of the repository; paths below it are relative
     */
    fun of(workspace: Path, file: Path, message: String): String {
        val path = if (file.startsWith(workspace)) workspace.relativize(file) else file
        return "::error file=${property(path.invariantSeparatorsPathString)},title=Golden picture::${data(message)}"
    }

    private fun data(text: String): String = text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")

    private fun property(text: String): String = data(text).replace(":", "%3A").replace(",", "%2C")
}

/** Finds the class of the test that runs on this thread. */
internal object CallingTest {
    private val libraries = listOf("java.", "jdk.", "kotlin.", "kotlinx.")
    private val frameworks = listOf("org.junit.", "net.jqwik.engine.", "org.testng.", "io.kotest.")

    /**
     * Returns the full name of the class: the outermost on the stack that a test framework has called, so that it is
     * the test's and not that of a helper, without the names of nested classes. Returns `unknown` if there is none.
     */
    fun name(): String = name(StackWalker.getInstance().walk { it.asSequence().map { it.className }.toList() })

    /** As above, for the names of the classes on a stack, innermost first. */
    fun name(stack: List<String>): String {
        val callers = stack.takeWhile { name -> frameworks.none { name.startsWith(it) } }
        val called = callers.lastOrNull { name -> libraries.none { name.startsWith(it) } }
        return called?.substringBefore('$') ?: "unknown"
    }
}

/** Writes files so that nobody reads half of one. */
internal object WholeFile {
    /**
     * Writes [bytes] to [file], in place of what was there, and creates its folders.
     *
     * @throws UncheckedIOException if that is not possible
     */
    fun write(file: Path, bytes: ByteArray) {
        try {
            Files.createDirectories(file.parent)
            val temporary = Files.createTempFile(file.parent, ".${file.fileName}", ".tmp")
            try {
                // A temporary file is only for its owner; this one is for all, as usual
                Files.delete(temporary)
                Files.write(temporary, bytes)
                Files.move(temporary, file, REPLACE_EXISTING)
            } finally {
                Files.deleteIfExists(temporary)
            }
        } catch (failure: IOException) {
            throw UncheckedIOException("cannot write $file: ${failure.message}", failure)
        }
    }
}

/**
 * The picture that a test has made.
 *
 * @param encode returns the bytes of a PNG file with the same pixels
 */
internal class ActualPicture(val picture: Picture, encode: () -> ByteArray) {
    /** The picture as a PNG file. Encoded only if a file is written. */
    val png: ByteArray by lazy(encode)
}

/**
 * A picture that is not as it should be.
 *
 * @property golden the golden file, as the test names it
 * @property problem what is wrong, in some lines
 * @property expected bytes of the golden file, or null if there is none
 * @property difference the difference as a PNG file, or null if the pictures could not be compared
 */
internal class GoldenFailure(
    val golden: String,
    val problem: String,
    val expected: ByteArray?,
    val actual: ActualPicture,
    val difference: ByteArray?,
)
