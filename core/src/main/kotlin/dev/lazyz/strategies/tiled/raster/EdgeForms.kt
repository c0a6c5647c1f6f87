package dev.lazyz.strategies.tiled.raster

/**
 * The three edge functions of a triangle, as linear forms: values at an origin sample, and steps by column and row.
 *
 * These are fields, not properties, because the innermost loops read them.
 */
internal abstract class EdgeForms {
    @JvmField var e0: Long = 0L

    @JvmField var e1: Long = 0L

    @JvmField var e2: Long = 0L

    @JvmField var e0dx: Long = 0L

    @JvmField var e1dx: Long = 0L

    @JvmField var e2dx: Long = 0L

    @JvmField var e0dy: Long = 0L

    @JvmField var e1dy: Long = 0L

    @JvmField var e2dy: Long = 0L
}
