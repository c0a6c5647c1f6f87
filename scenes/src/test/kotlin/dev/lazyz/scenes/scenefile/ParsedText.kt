package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import java.nio.file.Path

/** Reads the [text] of a scene file. */
internal fun parsed(
    text: String,
    name: String = "<text>",
    folder: Path? = null,
    limits: LoadLimits = LoadLimits(),
): LoadedScene = Scenes.load(text.byteInputStream(), SceneFormat.SCENE, name, folder, limits)
