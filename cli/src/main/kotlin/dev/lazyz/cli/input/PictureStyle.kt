package dev.lazyz.cli.input

import dev.lazyz.world.Fit

/**
 * Styles of whole pictures: defaults for several options.
 *
 * @property projection the projection, or null for the usual one
 * @property margin free part of the picture on each side, percent, or null for the usual one
 */
internal enum class PictureStyle(val projection: Fit?, val margin: Double?) {
    /** A drawing in a manual. */
    TECHNICAL(Fit.ORTHOGRAPHIC, null),

    /** A product in a shop, standing on white ground; the margin leaves room for the shadow. */
    PRODUCT(null, 12.0),
}
