package dev.lazyz

/** The depth of a background against which all fragments pass the test, whatever the convention is. */
val DepthTest.behindAll: Int get() = if (key(0, 0) < key(1, 0)) Int.MAX_VALUE else 0
