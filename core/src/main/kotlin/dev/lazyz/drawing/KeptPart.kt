package dev.lazyz.drawing

/** The part of an edge that linear conditions leave: from [low] to [high], 0 for its first end and 1 for its second. */
internal class KeptPart {
    var low = 0.0
        private set
    var high = 1.0
        private set

    val isEmpty: Boolean get() = low >= high

    /** Keeps the whole edge. */
    fun begin() {
        low = 0.0
        high = 1.0
    }

    /** Keeps nothing. */
    fun clear() {
        high = low
    }

    /** Keeps the part in which a linear function with the values [f0] and [f1] at the ends is not negative. */
    fun keepPositive(f0: Double, f1: Double) {
        if (f0 < 0.0) {
            if (f1 < 0.0) clear() else low = maxOf(low, f0 / (f0 - f1))
        } else if (f1 < 0.0) {
            high = minOf(high, f0 / (f0 - f1))
        }
    }
}
