package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.Tint
import dev.lazyz.scenes.formats.SceneReading
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.writers.AtomicFile
import dev.lazyz.world.Camera
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Sphere
import java.io.IOException
import java.nio.channels.Channels
import java.nio.file.Path

/**
 * Lazy Z's scene file format: a whole [Scene] as JSON, to store, to send, and to write by hand. docs/scene-file.md of
 * the project describes the format.
 *
 * [read] returns a scene that renders bit for bit like the scene that [write] wrote. A written file needs no other
 * files: it contains meshes as numbers and textures as embedded PNG. Large meshes are better kept in separate mesh
 * files, which a scene file written by hand can refer to: as JSON they take several times the space and the time.
 */
public object SceneFile {
    /** The format version that is written, and the only one that can be read. */
    public const val VERSION: Int = 1

    /**
     * Reads a scene file and the mesh and texture files that it refers to.
     *
     * Cost: linear in the size of the file; memory about ten times its size during reading.
     *
     * @param limits limits on what the file can request
     * @throws SceneFormatException if the file is missing, cannot be read, is invalid, or exceeds one of the
     *   [limits], or if a file that it refers to does so; a missing or unreadable texture is only a warning
     */
    @JvmStatic
    @JvmOverloads
    @Throws(SceneFormatException::class)
    public fun read(path: Path, limits: LoadLimits = LoadLimits()): LoadedScene =
        SceneReading.read(path, SceneFormat.SCENE, LoadOptions(limits))

    /**
     * Reads a scene from the text of a scene file.
     *
     * @param name name of the text in messages
     * @param folder the folder of the files that the text refers to, or null if it must not refer to any
     * @param limits limits on what the text can request
     * @throws SceneFormatException if the text is invalid or exceeds one of the [limits], or if a file that it refers
     *   to is missing, invalid, or exceeds them; a missing or unreadable texture is only a warning
     */
    @JvmStatic
    @JvmOverloads
    @Throws(SceneFormatException::class)
    public fun parse(
        text: String,
        name: String = "<text>",
        folder: Path? = null,
        limits: LoadLimits = LoadLimits(),
    ): LoadedScene = SceneFileReader(Source(text.toByteArray(), name, folder, Loading(LoadOptions(limits)))).read()

    /**
     * Writes [scene] to a file, either completely or not at all.
     *
     * Every number is written so that it reads back bit for bit the same. Numbers that are not finite are written as
     * the text `"NaN"`, `"Infinity"` or `"-Infinity"`.
     *
     * @param size the size of the image, or null to let the reader of the file choose it
     * @param depth the depth rules
     * @throws IllegalArgumentException if a surface is not a [Mesh], [Polygon], [Sphere], [Points] or [Lines], the
     *   viewpoint is not a [Camera] or [FittedViewpoint], a material has a shader other than [Tint], or the scene has
     *   a visibility of ambient light: the format cannot represent those
     * @throws IOException if the file cannot be written; the message states which file, why, and what to do
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(scene: Scene, path: Path, size: ImageSize? = null, depth: DepthRules = DepthRules()) {
        SceneFileWriter.requireWritable(scene)
        AtomicFile.write(path) { channel ->
            Channels.newWriter(channel, Charsets.UTF_8).use { SceneFileWriter(it).write(scene, size, depth) }
        }
    }

    /**
     * Returns the text that [write] would write.
     *
     * @throws IllegalArgumentException as [write] does
     */
    @JvmStatic
    @JvmOverloads
    public fun format(scene: Scene, size: ImageSize? = null, depth: DepthRules = DepthRules()): String {
        SceneFileWriter.requireWritable(scene)
        return buildString { SceneFileWriter(this).write(scene, size, depth) }
    }
}
