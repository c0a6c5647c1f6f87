package dev.lazyz.strategies.tiled.binning

/**
 * A list of pairs of a key and a place, stored in pieces so that it grows without copying. Belongs to one thread at a
 * time.
 */
internal class KeyedPlaces(private val pool: ArrayPool) {
    private val keyPieces = ArrayList<LongArray>()
    private val placePieces = ArrayList<IntArray>()

    /** The last pieces, and the number of their elements in use. */
    private var keys = LongArray(0)
    private var places = IntArray(0)
    private var taken = 0

    /** Bytes held. */
    val bytes: Long get() = keyPieces.size * PIECE * (Long.SIZE_BYTES + Int.SIZE_BYTES).toLong()

    /** Appends a pair. */
    fun add(key: Long, place: Int) {
        if (taken == keys.size) addPieces()
        keys[taken] = key
        places[taken++] = place
    }

    private fun addPieces() {
        keys = pool.longs(PIECE).also { keyPieces += it }
        places = pool.ints(PIECE).also { placePieces += it }
        taken = 0
    }

    /** Calls [action] with each pair, in the order in which they were added. */
    inline fun forEach(action: (key: Long, place: Int) -> Unit) {
        for (piece in keyPieces.indices) {
            val pieceKeys = keyPieces[piece]
            val piecePlaces = placePieces[piece]
            val end = if (pieceKeys === keys) taken else PIECE
            for (i in 0 until end) action(pieceKeys[i], piecePlaces[i])
        }
    }

    /** Returns all memory to the pool; must be called last. */
    fun release() {
        for (piece in keyPieces) pool.release(piece)
        for (piece in placePieces) pool.release(piece)
    }

    companion object {
        /** Pairs in a piece. */
        const val PIECE: Int = 8192
    }
}
