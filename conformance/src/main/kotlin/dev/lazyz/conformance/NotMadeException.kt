package dev.lazyz.conformance

/**
 * Thrown if the renderer hangs when it is created or queried, before any rule is run. The message contains stack
 * traces.
 */
public class NotMadeException internal constructor(message: String) : RuntimeException(message)
