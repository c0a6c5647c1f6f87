package dev.lazyz.testing

import dev.lazyz.scenes.pictures.Picture

/**
 * The picture that a test has made.
 *
 * @param encode returns the bytes of a PNG file with the same pixels
 */
internal class ActualPicture(val picture: Picture, encode: () -> ByteArray) {
    /** The picture as a PNG file. Encoded only if a file is written. */
    val png: ByteArray by lazy(encode)
}
