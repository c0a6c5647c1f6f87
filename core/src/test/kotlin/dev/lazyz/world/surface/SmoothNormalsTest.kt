package dev.lazyz.world.surface

import java.util.Random
import kotlin.math.sqrt
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/**
 * [Mesh.withSmoothNormals] compared with a reference implementation that examines all other corners for each corner.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class SmoothNormalsTest {
    @Test
    fun normalsAreThoseOfThePlainTwinToTheBit() {
        for (seed in 1L..20L) {
            val random = Random(seed)
            val mesh = mesh(random)
            for (angle in listOf(0.0, 1e-7, 0.5, 30.0, 45.0, 120.0, 180.0)) {
                val smooth = mesh.withSmoothNormals(angle)
                for (corner in mesh.triangles.indices) {
                    val expected = normal(mesh, corner, StrictMath.cos(angle * (StrictMath.PI / 180.0)))
                    val vertex = smooth.triangles[corner]
                    val actual = List(3) { smooth.normals!![3 * vertex + it] }
                    assertEquals(expected.map { it.toBits() }, actual.map { it.toBits() }) { "$seed, $angle, $corner" }
                }
            }
        }
    }

    /**
     * Few positions, so that many corners meet; flat, slightly bent or random; some as small or large as floats can be.
     */
    private fun mesh(random: Random): Mesh {
        val height = listOf(0.0, 1e-7, 0.1, 1.0, 3.0)[random.nextInt(5)]
        val scale = listOf(1e-38, 1e-20, 1.0, 1.0, 1e30)[random.nextInt(5)]
        val positions = FloatArray(3 * 30) {
            val coordinate = if (it % 3 == 2) height * random.nextDouble() else random.nextInt(4) - 2.0
            (coordinate * scale).toFloat()
        }
        if (random.nextInt(10) == 0) positions[4] = Float.NaN
        return Mesh(positions, IntArray(3 * 60) { random.nextInt(30) })
    }

    private fun normal(mesh: Mesh, corner: Int, cosine: Double): List<Float> {
        val face = faceNormal(mesh, corner / 3)
        val sum = DoubleArray(3)
        for (other in mesh.triangles.indices) {
            if (position(mesh, other) != position(mesh, corner)) continue
            val otherFace = faceNormal(mesh, other / 3)
            val isCrease = dot(face, otherFace) <= cosine * length(face) * length(otherFace)
            if (other / 3 == corner / 3 || !isCrease) for (k in 0 until 3) sum[k] += otherFace[k]
        }
        val length = length(sum)
        val scale = if (length > 0.0 && length.isFinite()) 1.0 / length else 0.0
        return sum.map { (it * scale).toFloat() }
    }

    private fun position(mesh: Mesh, corner: Int) = List(3) { mesh.positions[3 * mesh.triangles[corner] + it] + 0f }

    private fun faceNormal(mesh: Mesh, face: Int): DoubleArray {
        val (a, b, c) = List(3) { k -> List(3) { mesh.positions[3 * mesh.triangles[3 * face + k] + it].toDouble() } }
        val u = List(3) { b[it] - a[it] }
        val v = List(3) { c[it] - a[it] }
        val normal = DoubleArray(3) { u[(it + 1) % 3] * v[(it + 2) % 3] - u[(it + 2) % 3] * v[(it + 1) % 3] }
        return if (normal.all { it.isFinite() }) normal else DoubleArray(3)
    }

    private fun dot(a: DoubleArray, b: DoubleArray) = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

    private fun length(a: DoubleArray) = sqrt(dot(a, a))
}
