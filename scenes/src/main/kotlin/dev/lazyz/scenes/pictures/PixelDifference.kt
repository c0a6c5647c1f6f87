package dev.lazyz.scenes.pictures

/**
 * A pixel that has another colour than it should.
 *
 * @property x its column, from 0
 * @property y its row, from 0 at the top
 * @property expected the colour that it should have, see [Picture.color]
 * @property actual the colour that it has
 */
public class PixelDifference internal constructor(
    public val x: Int,
    public val y: Int,
    public val expected: String,
    public val actual: String,
) {
    override fun toString(): String = "column $x, row $y: expected $expected, but was $actual"
}
