package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.Tint
import dev.lazyz.scenes.writers.AtomicFile
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint
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
 * `Scenes.load` returns a scene that renders bit for bit like the scene that [write] wrote. A written file needs no
 * other files: it contains meshes as numbers and textures as embedded PNG. Large meshes are better kept in separate
 * mesh files, which a scene file written by hand can refer to: as JSON they take several times the space and the time.
 */
public object SceneFile {
    /** The format version that is written, and the only one that can be read. */
    public const val VERSION: Int = 1

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
