package dev.lazyz.scenes.builtin

/**
 * Random numbers that are the same on every machine.
 *
 * Source: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014 (SplitMix64).
 */
internal class SplitMix(private var state: Long) {
    private fun nextLong(): Long {
        state += GAMMA
        var z = state
        z = (z xor (z ushr 30)) * FIRST
        z = (z xor (z ushr 27)) * SECOND
        return z xor (z ushr 31)
    }

    /** Returns a number in [low]..[high], [high] excluded. */
    fun between(low: Double, high: Double): Double = low + (high - low) * ((nextLong() ushr 11) / TWO_TO_53)

    /** Returns a number in 0 until [bound]. */
    fun below(bound: Int): Int = Math.floorMod(nextLong(), bound.toLong()).toInt()

    override fun toString(): String = "SplitMix($state)"

    private companion object {
        val GAMMA = 0x9E3779B97F4A7C15uL.toLong()
        val FIRST = 0xBF58476D1CE4E5B9uL.toLong()
        val SECOND = 0x94D049BB133111EBuL.toLong()
        const val TWO_TO_53 = 9007199254740992.0
    }
}
