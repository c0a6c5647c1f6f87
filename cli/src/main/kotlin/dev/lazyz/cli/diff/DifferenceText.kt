package dev.lazyz.cli.diff

import dev.lazyz.Region
import dev.lazyz.cli.output.Mistake
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.pictures.PictureDifference
import dev.lazyz.scenes.pictures.PixelDifference
import dev.lazyz.scenes.writers.writePng
import java.nio.file.Path
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonObject

/**
 * Writes the picture of where the pictures differ to [path], a PNG file.
 *
 * @throws Mistake if it has too many pixels
 */
internal fun PictureDifference.writeMarked(path: Path) {
    val image = try {
        toImage()
    } catch (e: IllegalArgumentException) {
        throw Mistake("--diff $path: ${e.message}; omit --diff\n$summary")
    }
    image.writePng(path)
}

/**
 * A difference of two pictures as text and as JSON. Scripts depend on the names in [toJson].
 *
 * @param expected name of the expected picture
 * @param actual name of the other
 */
internal class DifferenceText(
    private val expected: String,
    private val actual: String,
    private val difference: PictureDifference,
) {
    /** The verdict, followed by what differs; lines. */
    val lines: String
        get() {
            val verdict = when {
                difference.isIdentical -> "is the same as"
                difference.isMatch -> "matches"
                else -> "differs from"
            }
            return "$actual $verdict $expected\n${difference.summary}\n"
        }

    fun toJson(): JsonObject = buildJsonObject {
        putPicture("expected", expected, difference.expected)
        putPicture("actual", actual, difference.actual)
        put("threshold", difference.threshold)
        put("identical", difference.isIdentical)
        put("matches", difference.isMatch)
        if (difference.isSameSize) {
            put("differingPixels", difference.differingPixels)
            put("largestDifference", difference.largest)
            put("meanDifference", difference.mean)
        }
        difference.bounds?.let { putRegion(it) }
        difference.first?.let { putPixel(it) }
    }

    private fun JsonObjectBuilder.putPicture(key: String, file: String, picture: Picture) = putJsonObject(key) {
        put("file", file)
        put("width", picture.width)
        put("height", picture.height)
    }

    private fun JsonObjectBuilder.putRegion(region: Region) = putJsonObject("bounds") {
        put("x", region.columnStart)
        put("y", region.rowStart)
        put("width", region.width)
        put("height", region.height)
    }

    /** In the form of `zcli compare`. */
    private fun JsonObjectBuilder.putPixel(pixel: PixelDifference) = putJsonObject("firstDifference") {
        put("x", pixel.x)
        put("y", pixel.y)
        putJsonObject("expected") { put("color", pixel.expected) }
        putJsonObject("actual") { put("color", pixel.actual) }
    }
}
