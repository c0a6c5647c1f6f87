package dev.lazyz.testing

/**
 * A picture that is not as it should be.
 *
 * @property golden the golden file, as the test names it
 * @property problem what is wrong, in some lines
 * @property expected bytes of the golden file, or null if there is none
 * @property difference the difference as a PNG file, or null if the pictures could not be compared
 */
internal class GoldenFailure(
    val golden: String,
    val problem: String,
    val expected: ByteArray?,
    val actual: ActualPicture,
    val difference: ByteArray?,
)
