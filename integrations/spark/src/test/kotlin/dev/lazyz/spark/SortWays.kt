package dev.lazyz.spark

/** The ways of rendering a [TrianglePicture]. */
internal object SortWays {
    val all: List<Pair<SortOrder, SortedShading>> = listOf(
        SortOrder.LAST to SortedShading.EAGER,
        SortOrder.LAST to SortedShading.LAZY,
        SortOrder.MIDDLE to SortedShading.EAGER,
    )
}
