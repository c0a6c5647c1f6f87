package dev.lazyz.world

/**
 * The matrix of [Camera.setUpMatrix], named as JOML names elements: column, then row. Without JOML, whose class of
 * matrices takes longer to load than a small picture to set up.
 *
 * @param elements column by column
 */
internal class SetUpMatrix(elements: DoubleArray) {
    val m00: Double = elements[0]
    val m01: Double = elements[1]
    val m02: Double = elements[2]
    val m03: Double = elements[3]
    val m10: Double = elements[4]
    val m11: Double = elements[5]
    val m12: Double = elements[6]
    val m13: Double = elements[7]
    val m20: Double = elements[8]
    val m21: Double = elements[9]
    val m22: Double = elements[10]
    val m23: Double = elements[11]
    val m30: Double = elements[12]
    val m31: Double = elements[13]
    val m32: Double = elements[14]
    val m33: Double = elements[15]
}
