package dev.lazyz.conformance.cases

import dev.lazyz.Raster
import dev.lazyz.Rgba
import org.joml.Vector3dc

/** A value and its Kotlin expression. */
internal class Coded<out T>(val value: T, val code: String)

/** Returns [value] as a Kotlin expression. */
internal fun code(value: Double): String = when {
    value.isNaN() -> "Double.NaN"
    value.isInfinite() -> if (value > 0) "Double.POSITIVE_INFINITY" else "Double.NEGATIVE_INFINITY"
    else -> value.toString()
}

/** Returns [value] as a Kotlin expression. */
internal fun code(value: Float): String = when {
    value.isNaN() -> "Float.NaN"
    value.isInfinite() -> if (value > 0) "Float.POSITIVE_INFINITY" else "Float.NEGATIVE_INFINITY"
    else -> "${value}f"
}

/** Returns [values] as a Kotlin expression. */
internal fun code(values: FloatArray): String = values.joinToString(prefix = "floatArrayOf(", postfix = ")") {
    code(it)
}

/** Returns [v] as a Kotlin expression. */
internal fun code(v: Vector3dc): String = "Vector3d(${code(v.x())}, ${code(v.y())}, ${code(v.z())})"

/** Returns [value] as a Kotlin expression. */
internal fun code(value: Long): String = if (value == Long.MIN_VALUE) "Long.MIN_VALUE" else "${value}L"

/** Returns [color] as a Kotlin expression. Its components must be finite. */
internal fun code(color: Rgba): String = when (color) {
    Rgba.WHITE -> "Rgba.WHITE"
    else -> "Rgba(${color.red}f, ${color.green}f, ${color.blue}f, ${color.alpha}f)"
}

/** Returns [raster] as a Kotlin expression. */
internal fun code(raster: Raster): String = "Raster(${raster.width}, ${raster.height}, ${code(raster.background)}, " +
    "DepthConvention.${raster.convention}, DepthTest.${raster.depthTest}, ${raster.backgroundDepth})"
