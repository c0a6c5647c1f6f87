package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.scenes.writers.AtomicFile
import dev.lazyz.scenes.writers.TemporaryFile
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.file.Files
import java.nio.file.Path

/**
 * The files of a pyramid: the descriptor, `NAME.dzi`, and the folder of its tiles beside it, `NAME_files`. If the
 * descriptor is a link, they are those of the descriptor that it names.
 *
 * @throws IllegalArgumentException if the name of the descriptor does not end in `.dzi`
 * @throws IOException if they cannot be written, or something else has the name of the folder
 */
internal class PyramidFiles(private val descriptor: Path) {
    /** The folder of the tiles. It may exist, and no part of its path is a link then. */
    val folder: Path = tiles(descriptor)

    /** The folder in which tiles are collected that a later run may complete: on the same disk as [folder]. */
    val partial: Path = folder.resolveSibling("${folder.fileName}.partial")

    init {
        require(isNamed(descriptor)) { "cannot write $descriptor: the name of a Deep Zoom pyramid must end in $ENDING" }
        val target = AtomicFile.place(descriptor)
        if (!isNamed(target)) throw refused("it is a link to $target, which does not end in $ENDING; remove it")
        if (nameOf(target).isEmpty()) throw refused("the name must have something before its extension")
        if (Files.exists(folder) && !isPyramid()) {
            throw refused("$folder exists and has other files than tiles; move it away, or choose another name")
        }
        if (!Files.isDirectory(folder.parent)) {
            val link = place(target)
            throw refused("$link is a link, and there is no folder ${folder.parent}; create it, or remove the link")
        }
    }

    /** Gives [tiles], a complete folder, its name, and writes the descriptor. An old pyramid is replaced. */
    fun publish(tiles: Path, width: Int, height: Int) {
        if (!Files.isDirectory(tiles)) throw refused("there is no folder of tiles $tiles; name that of a DeepZoomSink")
        TemporaryFile.beside(folder).use { old ->
            if (Files.exists(folder)) Files.move(folder, old.folder)
            try {
                Files.move(tiles, folder)
                AtomicFile.write(descriptor) { it.write(ByteBuffer.wrap(text(width, height).toByteArray())) }
            } catch (e: IOException) {
                if (Files.exists(folder)) Files.move(folder, tiles)
                if (Files.exists(old.folder)) Files.move(old.folder, folder)
                throw e
            }
        }
    }

    fun refused(reason: String) = IOException("cannot write $descriptor: $reason")

    /** Whether [folder] has nothing but levels of tiles. */
    private fun isPyramid(): Boolean = Files.isDirectory(folder) && all(folder) { level ->
        "${level.fileName}".let { it.length <= 2 && isNumber(it) } && Files.isDirectory(level) && all(level) { tile ->
            isTile("${tile.fileName}") && Files.isRegularFile(tile)
        }
    }

    /** Whether [name] has the form `COLUMN_ROW.png`, or the extension of another kind of picture. */
    private fun isTile(name: String): Boolean {
        val place = name.substringBefore('.').split('_')
        return place.size == 2 && place.all(::isNumber) && name.substringAfter('.') in PICTURES
    }

    private fun isNumber(text: String): Boolean = text.isNotEmpty() && text.all { it in '0'..'9' }

    private fun all(folder: Path, test: (Path) -> Boolean): Boolean {
        if (!Files.isReadable(folder)) throw forbidden("read $folder")
        if (!Files.isWritable(folder)) throw forbidden("delete what is in $folder")
        return Files.list(folder).use { it.allMatch(test) }
    }

    private fun forbidden(action: String) = refused("no permission to $action; permit it, or choose another name")

    private fun text(width: Int, height: Int) =
        """
        |<?xml version="1.0" encoding="UTF-8"?>
        |<Image xmlns="http://schemas.microsoft.com/deepzoom/2008" Format="png"
        |  Overlap="${LevelTiles.OVERLAP}" TileSize="${LevelTiles.TILE}">
        |  <Size Width="$width" Height="$height"/>
        |</Image>
        |
        """.trimMargin()

    companion object {
        private const val ENDING = ".${DeepZoomFiles.EXTENSION}"
        private val PICTURES = setOf("png", "jpg", "jpeg", "webp")

        /** Returns the folder of the tiles, which may exist. Links are followed. */
        fun tiles(descriptor: Path): Path = AtomicFile.resolved(place(AtomicFile.resolved(descriptor)))

        private fun place(target: Path) = target.resolveSibling("${nameOf(target)}_files")

        private fun nameOf(target: Path) = target.fileName?.toString()?.substringBeforeLast('.').orEmpty()

        private fun isNamed(path: Path) = path.toString().endsWith(ENDING, ignoreCase = true)
    }
}

/**
 * How columns, or rows, of a level are divided into tiles. Neighbours share [OVERLAP] pixels on each side of the border
 * between them.
 *
 * @property size number of columns or rows of the level
 */
internal class LevelTiles(private val size: Int) {
    /** Number of tiles. */
    val tiles: Int = (size + TILE - 1) / TILE

    /** The first column or row of [tile]. */
    fun start(tile: Int): Int = maxOf(tile * TILE - OVERLAP, 0)

    /** The end of the columns or rows of [tile]. */
    fun end(tile: Int): Int = minOf((tile + 1) * TILE + OVERLAP, size)

    /** The first column or row of [tile] that no tile before it has as its own. */
    fun ownStart(tile: Int): Int = tile * TILE

    /** The end of those columns or rows. */
    fun ownEnd(tile: Int): Int = minOf((tile + 1) * TILE, size)

    companion object {
        /** With what they share, tiles are 256 pixels wide and high. */
        const val TILE: Int = 254
        const val OVERLAP: Int = 1
    }
}
