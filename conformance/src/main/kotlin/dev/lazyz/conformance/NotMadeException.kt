package dev.lazyz.conformance

/**
 * Thrown if the renderer hangs when it is created or queried, before any rule is run. The message contains stack
 * traces.
 *
 * @property isInconclusive whether the machine may only have been too busy
 */
public class NotMadeException internal constructor(message: String, public val isInconclusive: Boolean) :
    RuntimeException(message)
