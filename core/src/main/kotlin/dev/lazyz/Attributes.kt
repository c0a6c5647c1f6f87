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

    /** Texture coordinates of the second set: u2, v2. */
    const val UV2: Int = 16

    /** Tangent: x, y, z and handedness. */
    const val TANGENT: Int = 32

    /** Derivatives of the texture coordinates that the fragment has, see [Fragment.dudx]. */
    const val FOOTPRINT: Int = 64

    /** All of them. */
    const val ALL: Int = WORLD or NORMAL or UV or COLOR or UV2 or TANGENT or FOOTPRINT
}
