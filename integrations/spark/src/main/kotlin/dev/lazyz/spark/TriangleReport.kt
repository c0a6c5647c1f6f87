package dev.lazyz.spark

import dev.lazyz.Counters

/**
 * What a [TrianglePicture] took. Immutable.
 *
 * @property order the order that was used
 * @property shading when colours were computed
 * @property counters the work of all tasks
 * @property movedBytes bytes of fragments or triangles that crossed from task to task, before Spark compressed them;
 *   not counted are finished rows on their way to the driver
 */
public class TriangleReport internal constructor(
    public val order: SortOrder,
    public val shading: SortedShading,
    public val counters: Counters,
    public val movedBytes: Long,
) {
    override fun toString(): String = "TriangleReport($order, $shading, $movedBytes bytes moved, $counters)"

    /** Adds up what bands took. */
    internal class Builder(private val order: SortOrder, private val shading: SortedShading) {
        private val counters = Counters.Builder()
        private var moved = 0L

        fun add(work: Counters, moved: Long) {
            counters.add(work)
            this.moved += moved
        }

        fun build(triangles: Long): TriangleReport {
            counters.primitives = triangles
            return TriangleReport(order, shading, counters.build(), moved)
        }
    }
}
