package dev.lazyz.scenes.threemf

import dev.lazyz.Rgba
import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.images.SrgbDecoding

/**
 * Reads the groups of colours and texture coordinates of a model part (core specification, 5, and "Materials and
 * Properties Extension", version 1.2.1). Not thread safe.
 *
 * @param unused counts the features that are not shown
 */
internal class ThreeMfLooksReader(
    private val part: PackagePart,
    private val looks: ThreeMfLooks,
    private val unused: KindCounts,
) {
    private val finishes = ThreeMfFinishReader(part, looks)

    /** Reads the current element if it is a group or a texture; returns false otherwise. */
    fun read(name: String): Boolean {
        when (name) {
            "basematerials" -> readColors("base", "displaycolor", isOpaqueWithoutAlpha = true)
            "colorgroup" -> readColors("color", "color", isOpaqueWithoutAlpha = false)
            "texture2d" -> readTexture()
            "texture2dgroup" -> readPlaces()
            "compositematerials" -> readMixes()
            "multiproperties" -> readLayers()
            else -> return finishes.read(name)
        }
        return true
    }

    private fun id(): Int = part.number("id") ?: part.fail("the group has no id")

    private fun newGroup(texture: Int): ThreeMfLooks.Group {
        val group = ThreeMfLooks.Group(texture)
        looks.groups[id()] = group
        group.finishes = part.number(FINISHES) ?: -1
        return group
    }

    /**
     * Reads a group of colours. Some programs write an alpha of 0 for opaque base materials, which would be invisible;
     * with [isOpaqueWithoutAlpha] they are read as opaque.
     */
    private fun readColors(element: String, attribute: String, isOpaqueWithoutAlpha: Boolean) {
        val group = newGroup(-1)
        part.forEachChild {
            if (it == element) {
                part.number(FINISHES)?.let { finishes -> group.ownFinishes[group.numbers.size] = finishes }
                group.numbers.add(color(part.attribute(attribute), isOpaqueWithoutAlpha))
            }
        }
    }

    /**
     * Returns the number of the colour `#RRGGBB` or `#RRGGBBAA`, or of white if [text] is not a colour. All channels
     * except alpha are sRGB-encoded.
     */
    private fun color(text: String?, isOpaqueWithoutAlpha: Boolean): Int {
        val given = ThreeMfColor.code(text)
        if (given == null && text != null) unused.add("colours that are not #RRGGBB or #RRGGBBAA")
        val code = given ?: 0xFFFFFFFF
        val alpha = if (isOpaqueWithoutAlpha && code and 0xFF == 0L) 0xFF else code and 0xFF
        return looks.palette.add(
            SrgbDecoding.decodeByte((code shr 24).toInt()),
            SrgbDecoding.decodeByte((code shr 16).toInt() and 0xFF),
            SrgbDecoding.decodeByte((code shr 8).toInt() and 0xFF),
            alpha / 255f,
        )
    }

    private fun readTexture() {
        val path = part.attribute("path") ?: part.fail("the texture has no path")
        looks.textures[id()] = ThreeMfTexture(
            path,
            part.attribute("tilestyleu"),
            part.attribute("tilestylev"),
            part.attribute("filter") != "nearest",
        )
    }

    private fun readPlaces() {
        val group = newGroup(part.number("texid") ?: part.fail("the group has no texid"))
        part.forEachChild {
            if (it == "tex2coord") {
                val u = part.float(part.attribute("u") ?: part.fail("the coordinates have no u"))
                val v = part.float(part.attribute("v") ?: part.fail("the coordinates have no v"))
                group.numbers.add(looks.places.add(u, 1f - v))
            }
        }
    }

    /** Reads mixes of base materials: the weighted mean of their colours, computed in linear light. */
    private fun readMixes() {
        val group = newGroup(-1)
        val base = looks.groups[part.number("matid") ?: -1]
        val indices = part.words("matindices").map { part.whole(it) }
        val color = FloatArray(4)
        part.forEachChild { element ->
            val weights = part.words("values").map { part.float(it) }
            val sum = FloatArray(4)
            for ((index, weight) in indices.zip(weights)) {
                if (base == null || base.texture >= 0 || index >= base.numbers.size) continue
                looks.palette.copy(base.numbers[index], color, 0)
                for (channel in 0 until 4) sum[channel] += weight * color[channel]
            }
            val total = weights.sum()
            if (element == "composite") {
                if (total > 0f) for (channel in 0 until 4) sum[channel] = (sum[channel] / total).coerceIn(0f, 1f)
                group.numbers.add(looks.palette.add(sum[0], sum[1], sum[2], sum[3]))
            }
        }
    }

    /**
     * Reads layers that lie on top of each other. Uses the last layer with a texture, on the mean colour of the layer
     * of colours that is next below it; or the first layer if none has a texture. Light is reflected as the first
     * layer says, as section 5.1 recommends.
     */
    private fun readLayers() {
        val ids = part.words("pids").map { part.whole(it) }
        val layers = ids.map { looks.groups[it] }
        val shown = layers.indexOfLast { it != null && it.texture >= 0 }.coerceAtLeast(0)
        val below = layers.take(shown).indexOfLast { it != null && it.texture < 0 }
        val layer = layers.getOrNull(shown)
        val group = newGroup(layer?.texture ?: -1)
        group.first = layers.firstOrNull()?.takeIf { it.first == null }
        repeat(ids.size - (if (below < 0) 1 else 2)) { unused.add("layers of multiproperties") }
        val grounds = ArrayList<Int>()
        part.forEachChild {
            val indices = part.words("pindices")
            number(layer, indices, shown)?.let { number ->
                group.numbers.add(number)
                group.firstIndices.add(indices.firstOrNull()?.let { first -> part.whole(first) } ?: 0)
            }
            number(layers.getOrNull(below), indices, below)?.let { number -> grounds.add(number) }
        }
        group.ground = mean(grounds)
    }

    /** Returns what the index at [place] of [indices] refers to in [layer], or null if there is no such element. */
    private fun number(layer: ThreeMfLooks.Group?, indices: List<String>, place: Int): Int? {
        // A missing index means the first element of the layer
        val index = indices.getOrNull(place)?.let { part.whole(it) } ?: 0
        return if (layer != null && index < layer.numbers.size) layer.numbers[index] else null
    }

    /** Returns the mean of [colors], which are numbers in the palette, or null if there are none. */
    private fun mean(colors: List<Int>): Rgba? {
        if (colors.isEmpty()) return null
        val sum = DoubleArray(4)
        val color = FloatArray(4)
        for (number in colors) {
            looks.palette.copy(number, color, 0)
            for (channel in 0 until 4) sum[channel] += color[channel].toDouble()
        }
        val (red, green, blue, alpha) = sum.map { (it / colors.size).toFloat() }
        return Rgba(red, green, blue, alpha)
    }

    private companion object {
        const val FINISHES = "displaypropertiesid"
    }
}

/** Colours as 3MF writes them. */
internal object ThreeMfColor {
    /** Returns the number 0xRRGGBBAA that [text] says, `#RRGGBB` or `#RRGGBBAA`, or null if it is not a colour. */
    fun code(text: String?): Long? = text?.trim()?.takeIf(::isColor)?.drop(1)?.padEnd(8, 'F')?.toLong(16)

    private fun isColor(text: String): Boolean = text.startsWith('#') && (text.length == 7 || text.length == 9) &&
        text.drop(1).all { it in '0'..'9' || it.lowercaseChar() in 'a'..'f' }
}
