package dev.lazyz.shared

import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import javax.imageio.ImageIO

/**
 * Parameters of pictures as words, to compare all ways to ask for a picture: each test compares its own with the
 * library.
 */
object PictureWords {
    /** Words of each parameter that mean a value, at the ends of its range first, and then one that means none. */
    val all: Map<String, List<String>> = mapOf(
        "format" to listOf("obj", "OBJ", "doc"),
        "up" to listOf("x", "-z", "w"),
        "animation-time" to listOf("0", "1000000", "-1"),
        "variant" to listOf("blue", "Street Sneaker", ""),
        "scene" to listOf("0", "7", "-1"),
        "size" to listOf("40x30", "32", "40y30"),
        "region" to listOf("0,0,1x1", "3,4,20x15", "0,0,0x1"),
        "aa" to listOf("1", "8", "3"),
        "aa-filter" to listOf("box", "mitchell", "none"),
        "shading-rate" to listOf("sample", "pixel", "auto", "row"),
        "background" to listOf("transparent", "skyblue,f80", "environment", "red,8888"),
        "color" to listOf("tomato", "ff008880", "tomatoe"),
        "texture" to listOf("picture.png", "picture.png", "-"),
        "shading" to listOf("flat", "constant", "matt"),
        "texture-filter" to listOf("none", "anisotropic", "sharp"),
        "point-size" to listOf("0.001", "64", "0"),
        "line-width" to listOf("0.001", "64", "1e9"),
        "opaque" to listOf("true", "true", ""),
        "depth-convention" to listOf("smaller", "larger", "least"),
        "style" to listOf("technical", "product", "comic"),
        "light" to listOf("sun", "flat", "moon"),
        "light-intensity" to listOf("0", "1000", "-0.5"),
        "environment" to listOf("sky.hdr", "studio", "-"),
        "environment-rotation" to listOf("-1e6", "12.5", "1e7"),
        "environment-intensity" to listOf("0", "1000", "-0.5"),
        "ambient-occlusion" to listOf("true", "true", ""),
        "ground-shadow" to listOf("true", "true", ""),
        "matcap" to listOf("picture.png", "picture.png", "-"),
        "tone-map" to listOf("neutral", "none", "film"),
        "exposure" to listOf("-20", "20", "20.5"),
        "camera" to listOf("fit", "scene", "-1"),
        "view" to listOf("iso", "top", "side"),
        "azimuth" to listOf("-1e6", "12.5", "1e7"),
        "elevation" to listOf("-90", "90", "91"),
        "projection" to listOf("perspective", "orthographic", "flat"),
        "margin" to listOf("0", "45", "46"),
        "zoom" to listOf("0.001", "2.5", "0"),
        "fov" to listOf("1", "90", "180"),
        "eye" to listOf("5,4,9", "-3,2,1", "1,2"),
        "target" to listOf("0,0,0", "1,1,1", "1,2,1e999"),
        "camera-up" to listOf("0,1,0", "1,1,0", "up"),
        "height" to listOf("0.5", "9", "0"),
        "near" to listOf("0.1", "3", "1e999"),
        "far" to listOf("7", "100", "x"),
        "edges" to listOf("true", "true", ""),
        "wireframe" to listOf("true", "true", ""),
        "crease-angle" to listOf("0", "180", "181"),
        "hidden-lines" to listOf("dashed", "solid", "dotted"),
        "edge-width" to listOf("0.001", "9", "5000"),
        "edge-color" to listOf("navy", "00f", "8888"),
        "hidden-color" to listOf("red", "0f0", "reddd"),
        "hidden-behind" to listOf("1", "9", "0"),
        "cut" to listOf("x=50%", "1,1,1,2", "x"),
        "cap-color" to listOf("lime", "ffffff80", "limes"),
        "scale" to listOf("1:2", "2.5:1", "1:0"),
        "unit" to listOf("mm", "in", "mile"),
    )

    /**
     * Combinations of [names], each of which has values in [all]: every value alone, also those that mean nothing, and
     * with a few other parameters, chosen by steps of a prime number through the list. By default each twelfth of these,
     * with `-Dlazyz.effort=rest` each second, which has other words of all parameters, with `full` all.
     */
    fun combinations(names: List<String>): List<Map<String, String>> {
        val alone = names.flatMap { name -> all.getValue(name).map { mapOf(name to it) } }
        val pairs = names.indices.flatMap { first ->
            (1..PAIRS).map { step ->
                val pair = setOf(names[first], names[(first + step * PRIME) % names.size])
                pair.associateWith { all.getValue(it)[(first + step) % 2] }
            }
        }
        return (alone + pairs).filterIndexed { i, _ ->
            when (System.getProperty("lazyz.effort")) {
                null -> i % PARTS == 0
                "rest" -> i % 2 == 1
                else -> true
            }
        }
    }

    /** The file that words call `picture.png`: a few colours. */
    fun picture(): ByteArray {
        val image = BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB)
        for (i in 0 until 64) image.setRGB(i % 8, i / 8, 0x1F2F3F * i)
        return ByteArrayOutputStream().also { ImageIO.write(image, "png", it) }.toByteArray()
    }

    /** The file that words call `sky.hdr`: a picture of surroundings, brighter above. */
    fun sky(): ByteArray = "#?RADIANCE\n\n-Y 4 +X 8\n".toByteArray() +
        ByteArray(4 * 8 * 4) { if (it % 4 == 3) 128.toByte() else (250 - it).toByte() }

    /** The files that words name. */
    val files: Map<String, ByteArray> get() = mapOf("picture.png" to picture(), "sky.hdr" to sky())

    /** An archive with [model], an OBJ file, and the files that words name. */
    fun archive(model: ByteArray): ByteArray {
        val bytes = ByteArrayOutputStream()
        ZipOutputStream(bytes).use { zip ->
            for ((name, content) in mapOf("model.obj" to model) + files) {
                zip.putNextEntry(ZipEntry(name))
                zip.write(content)
            }
        }
        return bytes.toByteArray()
    }

    private const val PAIRS = 3
    private const val PRIME = 7
    private const val PARTS = 12
}
