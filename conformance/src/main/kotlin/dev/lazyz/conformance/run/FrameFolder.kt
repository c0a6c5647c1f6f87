package dev.lazyz.conformance.run

import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.results.reason
import dev.lazyz.conformance.rules.UseRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import java.io.IOException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/**
 * The user's folder of frames: scene files and meshes, each of which becomes a frame. The suite adds frames on which
 * rules have failed, and later runs of `Conformance` test them first.
 *
 * @throws FramesException if the folder or a file in it cannot be read
 */
internal class FrameFolder(private val folder: Path) {
    /**
     * A frame for each file with the extension of a scene format, ordered by name. Other files and folders are ignored.
     */
    val cases: List<FrameCase> by lazy {
        create()
        files(folder).map { case(it) }
    }

    private fun create() {
        try {
            Files.createDirectories(folder)
        } catch (e: IOException) {
            throw FramesException("the frames folder $folder cannot be created: ${reason(e)}", e)
        }
    }

    private fun case(path: Path): FrameCase = try {
        val loaded = Scenes.load(path)
        val size = loaded.size ?: USUAL_SIZE
        val raster = loaded.raster(size.width, size.height)
        val code = "Scenes.load(Path.of(\"${path.toString().replace("\\", "\\\\")}\"))\n" +
            "    .let { it.scene.frame(it.raster(${size.width}, ${size.height})) }"
        FrameCase(loaded.scene.frame(raster), code, loaded.scene)
    } catch (e: SceneFormatException) {
        throw FramesException("a file of the frames folder cannot be read: ${e.message}", e)
    }

    /** Saves the frame that [failed], if a scene file can express it. Frames from the folder are not saved again. */
    fun keep(failed: RuleResult) {
        val scene = failed.failure?.sceneFile ?: return
        if (failed.rule.name == RULE) return
        val name = "${failed.rule}-%08x.json".format(scene.hashCode())
        try {
            Files.writeString(folder.resolve(name), scene)
        } catch (e: IOException) {
            throw FramesException("the frames folder $folder cannot be written: ${reason(e)}", e)
        }
    }

    companion object {
        /**
         * Returns the files in [folder] with the extension of a scene format, ordered by name; none if there is no such
         * folder.
         *
         * @throws FramesException if the folder cannot be read
         */
        fun files(folder: Path): List<Path> = try {
            Files.list(folder).use { paths ->
                paths.filter { it.isRegularFile() && SceneFormat.ofFileName(it.name) != null }.sorted().toList()
            }
        } catch (_: NoSuchFileException) {
            emptyList()
        } catch (e: IOException) {
            throw FramesException("the frames folder $folder cannot be read: ${reason(e)}", e)
        }

        /** Size of frames whose file has none. */
        private val USUAL_SIZE = ImageSize(64, 48)

        /** Name of the rule that tests them. */
        val RULE: String = UseRules::rule_7_1_userFramesAreDrawnCorrectly.name
    }
}

/** Thrown if a frames folder cannot be used. The message has the reason. */
public class FramesException @JvmOverloads constructor(message: String, cause: Throwable? = null) :
    IllegalArgumentException(message, cause)
