package dev.lazyz.jmh.growth;

import dev.lazyz.Rgba;
import dev.lazyz.jmh.workload.Growing;
import dev.lazyz.jmh.workload.RoundsShader;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.world.Scene;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.material.Material.Shading;
import java.util.Arrays;
import java.util.Locale;
import java.util.stream.LongStream;

/** A quantity that grows while all others are constant. Each axis is one chart. */
enum GrowthAxis {
    /** Random triangles that together cover each sample four times, for any number of triangles. */
    TRIANGLES("triangles", 512, 1_000, 10_000, 100_000, 1_000_000, 10_000_000),

    /** Samples of the raster; 10,000 triangles, depth complexity 4. */
    PIXELS("pixels", 0, squares(256, 512, 1024, 2048, 4096, 8192, 16_384)),

    /** Samples of a small raster; 12 triangles, depth complexity 1. */
    SMALL("pixels of a small picture", 0, squares(8, 16, 32, 64, 128, 256)),

    /** Layers that fill the raster, in random order. */
    DEPTH("depth complexity", 512, 1, 3, 10, 30, 100, 300, 1_000),

    /** Rounds of a shader; 10,000 triangles, depth complexity 4. */
    SHADING("rounds of shading", 256, 1, 3, 10, 30, 100, 300, 1_000),

    /** Threads; 100,000 triangles, depth complexity 4. */
    THREADS("threads", 1024, 1, 2, 3, 8),

    /** Built-in scenes by number. Nothing grows, and the model was not fitted to them. */
    SCENES("scene", 512, 0, 1, 2, 3, 4, 5, 6, 7);

    private static final double DEPTH_COMPLEXITY = 4;

    /** Name of the quantity, for tables and charts. */
    final String title;

    /** Values in ascending order. */
    final long[] values;

    /** Width and height of the raster, or 0 if the raster grows. */
    private final int fixedSide;

    GrowthAxis(String title, int side, long... values) {
        this.title = title;
        this.fixedSide = side;
        this.values = values;
    }

    private static long[] squares(long... sides) {
        return Arrays.stream(sides).map(side -> side * side).toArray();
    }

    /** Returns the axis called {@code name} on the command line. */
    static GrowthAxis find(String name) {
        return valueOf(name.toUpperCase(Locale.ROOT));
    }

    /** Name in files and on the command line. */
    String id() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Width and height of the raster, samples. */
    int side(long value) {
        return fixedSide == 0 ? (int) Math.round(Math.sqrt(value)) : fixedSide;
    }

    /** Threads of the renderer. */
    int threads(long value) {
        return this == THREADS ? (int) value : 1;
    }

    /** Rounds of shading per sample; 0 means only interpolation. */
    int rounds(long value) {
        return this == SHADING ? (int) value : 0;
    }

    /** Creates the scene for a value. */
    Scene scene(long value) {
        return switch (this) {
            case TRIANGLES -> Growing.confetti((int) value, DEPTH_COMPLEXITY).scene();
            case PIXELS -> Growing.confetti(10_000, DEPTH_COMPLEXITY).scene();
            case SMALL -> Growing.confetti(12, 1).scene();
            case DEPTH -> Growing.layers((int) value).scene();
            case SHADING -> Growing.confetti(10_000, DEPTH_COMPLEXITY).scene(rounds((int) value));
            case THREADS -> Growing.confetti(100_000, DEPTH_COMPLEXITY).scene();
            case SCENES -> Workloads.scene(Scenes.getBuiltins().get((int) value).getId());
        };
    }

    private static Material rounds(int rounds) {
        return new Material(Rgba.WHITE).withShading(Shading.CONSTANT).withShader(new RoundsShader(rounds));
    }

    /** Returns the subject of measurements at a value: {@code depth 1000}. */
    String subject(long value) {
        return id() + " "
                + (this == SCENES ? Scenes.getBuiltins().get((int) value).getId() : value);
    }

    /** Returns at most the first {@code count} values. */
    LongStream first(int count) {
        return Arrays.stream(values).limit(count);
    }
}
