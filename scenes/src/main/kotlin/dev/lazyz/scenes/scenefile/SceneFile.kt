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
import dev.lazyz.world.Lines
import dev.lazyz.world.Mesh
import dev.lazyz.world.Points
import dev.lazyz.world.Polygon
import dev.lazyz.world.Scene
import dev.lazyz.world.Sphere
import java.io.IOException
import java.nio.channels.Channels
import java.nio.file.Path

/**
 * Lazy Z's own scene file: a whole [Scene] as JSON, to keep, to send, and to write by hand. docs/scene-file.md of the
 * project describes the format.
 *
 * What [write] writes, [read] reads back to a scene that renders to the same bits. A written file needs no other:
 * meshes are in it as numbers and textures as embedded PNG. Large meshes are better kept in files of their own kind,
 * to which a scene file written by hand may refer: as JSON they take several times the space and the time.
 */
public object SceneFile {
    /** The version of the format that is written, and the only one that is read. */
    public const val VERSION: Int = 1

    /**
     * Reads a scene file and the mesh and texture files that it refers to.
     *
     * Cost: linear in the size of the file; memory about ten times its size while it is read.
     *
     * @param limits how much the file may ask for
     * @throws SceneFormatException if a file is missing, cannot be read, or is not what it should be
     */
    @JvmStatic
    @JvmOverloads
    public fun read(path: Path, limits: LoadLimits = LoadLimits()): LoadedScene =
        SceneReading.read(path, SceneFormat.SCENE, LoadOptions(limits))

    /**
     * Reads a scene file's text.
     *
     * @param name what messages call it
     * @param folder where the files that it refers to are, or null if it must not refer to any
     * @param limits how much it may ask for
     * @throws SceneFormatException if it, or a file that it refers to, is not what it should be
     */
    @JvmStatic
    @JvmOverloads
    public fun parse(
        text: String,
        name: String = "<text>",
        folder: Path? = null,
        limits: LoadLimits = LoadLimits(),
    ): LoadedScene = SceneFileReader(Source(text.toByteArray(), name, folder, Loading(LoadOptions(limits)))).read()

    /**
     * Writes [scene] to a file, whole or not at all.
     *
     * Every number is written so that it reads back to the same bits; where it is not finite, as the text `"NaN"`,
     * `"Infinity"` or `"-Infinity"`.
     *
     * @param size how large the picture is to be, or null to leave it to the reader
     * @param depth how depths are compared
     * @throws IllegalArgumentException if a surface is no [Mesh], [Polygon], [Sphere], [Points] or [Lines], the viewpoint is no [Camera]
     * and no [FittedViewpoint], or a material has a shader other than [Tint]: there is no way to write those
     * @throws IOException if the file cannot be written; the message says which file, why, and what to do
     */
    @JvmStatic
    @JvmOverloads
    public fun write(scene: Scene, path: Path, size: ImageSize? = null, depth: DepthRules = DepthRules()) {
        SceneFileWriter.requireWritable(scene)
        AtomicFile.write(path) { channel ->
            Channels.newWriter(channel, Charsets.UTF_8).use { SceneFileWriter(it).write(scene, size, depth) }
        }
    }

    /**
     * Returns what [write] writes as text.
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
