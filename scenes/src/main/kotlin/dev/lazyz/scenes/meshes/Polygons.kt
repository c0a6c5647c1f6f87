package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.collections.Ints

/** The polygons of a file, one after the other, with what they and their corners look like. Not thread safe. */
internal class Polygons {
    /** Of each polygon the number of corners, then the vertex numbers. */
    private val corners = Ints()

    /** Where [corners] has a vertex number, that of the corner's texture coordinates or -1; before them the texture's. */
    private val placeNumbers = Ints()

    /** By polygon: number of its colour, or -1. */
    private val colorNumbers = Ints()

    /** The colours and texture coordinates that the polygons refer to. */
    val colors = Palette()
    val places = TexturePlaces()

    /** How many polygons there are. */
    var count = 0
        private set

    /** Whether a polygon has a colour, or its corners texture coordinates. */
    val haveLooks: Boolean get() = colorNumbers.size > 0 || placeNumbers.size > 0

    /** Whether corners have texture coordinates. */
    val havePlaces: Boolean get() = placeNumbers.size > 0

    /** How many corners there are, and a number for each polygon besides. */
    val size: Int get() = corners.size

    /** Begins a polygon of so many corners, which are to be added next. */
    fun begin(cornerCount: Int) {
        corners.add(cornerCount)
        count++
    }

    fun add(vertex: Int) {
        corners.add(vertex)
    }

    /** Gives [polygon] a colour; those before it have got theirs. */
    fun color(polygon: Int, number: Int) {
        while (colorNumbers.size < polygon) colorNumbers.add(-1)
        colorNumbers.add(number)
    }

    /** Gives the polygon that was added last a texture; the texture coordinates of its corners are to be added next. */
    fun texture(number: Int, cornerCount: Int) {
        while (placeNumbers.size < corners.size - cornerCount - 1) placeNumbers.add(-1)
        placeNumbers.add(number)
    }

    fun addPlace(number: Int) {
        placeNumbers.add(number)
    }

    /** Returns the number at [index], below [size]: of corners, then of the vertex at each. */
    operator fun get(index: Int): Int = corners[index]

    /** Returns the number of the texture coordinates of the corner at [index], of a polygon's texture before its first. */
    fun place(index: Int): Int = if (index < placeNumbers.size) placeNumbers[index] else -1

    /** Returns the number of a polygon's colour. */
    fun colorOf(polygon: Int): Int = if (polygon < colorNumbers.size) colorNumbers[polygon] else -1
}
