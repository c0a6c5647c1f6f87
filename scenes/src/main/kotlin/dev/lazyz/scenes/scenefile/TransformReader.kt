package dev.lazyz.scenes.scenefile

import dev.lazyz.geometry.Transforms
import dev.lazyz.scenes.json.JsonNode
import org.joml.Matrix4d

/**
 * Reads a list of transforms and multiplies them.
 *
 * Uses only explicit products and sums and [StrictMath], because the numbers must be the same on every machine.
 * JOML's rotations and products do not guarantee that.
 */
internal object TransformReader {
    /** Returns the matrix that applies the transforms of [node], the first one first. */
    fun read(node: JsonNode): Matrix4d =
        node.items().fold(Matrix4d()) { before, step -> Transforms.product(step(step), before) }

    private fun step(node: JsonNode): Matrix4d {
        val members = node.members("translate", "rotate", "scale", "matrix")
        val (kind, value) = members.one("translate", "rotate", "scale", "matrix")
        val matrix = when (kind) {
            "translate" -> translation(value.doubles(3))
            "rotate" -> rotation(value)
            "scale" -> scale(value)
            else -> matrix(value)
        }
        if (!matrix.isFinite) value.fail("must be finite")
        return matrix
    }

    private fun translation(by: DoubleArray): Matrix4d = rows(
        doubleArrayOf(1.0, 0.0, 0.0, by[0]),
        doubleArrayOf(0.0, 1.0, 0.0, by[1]),
        doubleArrayOf(0.0, 0.0, 1.0, by[2]),
    )

    private fun scale(node: JsonNode): Matrix4d {
        val by = if (node.isList) node.doubles(3) else node.double().let { doubleArrayOf(it, it, it) }
        if (by.any { it == 0.0 }) node.fail("must not be 0", "scale by a small number to flatten")
        return rows(
            doubleArrayOf(by[0], 0.0, 0.0, 0.0),
            doubleArrayOf(0.0, by[1], 0.0, 0.0),
            doubleArrayOf(0.0, 0.0, by[2], 0.0),
        )
    }

    /** Returns a rotation matrix by Rodrigues' formula. */
    private fun rotation(node: JsonNode): Matrix4d {
        val members = node.members("axis", "degrees")
        val axisNode = members.required("axis")
        val axis = axisNode.doubles(3)
        val length = StrictMath.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2])
        if (!(length > 0.0 && length.isFinite())) axisNode.fail("must be finite and not zero")
        val x = axis[0] / length
        val y = axis[1] / length
        val z = axis[2] / length
        val degreesNode = members.required("degrees")
        val degrees = degreesNode.double()
        if (!degrees.isFinite()) degreesNode.fail("must be finite")
        val (c, s) = cosineAndSine(degrees)
        val d = 1.0 - c
        return rows(
            doubleArrayOf(c + x * x * d, x * y * d - z * s, x * z * d + y * s, 0.0),
            doubleArrayOf(y * x * d + z * s, c + y * y * d, y * z * d - x * s, 0.0),
            doubleArrayOf(z * x * d - y * s, z * y * d + x * s, c + z * z * d, 0.0),
        )
    }

    /** Returns cosine and sine; exact for quarter turns. */
    private fun cosineAndSine(degrees: Double): Pair<Double, Double> = when (degrees % 360.0) {
        0.0 -> 1.0 to 0.0
        90.0, -270.0 -> 0.0 to 1.0
        180.0, -180.0 -> -1.0 to 0.0
        270.0, -90.0 -> 0.0 to -1.0
        else -> {
            val angle = degrees % 360.0 * (StrictMath.PI / 180.0)
            StrictMath.cos(angle) to StrictMath.sin(angle)
        }
    }

    private fun matrix(node: JsonNode): Matrix4d {
        val rows = node.items()
        if (rows.size != 4) node.fail("needs 4 rows, not ${rows.size}")
        val numbers = rows.map { it.doubles(4) }
        val last = numbers[3]
        if (last[0] != 0.0 || last[1] != 0.0 || last[2] != 0.0 || last[3] != 1.0) {
            rows[3].fail("must be [0, 0, 0, 1]", "move surfaces by affine matrices only; perspective is the camera's")
        }
        return rows(numbers[0], numbers[1], numbers[2])
    }

    private fun rows(x: DoubleArray, y: DoubleArray, z: DoubleArray): Matrix4d = Matrix4d(
        x[0], y[0], z[0], 0.0,
        x[1], y[1], z[1], 0.0,
        x[2], y[2], z[2], 0.0,
        x[3], y[3], z[3], 1.0,
    )
}
