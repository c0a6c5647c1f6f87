package dev.lazyz.scenes.fuzz.seeds

/** Meshes in OFF. */
internal object OffSeeds {
    val all: List<ByteArray> = listOf(
        "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
        "# all\nOFF # kind\n4 3 5\n0 0 0\n1 0 0\n\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0.5 0.5 0 1 # colour\n2 0 1 3\n",
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 0 255 0 0\n1 0 0 0 0 1 0 255 0 255 1 0\n0 1 0 0 0 1 0 0 255 255 0 1\n3 0 1 2\n",
        "COFF 3 1 0\n0 0 0 1 0 0 1\n1 0 0 0 1 0 1\n0 1 0 0 0 1 0.5\n3 2 1 0\n",
    ).map { it.toByteArray() }
}
