package dev.lazyz.scenes.fuzz

/**
 * What is done with each input. [LoadAndDraw] does it, which is loaded by [Coverage] and known to the fuzzer only by
 * this interface.
 */
internal interface SceneCase {
    /** Loads [bytes]; returns whether there is a scene now, and all messages for the user. */
    fun load(bytes: ByteArray): Loaded

    /** Draws the scene that was loaded last. */
    fun draw()

    /**
     * @property isScene whether there is a scene, or a refusal
     * @property messages warnings, or the refusal
     */
    class Loaded(val isScene: Boolean, val messages: List<String>)
}
