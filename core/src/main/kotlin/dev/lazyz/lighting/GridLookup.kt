package dev.lazyz.lighting

/**
 * Returns the [value]s of the four nodes around a place on a square grid, interpolated; [outside] if the place is
 * beyond the grid. Nodes are numbered by rows, and node 0 is at column 0 and row 0.
 *
 * @param size number of nodes of a side
 */
internal inline fun interpolated(
    column: Float,
    row: Float,
    size: Int,
    outside: Float,
    value: (node: Int) -> Float,
): Float {
    if (!(column >= 0f && row >= 0f && column < size - 1 && row < size - 1)) return outside
    val left = column.toInt()
    val top = row.toInt()
    val right = column - left
    val down = row - top
    val at = top * size + left
    val upper = value(at) * (1f - right) + value(at + 1) * right
    val lower = value(at + size) * (1f - right) + value(at + size + 1) * right
    return upper * (1f - down) + lower * down
}
