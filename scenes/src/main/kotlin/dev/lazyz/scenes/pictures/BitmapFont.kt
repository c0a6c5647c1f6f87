package dev.lazyz.scenes.pictures

/**
 * A font of 5 x 7 dots for short labels in pictures: capital letters, digits and some signs. Small letters are drawn as
 * capital ones, and unknown characters as a box. It is the same on every machine, unlike the fonts of `java.desktop`.
 */
internal object BitmapFont {
    /** Height of a character, dots. */
    const val HEIGHT: Int = 7

    /** Columns from a character to the next: 5, and one that is free. */
    const val ADVANCE: Int = 6

    private const val WIDTH = ADVANCE - 1

    /** The rows of each character from the top, a digit of base 32 for each: the bits from left to right. */
    private val glyphs: Map<Char, String> = (
        "A EHHVHHH B UHHUHHU C EHGGGHE D UHHHHHU E VGGUGGV F VGGUGGG G EHGNHHF H HHHVHHH I E44444E J 72222IC " +
            "K HIKOKIH L GGGGGGV M HRLLHHH N HHPLJHH O EHHHHHE P UHHUGGG Q EHHHLID R UHHUKIH S FGGE11U T V444444 " +
            "U HHHHHHE V HHHHHA4 W HHHLLLA X HHA4AHH Y HHHA444 Z V1248GV " +
            "0 EHJLPHE 1 4C4444E 2 EH1248V 3 V2421HE 4 26AIV22 5 VGU11HE 6 68GUHHE 7 V124888 8 EHHEHHE 9 EHHF12C " +
            ". 00000CC , 0000C48 - 000E000 + 044V440 : 0CC0CC0 / 01248G0 ( 2488842 ) 8422248 % OP248J3 " +
            "< 248G842 > 8421248 = 00V0V00 _ 000000V # AAVAVAA * 04LEL40 ! 4444404 ? EH12404 ' 4480000"
        ).split(' ').chunked(2).associate { (character, rows) -> character.single() to rows } + (' ' to "0000000")

    private const val UNKNOWN = "VHHHHHV"

    /** Returns the width of [text], dots. */
    fun width(text: String): Int = maxOf(ADVANCE * text.length - 1, 0)

    /** Calls [dot] for each dot of [text], with column and row from its upper left corner. */
    inline fun forEachDot(text: String, dot: (column: Int, row: Int) -> Unit) {
        for ((place, character) in text.withIndex()) {
            for (row in 0 until HEIGHT) {
                for (column in 0 until ADVANCE) if (isDot(character, column, row)) dot(ADVANCE * place + column, row)
            }
        }
    }

    /** Whether there is a dot at a column and row of [character]. */
    fun isDot(character: Char, column: Int, row: Int): Boolean {
        if (column >= WIDTH) return false
        val bits = (glyphs[character.uppercaseChar()] ?: UNKNOWN)[row].digitToInt(1 shl WIDTH)
        return bits ushr (WIDTH - 1 - column) and 1 != 0
    }
}
