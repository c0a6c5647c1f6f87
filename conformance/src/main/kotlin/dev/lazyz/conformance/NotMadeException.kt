package dev.lazyz.conformance

/** The renderer to judge hangs when it is made or asked what it is, before any rule is tried; the message says where. */
public class NotMadeException internal constructor(message: String) : RuntimeException(message)
