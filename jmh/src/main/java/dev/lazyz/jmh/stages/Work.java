package dev.lazyz.jmh.stages;

import java.util.List;
import java.util.function.ToLongFunction;

/**
 * Work that a stage cannot avoid, for each of some units of a frame. The frame's bits demand it: another implementation
 * of the same stage has to move these bytes and do these operations, too.
 *
 * <p>An operation is one on a 64-bit number, as in {@link Machine}. An operation on 32-bit numbers counts half, because
 * a vector has twice as many of them. Loads, stores, addresses and branches are not counted. A comparison, a minimum, a
 * shift or a conversion counts like an addition.
 *
 * @param stage the stage
 * @param unit what is counted, in the plural
 * @param count the number of units of a frame
 * @param data the data that is moved, which decides the level of memory
 * @param bytes bytes read and written for each unit
 * @param operations operations for each unit
 * @param divisions divisions for each unit
 * @param reason what the figures consist of
 */
record Work(
        Stage stage,
        String unit,
        ToLongFunction<FrameCounts> count,
        Data data,
        double bytes,
        double operations,
        double divisions,
        String reason) {
    /** Sets of data; the size of a set decides in which level of memory it can be at best. */
    enum Data {
        /** Positions, vertex numbers, vertices on the grid. */
        MESH,

        /** Entries and fragments of tiles. */
        BINS,

        /** Rows of a band of tiles. */
        ROWS,

        /** Keys and fragments of a tile. */
        TILE;

        /** Bytes of the set. */
        long size(FrameCounts counts) {
            return switch (this) {
                case MESH -> counts.meshBytes();
                case BINS -> counts.binBytes();
                case ROWS -> counts.rowBytes();
                case TILE -> 8L * FrameCounts.TILE * FrameCounts.TILE;
            };
        }
    }

    /** All work that is counted. */
    static final List<Work> ALL = List.of(
            new Work(
                    Stage.TRANSFORM,
                    "vertices",
                    FrameCounts::vertices,
                    Data.MESH,
                    12,
                    36,
                    0,
                    "reads 3 floats; 12 products and 12 sums of a 4 x 3 matrix; 12 operations for 6 planes"),
            new Work(
                    Stage.SNAP,
                    "vertices",
                    FrameCounts::vertices,
                    Data.MESH,
                    12,
                    21,
                    0,
                    "writes 3 integers; for each of them 7: to the raster, to the grid, floor, clamp, conversion"),
            new Work(
                    Stage.SNAP,
                    "vertices with perspective",
                    counts -> counts.perspective() * counts.vertices(),
                    Data.MESH,
                    8,
                    0,
                    4,
                    "x, y and z by w, and 1/w, which is written"),
            new Work(
                    Stage.BIN,
                    "triangles",
                    FrameCounts::triangles,
                    Data.MESH,
                    12,
                    7,
                    0,
                    "reads 3 vertex numbers; 14 of 32 bits: 8 minima and maxima, 4 to samples, 2 comparisons"),
            new Work(
                    Stage.BIN,
                    "vertices",
                    FrameCounts::vertices,
                    Data.MESH,
                    12,
                    0,
                    0,
                    "reads column, row and depth once, though triangles share them"),
            new Work(
                    Stage.BIN,
                    "entries",
                    FrameCounts::entries,
                    Data.BINS,
                    16,
                    4,
                    0,
                    "a key is written and read; counted, and sorted by depth"),
            new Work(
                    Stage.BIN,
                    "fragments of small triangles",
                    FrameCounts::smallFragments,
                    Data.BINS,
                    24,
                    2,
                    0,
                    "key and place are written and read; counted"),
            new Work(
                    Stage.SET_UP,
                    "triangles by tile",
                    FrameCounts::setUps,
                    Data.MESH,
                    36,
                    30,
                    2,
                    "reads 3 vertices; depth: 6 differences, 9 for numerators and area, 15 for slopes and origin"),
            new Work(
                    Stage.SET_UP,
                    "triangles by tile, not small",
                    FrameCounts::faces,
                    Data.TILE,
                    0,
                    27,
                    0,
                    "3 edge functions of 9: differences, products, steps, ownership"),
            new Work(
                    Stage.SET_UP,
                    "interpolated triangles by tile",
                    FrameCounts::mixedFaces,
                    Data.MESH,
                    48,
                    0,
                    0,
                    "reads 3 colours of 4 floats"),
            new Work(
                    Stage.SET_UP,
                    "lit triangles by tile",
                    FrameCounts::litFaces,
                    Data.MESH,
                    72,
                    0,
                    0,
                    "reads 3 positions and 3 normals"),
            new Work(
                    Stage.COVER,
                    "small triangles",
                    FrameCounts::small,
                    Data.TILE,
                    0,
                    8,
                    0,
                    "3 edge functions of 5, of 32 bits, at one sample"),
            new Work(
                    Stage.COVER,
                    "compared samples",
                    FrameCounts::compared,
                    Data.TILE,
                    8,
                    4,
                    0,
                    "reads a key; depth, its upper half, the index, the minimum"),
            new Work(
                    Stage.COVER, "samples of tiles drawn into", FrameCounts::drawn, Data.TILE, 8, 0, 0, "clears a key"),
            new Work(
                    Stage.RESOLVE,
                    "samples of tiles drawn into",
                    FrameCounts::drawn,
                    Data.TILE,
                    8,
                    1.5,
                    0,
                    "reads a key; 3 of 32 bits: depth, sign of the depth test, is it the same primitive"),
            new Work(
                    Stage.RESOLVE,
                    "samples",
                    FrameCounts::samples,
                    Data.ROWS,
                    8,
                    0,
                    0,
                    "writes depth and primitive number"),
            new Work(
                    Stage.RESOLVE,
                    "samples of one known colour",
                    counts -> counts.samples() - counts.mixed(),
                    Data.ROWS,
                    4,
                    0,
                    0,
                    "writes the colour of background, or of a triangle"),
            new Work(
                    Stage.RESOLVE,
                    "runs",
                    FrameCounts::runs,
                    Data.TILE,
                    0,
                    4,
                    0,
                    "finds the primitive's group, adds the run"),
            new Work(
                    Stage.INTERPOLATE,
                    "interpolated samples",
                    FrameCounts::mixed,
                    Data.TILE,
                    12,
                    33,
                    0,
                    "writes 3 floats; 3 edge functions of 4, 3 products with a scale, 3 components of 6"),
            new Work(
                    Stage.INTERPOLATE,
                    "interpolated samples with perspective",
                    counts -> counts.perspective() * counts.mixed(),
                    Data.TILE,
                    0,
                    6,
                    1,
                    "3 products with 1/w, 2 sums, a maximum; the division by the sum"),
            new Work(
                    Stage.INTERPOLATE,
                    "lit samples",
                    FrameCounts::lit,
                    Data.TILE,
                    24,
                    36,
                    0,
                    "writes 6 floats; 6 components of 6"),
            new Work(
                    Stage.SHADE,
                    "interpolated samples",
                    counts -> counts.mixed() - counts.rounds() - counts.lit(),
                    Data.TILE,
                    24,
                    3,
                    0,
                    "reads and writes 3 floats; 3 products and sums of 32 bits"),
            new Work(
                    Stage.SHADE,
                    "samples of S5",
                    FrameCounts::rounds,
                    Data.TILE,
                    24,
                    1024,
                    0,
                    "64 rounds of 32 of 32 bits"),
            new Work(
                    Stage.SHADE,
                    "lit samples",
                    FrameCounts::lit,
                    Data.TILE,
                    36,
                    17.5,
                    1,
                    "reads 6 floats, writes 3; 35 of 32 bits: 8 for the unit normal, 12 for each of 2 lights, 3 for the "
                            + "product; its root and division, of 32 bits"),
            new Work(
                    Stage.ENCODE,
                    "interpolated samples",
                    FrameCounts::mixed,
                    Data.TILE,
                    12,
                    15,
                    0,
                    "reads 3 floats; 30 of 32 bits: 8 a component with its table, 6 to join them"),
            new Work(
                    Stage.ENCODE,
                    "interpolated samples, written",
                    FrameCounts::mixed,
                    Data.ROWS,
                    4,
                    0,
                    0,
                    "writes a colour"));
}
