package dev.lazyz.setup

import dev.lazyz.shading.Vertices

/**
 * How far apart the texture coordinates of neighbouring samples of a flat primitive are: ray differentials, computed
 * from the same edge functions as the coordinates (contract rules 6.6 and 6.12).
 */
internal object TextureFootprint {
    /**
     * Passes to [use] the weights of the vertices at a sample, see [PerspectiveWeights], and how they change if the
     * sum of the edge functions stays what it is: by a footprint to the right, and by a footprint downward.
     *
     * @param e0 edge function opposite to vertex 0 at the sample; e1 and e2 for the other vertices
     * @param e0dx what e0 changes by from column to column; e1dx and e2dx for the other vertices
     * @param e0dy what e0 changes by from row to row; e1dy and e2dy for the other vertices
     * @param over0 1/w of vertex 0; over1 and over2 of the other vertices
     * @param least a lower bound of the sum of the edge functions, each multiplied by its 1/w
     * @param side the side of a footprint, in samples
     */
    inline fun of(
        e0: Double,
        e1: Double,
        e2: Double,
        e0dx: Long,
        e1dx: Long,
        e2dx: Long,
        e0dy: Long,
        e1dy: Long,
        e2dy: Long,
        over0: Double,
        over1: Double,
        over2: Double,
        least: Double,
        side: Int,
        use: (
            w0: Double, w1: Double, w2: Double,
            right0: Double, right1: Double, right2: Double,
            down0: Double, down1: Double, down2: Double,
        ) -> Unit,
    ) {
        PerspectiveWeights.of(e0, e1, e2, over0, over1, over2, least) { w0, w1, w2, scale ->
            val step = scale * side
            use(
                w0, w1, w2,
                e0dx.toDouble() * over0 * step, e1dx.toDouble() * over1 * step, e2dx.toDouble() * over2 * step,
                e0dy.toDouble() * over0 * step, e1dy.toDouble() * over1 * step, e2dy.toDouble() * over2 * step,
            )
        }
    }

    /**
     * Passes to [use] the derivatives of two attributes, [field] and the one after it: of both to the right, then of
     * both downward.
     *
     * @param a the number of vertex 0 in [vertices]; b and c of the other vertices
     * @param w0 weight of vertex 0, and its changes right0 and down0, see [of]; the other numbers belong to the other
     *   vertices
     */
    inline fun derivatives(
        vertices: Vertices,
        field: Int,
        a: Int,
        b: Int,
        c: Int,
        w0: Double,
        w1: Double,
        w2: Double,
        right0: Double,
        right1: Double,
        right2: Double,
        down0: Double,
        down1: Double,
        down2: Double,
        use: (uRight: Float, vRight: Float, uDown: Float, vDown: Float) -> Unit,
    ) {
        val u = vertices.mixed(field, a, w0, b, w1, c, w2)
        val v = vertices.mixed(field + 1, a, w0, b, w1, c, w2)
        use(
            vertices.slope(field, u, a, right0, b, right1, c, right2).toFloat(),
            vertices.slope(field + 1, v, a, right0, b, right1, c, right2).toFloat(),
            vertices.slope(field, u, a, down0, b, down1, c, down2).toFloat(),
            vertices.slope(field + 1, v, a, down0, b, down1, c, down2).toFloat(),
        )
    }
}
