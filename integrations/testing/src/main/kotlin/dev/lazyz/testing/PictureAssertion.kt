package dev.lazyz.testing

import dev.lazyz.scenes.SceneFormatException
import java.io.UncheckedIOException
import org.opentest4j.AssertionFailedError

/** A golden test of a picture. Created by [assertThat]. Immutable and thread safe. */
public class PictureAssertion private constructor(
    private val goldens: Goldens,
    private val threshold: Double,
    private val actual: () -> ActualPicture,
) {
    internal constructor(goldens: Goldens, actual: () -> ActualPicture) : this(goldens, 0.0, actual)

    /**
     * Accepts a picture if no channel of a pixel differs by more than [codes] from the golden file, 0..255, in codes of
     * 8 bits. The default is 0, since Lazy Z gives the same bits on every machine. Sizes must be the same in any case.
     *
     * @throws IllegalArgumentException if [codes] is not in 0..255
     */
    public fun withThreshold(codes: Double): PictureAssertion =
        PictureAssertion(goldens, validThreshold(codes), actual)

    /**
     * Compares the picture with the file [golden], pixel by pixel.
     *
     * The path is relative to `src/test/resources` of the project whose tests run, or to the folder that the system
     * property `lazyz.golden.root` names; or it is absolute. With `-Dlazyz.golden.update=true`, a file that is missing
     * or different is written instead of compared, which is printed to standard output. Otherwise it never is.
     *
     * @param golden path of a PNG file, with `/` between folders
     * @throws AssertionFailedError if the pictures differ, or there is no such file. The picture, the differences and a
     *   page that shows them are then in `golden-pictures` of the build folder; the message names them
     * @throws IllegalArgumentException if [golden] does not end in `.png`
     * @throws UncheckedIOException if a file cannot be read or written
     */
    public fun matches(golden: String) {
        require(golden.endsWith(".png")) { "a golden file must end in .png: $golden" }
        val picture = try {
            actual()
        } catch (damaged: SceneFormatException) {
            throw AssertionFailedError("the picture cannot be compared with $golden: ${damaged.message}", damaged)
        }
        goldens.check(golden, picture, threshold)
    }
    internal companion object {
        /** Returns [codes], which must be in 0..255. */
        fun validThreshold(codes: Double): Double {
            require(codes in 0.0..255.0) { "the threshold must be in 0..255: $codes" }
            return codes
        }
    }
}
