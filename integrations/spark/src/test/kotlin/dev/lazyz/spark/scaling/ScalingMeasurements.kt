package dev.lazyz.spark.scaling

/**
 * What was measured: drawing of all parts, and merging of some, simulated with their real runs. A model is fitted to
 * parts of few executors.
 */
internal class ScalingMeasurements(val pictures: PartPictures) {
    class Drawing(val pictures: PartPictures, val split: Split, val parts: Int, val drawn: Drawn) {
        val fragments: Long = drawn.bands.fragments
        val bytes: Long = drawn.bands.cells.sumOf { it.part.runs.size.toLong() }
    }

    class Merging(
        val split: Split,
        val parts: Int,
        val costs: List<MergeCost>,
        val simulated: Map<String, Simulated<RunPiece>>,
    )

    val network: Network = Network(BYTES_PER_SECOND, LATENCY)
    private val drawings = ArrayList<Drawing>()
    val mergings: MutableList<Merging> = ArrayList()
    val raw: RawCompositing = RawCompositing.measured()

    /** Draws all parts, and keeps what each took. */
    fun measureDrawing(from: PartPictures, split: Split, parts: Int): List<Drawn> =
        List(parts) { from.draw(it, parts, split) }.onEach { drawings += Drawing(from, split, parts, it) }

    /** Draws and merges all parts; for [keep] their cost is part of the report. */
    fun measure(from: PartPictures, split: Split, parts: Int, keep: Boolean) {
        System.err.println("$split in $parts parts")
        val drawn = measureDrawing(from, split, parts)
        val costs = ArrayList<MergeCost>()
        val simulated = LinkedHashMap<String, Simulated<RunPiece>>()
        val inBands = drawn.map { one -> one.bands.cells.associate { it.number to RunPiece(listOf(it)) } }
        simulated[TREE] = MergeSimulation(PartPictures.RunCompositing(from.bandSetUp, costs), network)
            .tree(inBands, from.bandSetUp.bands)
        val inStrips = drawn.map { from.strips(it.bands) }
        for ((name, k) in SWAPS) {
            simulated[name] = MergeSimulation(PartPictures.RunCompositing(from.stripSetUp, costs), network)
                .swap(inStrips, factors(parts, k))
        }
        if (keep) mergings += Merging(split, parts, costs, simulated) else drawings.clear()
    }

    /** The picture, as its parts have shown. */
    val facts: PictureFacts by lazy {
        val bands = mergings[0].simulated.getValue(TREE).pieces.flatMap { it.cells }
        val counts = List(pictures.bandSetUp.bands) { n -> bands.filter { it.number == n }.sumOf { it.fragments } }
        val ends = counts.runningReduce(Long::plus).map { it.toDouble() / counts.sum() }
        val covered = drawings(Split.SCATTERED) { it == PARTS[0] }.sumOf { it.drawn.covered }
        PictureFacts(pictures.width.toLong() * pictures.height, counts.sum(), ends, covered.toDouble() / counts.sum())
    }

    fun drawings(split: Split, parts: (Int) -> Boolean): List<Drawing> =
        drawings.filter { it.pictures == pictures && it.split == split && parts(it.parts) }

    val sizes: Map<Split, PartSizes> by lazy {
        Split.entries.associateWith { split ->
            // Parts differ: some are hidden, so the mean of the parts counts
            val means = PARTS.filter { it in 4..FITTED }.map { parts -> parts to drawings(split) { it == parts } }
            val covered = means.map { (_, all) -> all.map { it.fragments }.average() / facts.visible }
            val seen = means.flatMap { it.second }.filter { it.fragments > LEAST }
            val bytes = Fit.factors(
                seen.map {
                    PartSizes.sizeFeatures(it.fragments.toDouble(), it.fragments.toDouble() / facts.visible)
                },
                seen.map { it.bytes.toDouble() },
            )
            PartSizes(facts, split, PartSizes.exponent(facts, split, means.map { 1.0 / it.first }, covered), bytes)
        }
    }

    val drawing: DoubleArray by lazy {
        val fitted = drawings.filter { it.parts <= FITTED }
        Fit.factors(
            fitted.map {
                val own = it.drawn.triangles.toDouble()
                ScalingModel.drawFeatures(facts, sizes.getValue(it.split), own * it.parts, own)
            },
            fitted.map { it.drawn.seconds },
        )
    }

    val merging: DoubleArray by lazy {
        val fitted = mergings.filter { it.parts <= FITTED }.flatMap { it.costs }.filter { it.fragments.sum() > LEAST }
        Fit.factors(
            fitted.map {
                ScalingModel.mergeFeatures(it.samples.toDouble(), it.fragments.map(Long::toDouble))
            },
            fitted.map { it.seconds },
        )
    }

    fun model(split: Split): ScalingModel = ScalingModel(facts, sizes.getValue(split), drawing, merging, network)

    companion object {
        const val TREE: String = "Spark's tree"
        const val BINARY: String = "binary swap"
        private const val RADIX = "radix-k"

        /** Greatest k of radix-k. */
        const val GREATEST: Int = 8

        /** Greatest k of each algorithm. */
        val SWAPS: Map<String, Int> = mapOf(BINARY to 2, RADIX to GREATEST)

        /** The numbers of parts that are measured. */
        val PARTS: List<Int> = listOf(2, 4, 8, 16, 32, 64)

        /** The model is fitted to measurements with so many parts at most. */
        const val FITTED: Int = 16

        /** Merging fewer fragments is not measured exactly. */
        private const val LEAST = 1000

        /** 10 Gbit/s. */
        private const val BYTES_PER_SECOND = 1.25e9
        private const val LATENCY = 1e-3

        /**
         * Returns factors of [nodes], the greatest first, of which each is [most] or less; a prime factor above that is
         * one of them.
         */
        fun factors(nodes: Int, most: Int): List<Int> = buildList {
            var rest = nodes
            while (rest > 1) {
                val small = (minOf(rest, most) downTo 2).firstOrNull { rest % it == 0 }
                add(small ?: (2..rest).first { rest % it == 0 })
                rest /= last()
            }
        }
    }
}
