package dev.lazyz.spark.scaling

import dev.lazyz.spark.scaling.PartPictures.Companion.timed

/** Raw samples, a key and a colour each, whose merging takes [secondsPerSample] for each other piece. */
internal class RawCompositing(private val secondsPerSample: Double) : Compositing<Long> {
    override fun bytes(piece: Long): Long = BYTES * piece

    override fun split(piece: Long, ways: Int): List<Long> = List(ways) { piece / ways }

    override fun merge(pieces: List<Long>): Timed<Long> =
        Timed(pieces[0], (pieces.size - 1) * pieces[0] * secondsPerSample)

    companion object {
        /** A key and a colour. */
        private const val BYTES = 12
        private const val MEASURED = 1 shl 22

        /** Returns a compositing with the time that the minimum of two arrays of keys takes. */
        fun measured(): RawCompositing {
            val keys = LongArray(MEASURED) { it * 31L and 0xFFFF }
            val others = LongArray(MEASURED) { it * 17L and 0xFFFF }
            val colors = IntArray(MEASURED)
            return RawCompositing(
                List(10) {
                    timed {
                        for (i in keys.indices) {
                            if (others[i] < keys[i]) {
                                keys[i] = others[i]
                                colors[i] = i
                            }
                        }
                    }.seconds / keys.size
                }.min(),
            )
        }
    }
}
