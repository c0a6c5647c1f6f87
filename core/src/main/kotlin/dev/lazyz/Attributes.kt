package dev.lazyz

/** The attributes that a shader may read, one bit each. */
internal object Attributes {
    /** Position in the world. */
    const val WORLD: Int = 1

    /** Normal vector. */
    const val NORMAL: Int = 2

    /** Texture coordinates. */
    const val UV: Int = 4

    /** Colour of the vertices, with alpha. */
    const val COLOR: Int = 8
}
