package dev.lazyz.planning

/** What large arrays take of a heap. */
internal object HeapArrays {
    private const val LEAST_REGION = 1L shl 20
    private const val MOST_REGION = 32L shl 20

    /** The number of regions that the garbage collector G1 aims at. */
    private const val REGIONS = 2048

    /**
     * Returns what an array of [bytes] takes of a heap of [memory] bytes: G1 gives whole regions to an array of half a
     * region or more.
     */
    fun bytes(bytes: Long, memory: Long): Long {
        val region = java.lang.Long.highestOneBit((memory / REGIONS).coerceIn(LEAST_REGION, MOST_REGION))
        return if (bytes < region / 2) bytes else (bytes + HEADER - 1) / region * region + region
    }

    private const val HEADER = 16
}
