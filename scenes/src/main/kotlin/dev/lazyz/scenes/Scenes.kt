package dev.lazyz.scenes

import dev.lazyz.scenes.builtin.Builtins
import dev.lazyz.scenes.formats.SceneReading
import dev.lazyz.world.Scene
import java.io.InputStream
import java.nio.file.Path

/**
 * Where scenes come from: files of any supported format, streams, and the built-in ones.
 *
 * Thread safe. To write a scene see [dev.lazyz.scenes.scenefile.SceneFile], to write a picture
 * [dev.lazyz.scenes.writers.writePng].
 */
public object Scenes {
    /**
     * The built-in scenes, in the order in which to show them; all made by code, the same bits on every machine.
     */
    @JvmStatic
    public val builtins: List<Builtin> get() = Builtins.all

    /** Returns the built-in scene called [id], made anew, or null if there is none. */
    @JvmStatic
    public fun builtin(id: String): Scene? = builtins.firstOrNull { it.id == id }?.scene()

    /**
     * Reads the scene in a file.
     *
     * The ending of the name decides on the format; a name with no ending, or an unknown one, is decided by the first
     * bytes. Cost: linear in the size of the file, which must fit into memory and be below 2 GB.
     *
     * Files that it refers to are read with it, as [LoadLimits.references] of [limits] allows.
     *
     * @param limits how much the file may ask for
     * @throws SceneFormatException if the file is missing, empty, a folder, a pipe, too large, unreadable, of no known
     * format, not what its format says, or beyond one of the [limits]
     */
    @JvmStatic
    @JvmOverloads
    public fun load(path: Path, limits: LoadLimits = LoadLimits()): LoadedScene =
        load(path, LoadOptions(limits))

    /**
     * Reads the scene in a file, in a way of one's own.
     *
     * @throws SceneFormatException as above
     */
    @JvmStatic
    public fun load(path: Path, options: LoadOptions): LoadedScene =
        SceneReading.read(path, SceneFormat.ofFileName(path.toString()), options)

    /**
     * Reads the scene in a file of the given format, whatever its name.
     *
     * @throws SceneFormatException as above
     */
    @JvmStatic
    @JvmOverloads
    public fun load(path: Path, format: SceneFormat, limits: LoadLimits = LoadLimits()): LoadedScene =
        load(path, format, LoadOptions(limits))

    /**
     * Reads the scene in a file of the given format, whatever its name, in a way of one's own.
     *
     * @throws SceneFormatException as above
     */
    @JvmStatic
    public fun load(path: Path, format: SceneFormat, options: LoadOptions): LoadedScene =
        SceneReading.read(path, format, options)

    /**
     * Reads the scene in a stream, up to its end; does not close it.
     *
     * @param name what messages call it
     * @param folder where the files that it refers to are, or null if there are none; references to others are
     * reported as missing
     * @param limits how much the stream may ask for
     * @throws SceneFormatException if the stream fails, is empty, too large, not what [format] says, or beyond one of the
     * [limits]
     */
    @JvmStatic
    @JvmOverloads
    public fun load(
        input: InputStream,
        format: SceneFormat,
        name: String = "<stream>",
        folder: Path? = null,
        limits: LoadLimits = LoadLimits(),
    ): LoadedScene = load(input, format, name, folder, LoadOptions(limits))

    /**
     * Reads the scene in a stream, up to its end, in a way of one's own; does not close it.
     *
     * @throws SceneFormatException as above
     */
    @JvmStatic
    public fun load(
        input: InputStream,
        format: SceneFormat,
        name: String,
        folder: Path?,
        options: LoadOptions,
    ): LoadedScene = SceneReading.read(input, format, name, folder, options)

    /**
     * Returns the Utah teapot; see [Builtin].
     *
     * @param segments into how many parts each side of each of the 32 patches is cut, 1..256: `64 n^2 - 8 n` triangles
     * @throws IllegalArgumentException if [segments] is out of range
     */
    @JvmStatic
    @JvmOverloads
    public fun teapot(segments: Int = 16): Scene = Builtins.teapot(segments)

    /**
     * Returns a city seen from its main street: boxes behind boxes, so that most of what is drawn is hidden.
     *
     * @param blocks blocks of houses along each side of the city, 1..100; a block has four houses of 10 triangles
     * @param seed makes another city for each number
     * @throws IllegalArgumentException if [blocks] is out of range
     */
    @JvmStatic
    @JvmOverloads
    public fun city(blocks: Int = 12, seed: Long = 1): Scene = Builtins.city(blocks, seed)

    /**
     * Returns squares stacked and twisted, submitted from the lowest to the topmost: a picture in which a renderer that
     * shades whatever is nearest so far shades nearly all fragments in vain.
     *
     * @param count number of squares, 1..100000
     * @throws IllegalArgumentException if [count] is out of range
     */
    @JvmStatic
    @JvmOverloads
    public fun layers(count: Int = 100): Scene = Builtins.layers(count)
}
