package dev.lazyz.world.camera

/**
 * The matrix of [Camera.clipMatrix]. Elements are named as in JOML: column, then row. It does not use JOML, because
 * loading JOML's matrix class takes longer than setting up a small image.
 *
 * @param elements 16 elements, column by column
 */
internal class ClipMatrix(elements: DoubleArray) {
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
