package dev.lazyz.scenes.fuzz.seeds

/** Models in OBJ, and material libraries for them. */
internal object ObjSeeds {
    private const val SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"

    val models: List<ByteArray> = listOf(
        "${SQUARE}f 1 2 3 4\n",
        "# all\nmtllib a.mtl\no one\n${SQUARE}vt 0 0\nvt 1 0\nvt 1 1 0\nvn 0 0 1\nvn 0 1 1e-1\n" +
            "g a b\ns 1\nusemtl a\nf 1/1/1 2/2/1 3/3/2\ns off\nf 1//1 3//2 4//1\nusemtl b\nf -4/-3 -2/-1 -1/-2 # end\n",
        "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0.5 1 0 0 0 1\nv 0.5 0.2 0.1 1 1 1\n" +
            "s 3\nf 1 2 4\nf 2 3 4\nf 3 1 4 \\\n 2\nl 1 2 3\np 1\n",
        "v 500123.001 4649776.002 3.125\nv 500124.001 4649776.002 3\nv 500124.001 4649777.503 3\nf 1 2 3\n",
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nv 1 1 0\r\nf 1 2 3 4 5\nf 1 6 5 6 1\n",
    ).map { it.toByteArray() }

    val libraries: List<ByteArray> = listOf(
        "newmtl a\nKd 1 0.5 0\nKs 0.2 0.2 0.2\nKe 0 0 0.6\nNs 96.078\nillum 2\nd 0.5\nTr 0.5\nmap_Kd t.png\n",
        "# all\nnewmtl a\nKd 0.5\nKa 1 1 1\nNi 1.5\nd -halo 0.5\nmap_Kd -clamp on -s 2 3 1 -o 0.5 0.25 -mm 0 1 " +
            "t.png\n" +
            "newmtl b\nKd xyz 0.1 0.2 0.3\nKs spectral a.rfl 2\nmap_d \"t.png\"\nmap_Kd T.PNG\nbump -bm 2 t.png\n" +
            "newmtl c d\nTr 1\nillum 0\nNs 9999\nmap_Ks missing.png\nPr 0.5\nPm 1\nmap_Ke t.png\n",
    ).map { it.toByteArray() }
}
