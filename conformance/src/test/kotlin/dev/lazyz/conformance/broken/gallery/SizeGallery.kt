package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenCombinations
import dev.lazyz.conformance.broken.BrokenReuse
import dev.lazyz.conformance.broken.BrokenSizes
import dev.lazyz.conformance.broken.gallery.RuleNames.deep
import dev.lazyz.conformance.broken.gallery.RuleNames.far
import dev.lazyz.conformance.broken.gallery.RuleNames.floats
import dev.lazyz.conformance.broken.gallery.RuleNames.manySpans
import dev.lazyz.conformance.broken.gallery.RuleNames.million
import dev.lazyz.conformance.broken.gallery.RuleNames.region
import dev.lazyz.conformance.broken.gallery.RuleNames.thin
import dev.lazyz.conformance.broken.gallery.RuleNames.thousands
import dev.lazyz.conformance.broken.gallery.RuleNames.thousandsOfSpans
import dev.lazyz.conformance.broken.gallery.RuleNames.tiles
import dev.lazyz.conformance.broken.gallery.RuleNames.together

/** The gallery's part about features that work alone but not together. */
internal object CombinationGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(
            BrokenCombinations::noBlendingInRegions,
            "nothing is blended if the region is a part of the raster",
            together,
        ),
        Mutant(BrokenCombinations::noBlendingWithThreads, "nothing is blended with several threads", together),
    )
}

/** The gallery's part about size: correct for small frames. */
internal object SizeGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenSizes::columnsIn16Bits, "columns are kept in 16 bits where they are shaded", far),
        Mutant(BrokenSizes::rowsIn15Bits, "rows are kept in a short where they are shaded", far),
        Mutant(BrokenSizes::lastColumnOfATileOf64, "the last column of each tile of 64 x 64 samples is lost", tiles),
        Mutant(BrokenSizes::lastRowOfABandOf128, "the last row of each band of 128 rows is lost", tiles),
        Mutant(BrokenSizes::noTilesBeyondTheFirstOf256, "tiles of 256 right of or below the first are lost", tiles),
        Mutant(BrokenReuse::placesOf16Bits, "a place within a tile has 16 bits", RuleNames.tileSizes),
        Mutant(
            BrokenSizes::elevenBitsOfATile,
            "what is visible in a tile of 64 x 64 samples has numbers of eleven bits",
            RuleNames.tileSizes,
        ),
        Mutant(
            BrokenSizes::sortsByRecursion,
            "the fragments of a sample are sorted by calls as deep as there are fragments, if they come in order",
            RuleNames.millionOfARow, million,
        ),
        Mutant(
            BrokenReuse::losesATriangleOfBlocks,
            "of many triangles one is lost where a region begins within a block of eight rows",
            RuleNames.layersOfRegion,
        ),
        Mutant(
            BrokenReuse::sortsByNineBits,
            "primitives are sorted by nine bits of the band in which they begin",
            RuleNames.manyTiles,
        ),
        Mutant(
            BrokenReuse::tilesOf14Bits,
            "small triangles are sorted by 14 bits of the number of their tile",
            RuleNames.manyTiles,
        ),
        Mutant(
            BrokenSizes::coversItsTile,
            "a wide primitive covers its last tile, although it ends before the last column",
            RuleNames.covered,
        ),
        Mutant(
            BrokenSizes::stopsAtTheFirstHidden,
            "primitives after the first hidden one are lost, in a rough order from near to far",
            RuleNames.wall,
        ),
        Mutant(
            BrokenSizes::forgetsWhatBeganBefore,
            "a row is processed in pieces of a million fragments, and a piece lacks spans of the one before",
            RuleNames.millionOfARow,
        ),
        Mutant(BrokenSizes::sixteenSpans, "a primitive has at most 16 spans in a row", manySpans),
        Mutant(BrokenSizes::spansIn14Bits, "a primitive has at most 16,384 spans in a row", thousandsOfSpans),
        Mutant(BrokenSizes::blendsAMillionFragments, "a picture has at most a million translucent fragments", million),
        Mutant(BrokenSizes::keepsEightLayers, "an opaque fragment that comes late leaves at most eight layers", thin),
        Mutant(BrokenSizes::thirtyTwoLayers, "a sample takes at most 32 fragments", deep),
        Mutant(BrokenSizes::layersInAByte, "a sample takes at most 255 fragments", thousands),
        Mutant(BrokenSizes::blends32Layers, "at most 32 layers are blended", thin),
        Mutant(BrokenSizes::indexThroughAFloat, "indices go through a float", floats),
        Mutant(BrokenSizes::indexIn24Bits, "indices have 24 bits", floats),
    )
}
