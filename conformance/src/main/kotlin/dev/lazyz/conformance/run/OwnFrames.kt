package dev.lazyz.conformance.run

import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.results.RuleResult
import dev.lazyz.conformance.rules.UseRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.Scenes
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.isRegularFile
import kotlin.io.path.name

/**
 * A folder of frames of one's own: scene files and meshes, each of which becomes a frame. The suite adds frames that
 * rules have failed on, and later runs of `Conformance` try them before all else.
 *
 * @throws FramesException if the folder or a file in it cannot be read
 */
internal class OwnFrames(private val folder: Path) {
    /** One for each file whose name ends as a scene's does, by name. Files of other kinds, and folders, are left alone. */
    val cases: List<FrameCase> by lazy { files().map { case(it) } }

    private fun files(): List<Path> = try {
        Files.createDirectories(folder)
        Files.list(folder).use { paths ->
            paths.filter { it.isRegularFile() && SceneFormat.ofFileName(it.name) != null }.sorted().toList()
        }
    } catch (e: IOException) {
        throw FramesException("the frames folder $folder cannot be read: $e", e)
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

    /** Keeps the frame that [failed], if there are words for it. A frame of the folder is there already. */
    fun keep(failed: RuleResult) {
        val scene = failed.failure?.sceneFile ?: return
        if (failed.rule.name == RULE) return
        val name = "${failed.rule}-%08x.json".format(scene.hashCode())
        try {
            Files.writeString(folder.resolve(name), scene)
        } catch (e: IOException) {
            throw FramesException("the frames folder $folder cannot be written: $e", e)
        }
    }

    companion object {
        /** Of frames whose file does not say. */
        private val USUAL_SIZE = ImageSize(64, 48)

        /** The name of the rule that tries them. */
        val RULE: String = UseRules::rule_7_1_framesOfOnesOwnAreRight.name
    }
}

/** A frames folder that cannot be used; the message says why. */
public class FramesException @JvmOverloads constructor(message: String, cause: Throwable? = null) :
    IllegalArgumentException(message, cause)
