package dev.lazyz.textbooks

import dev.lazyz.textbooks.WorkedExample.Companion.rectangle

/** The examples of `docs/textbooks.md`, with the arrays that follow from working them by hand. */
internal object WorkedExamples {
    /** A tie at column 4, and a surface that is nearer than both others. */
    val row = WorkedExample(
        "textbook-row",
        "A row of eight samples",
        8,
        1,
        listOf(
            rectangle('A', 0..5, 0..0, 5.0),
            // 9 minus the column, at the centre of the sample
            rectangle('B', 2..7, 0..0, 7.5, 1.5),
            rectangle('C', 2..3, 0..0, 1.0),
        ),
        listOf(
            "inf inf inf inf inf inf inf inf",
            "  5   5   5   5   5   5 inf inf",
            "  5   5   5   5   5   4   3   2",
            "  5   5   1   1   5   4   3   2",
        ),
        "A A C C A B B B",
    )

    /** Surfaces that cross, ties along a column and a row, and a diagonal edge through centres of samples. */
    val surfaces = WorkedExample(
        "textbook-surfaces",
        "Three surfaces, one after the other",
        8,
        6,
        listOf(
            rectangle('P', 0..4, 0..3, 4.0),
            // 8 minus the column
            rectangle('Q', 2..7, 1..5, 6.5, 0.5),
            // 7 minus the row, left of the diagonal
            Shape('R', 0.0, 0.0, 7.5, 6.0, 6.0, 1.5, 0.0, 6.0, 1.5),
        ),
        listOf(
            """
            inf inf inf inf inf inf inf inf
            inf inf inf inf inf inf inf inf
            inf inf inf inf inf inf inf inf
            inf inf inf inf inf inf inf inf
            inf inf inf inf inf inf inf inf
            inf inf inf inf inf inf inf inf
            """.trimIndent(),
            """
            |  4   4   4   4   4 inf inf inf
            |  4   4   4   4   4 inf inf inf
            |  4   4   4   4   4 inf inf inf
            |  4   4   4   4   4 inf inf inf
            |inf inf inf inf inf inf inf inf
            |inf inf inf inf inf inf inf inf
            """.trimMargin(),
            """
            |  4   4   4   4   4 inf inf inf
            |  4   4   4   4   4   3   2   1
            |  4   4   4   4   4   3   2   1
            |  4   4   4   4   4   3   2   1
            |inf inf   6   5   4   3   2   1
            |inf inf   6   5   4   3   2   1
            """.trimMargin(),
            """
            |  4   4   4   4   4 inf inf inf
            |  4   4   4   4   4   3   2   1
            |  4   4   4   4   4   3   2   1
            |  4   4   4   4   4   3   2   1
            |  3   3   3   3   4   3   2   1
            |  2   2   2   2   2   3   2   1
            """.trimMargin(),
        ),
        """
        P P P P P . . .
        P P P P P Q Q Q
        P P P P P Q Q Q
        P P P P P Q Q Q
        R R R R Q Q Q Q
        R R R R R Q Q Q
        """.trimIndent(),
    )

    /** Two triangles that share the diagonal of a square, through the centres of four samples. */
    val grid = WorkedExample(
        "textbook-grid",
        "Two triangles in a grid of 4 x 4",
        4,
        4,
        listOf(
            // 1 plus the column
            Shape('S', 0.0, 0.0, 0.5, 4.0, 0.0, 4.5, 4.0, 4.0, 4.5),
            // 5 minus the row
            Shape('T', 0.0, 0.0, 5.5, 4.0, 4.0, 1.5, 0.0, 4.0, 1.5),
        ),
        listOf(
            """
            inf inf inf inf
            inf inf inf inf
            inf inf inf inf
            inf inf inf inf
            """.trimIndent(),
            """
            |  1   2   3   4
            |inf   2   3   4
            |inf inf   3   4
            |inf inf inf   4
            """.trimMargin(),
            """
            |  1   2   3   4
            |  4   2   3   4
            |  3   3   3   4
            |  2   2   2   4
            """.trimMargin(),
        ),
        """
        S S S S
        T S S S
        T T S S
        T T T S
        """.trimIndent(),
    )

    val all = listOf(row, surfaces, grid)
}
