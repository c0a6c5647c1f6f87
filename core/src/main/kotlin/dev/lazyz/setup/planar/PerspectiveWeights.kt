package dev.lazyz.setup.planar

/** Interpolation in perspective between three vertices (contract rule 3.6). */
internal object PerspectiveWeights {
    /**
     * Passes the weights of the vertices at a sample to [use], and the factor by which the products of edge functions
     * and 1/w are scaled so that their sum is 1. The only division for a fragment.
     *
     * @param e0 edge function opposite to vertex 0 at the sample; e1 and e2 for the other vertices
     * @param over0 1/w of vertex 0; over1 and over2 of the other vertices
     * @param least a lower bound of the sum of the edge functions, each multiplied by its 1/w
     */
    inline fun of(
        e0: Double,
        e1: Double,
        e2: Double,
        over0: Double,
        over1: Double,
        over2: Double,
        least: Double,
        use: (w0: Double, w1: Double, w2: Double, scale: Double) -> Unit,
    ) {
        val part0 = e0 * over0
        val part1 = e1 * over1
        val part2 = e2 * over2
        val scale = 1.0 / maxOf(part0 + part1 + part2, least)
        use(part0 * scale, part1 * scale, part2 * scale, scale)
    }
}
