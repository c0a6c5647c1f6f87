package dev.lazyz

/** The attributes that a shader can read, as bit flags. */
internal object Attributes {
    /** Position in world space: x, y, z. */
    const val WORLD: Int = 1

    /** Normal: x, y, z. */
    const val NORMAL: Int = 2

    /** Texture coordinates: u, v. */
    const val UV: Int = 4

    /** Vertex colour: red, green, blue, alpha. */
    const val COLOR: Int = 8
}
