package dev.lazyz.planning

/**
 * What a part of a rendering needs. Immutable.
 *
 * @property what description of the part
 * @property bytes most bytes of memory that it holds at a time
 * @throws IllegalArgumentException if [bytes] is negative
 */
public class MemoryItem(public val what: String, public val bytes: Long) {
    init {
        require(bytes >= 0) { "bytes must not be negative: $bytes" }
    }

    override fun toString(): String = "MemoryItem($what, $bytes bytes)"
}
