package dev.lazyz.scenes.ply

import dev.lazyz.scenes.Source
import java.nio.ByteOrder

/** Hands out the rows of the body, one after the other. Not thread safe. */
internal abstract class PlyBody(protected val source: Source) {
    /** Where the row that was read last stands. */
    abstract val location: String

    /** Fails unless what is left of the file can hold all rows of [element]; call it before making room for them. */
    abstract fun announce(element: PlyElement)

    /** Reads the next row into [row]. */
    abstract fun read(row: PlyRow)

    /** Returns how long a list is whose length the file gives as [count], when no more than [most] numbers are left. */
    protected fun listLength(property: PlyProperty, count: Double, most: Int): Int {
        if (!(count >= 0.0) || (count < Int.MAX_VALUE && count != count.toInt().toDouble())) {
            source.fail(location, "the length of list ${property.name} is $count", "export the model again")
        }
        if (count > most) {
            source.fail(
                location,
                "list ${property.name} announces ${count.toLong()} numbers, but there is room for $most",
                "export or copy the model again",
            )
        }
        return count.toInt()
    }

    protected fun tooShort(element: PlyElement, remaining: Int): Nothing = source.fail(
        location,
        "element ${element.name} announces ${element.count} rows, for which the remaining $remaining bytes are too few",
        "export or copy the model again",
    )

    companion object {
        /** Returns the body that [header] describes. */
        fun of(source: Source, header: PlyHeader): PlyBody = when (header.format) {
            PlyFormat.ASCII -> PlyTextBody(source, header)
            PlyFormat.LITTLE_ENDIAN -> PlyBinaryBody(source, header, ByteOrder.LITTLE_ENDIAN)
            PlyFormat.BIG_ENDIAN -> PlyBinaryBody(source, header, ByteOrder.BIG_ENDIAN)
        }
    }
}
