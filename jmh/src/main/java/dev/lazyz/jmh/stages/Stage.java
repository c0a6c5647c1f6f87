package dev.lazyz.jmh.stages;

import java.util.Locale;

/** The parts of one frame of the renderer {@code tiled}, in the order in which a triangle passes through them. */
enum Stage {
    /** Vertices from world space to clip space, and the test whether they are inside all planes. */
    TRANSFORM("positions to clip space, and the test for clipping"),

    /** Vertices from clip space to the grid of the raster. */
    SNAP("division by w, rounding to the grid; 1/w"),

    /** Triangles into the bins of the tiles that they reach, and the order of drawing. */
    BIN("bounds of triangles, entries and fragments of tiles, counting sorts"),

    /** The equations of a triangle: edges, depth, vertex data for interpolation; waiting for its vertices. */
    SET_UP("vertices, bounds, edge functions, depth plane and colours of a triangle in a tile"),

    /** Which samples a triangle covers, and which of them it wins: coarse raster and fine raster. */
    COVER("coarse raster, fine raster, comparison of keys; clearing keys"),

    /** From keys to depths, primitive numbers and runs of one primitive; background. */
    RESOLVE("runs of one primitive; depths, primitive numbers, background"),

    /** Weights and attributes of visible samples. */
    INTERPOLATE("weights and attributes of visible samples"),

    /** Colours from attributes. */
    SHADE("the shader"),

    /** Colours to sRGB, and into the rows. */
    ENCODE("linear light to sRGB, 8 bits a channel, into the rows"),

    /** Rows to the sink. */
    HAND_OUT("rows to the sink, which drops them"),

    /** Everything else. */
    OTHER("schedule, new objects, what belongs to no other stage");

    /** What happens in the stage, for tables. */
    final String content;

    Stage(String content) {
        this.content = content;
    }

    /** Name in tables and in files of results. */
    String label() {
        return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }

    /** Returns the stage with this label. */
    static Stage ofLabel(String label) {
        return valueOf(label.toUpperCase(Locale.ROOT).replace(' ', '_'));
    }
}
