package dev.lazyz.cli.input

/** The value of `--camera`. */
internal sealed class CameraChoice {
    /** A camera that shows the whole scene. */
    data object Fit : CameraChoice()

    /** The scene's own camera, or a fitted one if it has none. */
    data object OfScene : CameraChoice()

    /** The camera of the model with this number, from 0. */
    data class OfModel(val number: Int) : CameraChoice()
}
