package dev.lazyz.scenes

import dev.lazyz.world.surface.StreamedMesh
import java.io.Closeable

/**
 * A scene whose triangles stay in their file, and are read part by part when they are rendered. Close it after the last
 * rendering: it keeps the file open, and may have temporary files, which [close] deletes. The file must not change
 * before that: what reads it, such as a rendering or a fitted camera, throws an [java.io.UncheckedIOException] with a
 * [SceneReadException] as its cause if the file cannot be read. Thread safe.
 *
 * @property loaded the scene, with a [StreamedMesh] for each mesh of the file, and warnings
 */
public class StreamedScene internal constructor(public val loaded: LoadedScene, private val input: AutoCloseable) :
    Closeable {
    /** Closes the file and deletes temporary files. Closing again does nothing. */
    override fun close(): Unit = input.close()

    override fun toString(): String = "StreamedScene($loaded)"
}
