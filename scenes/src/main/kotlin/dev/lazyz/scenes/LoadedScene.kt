package dev.lazyz.scenes

import dev.lazyz.Scene

/**
 * A scene that was read, and what the reader had to pass over.
 *
 * @property scene what the file holds, with its own camera and lights where it has them
 * @property warnings one sentence each, in the order of the file: a texture that is missing, a face that was left out
 */
public class LoadedScene(public val scene: Scene, public val warnings: List<String>) {
    override fun toString(): String = "LoadedScene($scene, ${warnings.size} warnings)"
}
