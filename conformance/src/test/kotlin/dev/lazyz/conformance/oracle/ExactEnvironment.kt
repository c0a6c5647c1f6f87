package dev.lazyz.conformance.oracle

import dev.lazyz.conformance.mutants.wrappers.Inside
import dev.lazyz.world.light.Environment
import org.joml.Vector3d

/**
 * The light of surroundings as contract rules 6.10, 6.13 and 6.17 define it, in double precision: an oracle for the
 * library's own. What is computed once, the blurred pictures and the albedos, is taken from the library: other tests
 * compare it with integrals.
 *
 * @param intensity factor of all light
 */
internal class ExactEnvironment(environment: Environment, intensity: Double) {
    private val factor = environment.intensity * intensity
    private val angle = Math.toRadians(environment.rotation)
    private val map = checkNotNull(environment.map)
    private val levels = (Inside.read(map, "levels") as Array<*>).map { Inside.read(it!!, "numbers") as FloatArray }
    private val harmonics = (Inside.read(map, "irradiance")!!.let { Inside.read(it, "coefficients") } as Array<*>)
        .map { it as FloatArray }

    /** Returns the light around the unit vector [d], blurred by [roughness]. */
    fun radiance(d: Vector3d, roughness: Double): DoubleArray {
        val l = local(d)
        val sum = Math.abs(l.x) + Math.abs(l.y) + Math.abs(l.z)
        val outer = l.y < 0
        val p = if (outer) Math.copySign(1 - Math.abs(l.z) / sum, l.x) else l.x / sum
        val q = if (outer) Math.copySign(1 - Math.abs(l.x) / sum, l.z) else l.z / sum
        val finest = 3.5 / 39.5
        val place = if (roughness < finest) roughness / finest else (43 * roughness - 2.5) / (1 + 3.5 * roughness)
        val first = minOf(Math.floor(place).toInt(), levels.size - 2)
        val (a, b) = read(levels[first], p, q) to read(levels[first + 1], p, q)
        return DoubleArray(3) { factor * (a[it] + (b[it] - a[it]) * (place - first)) }
    }

    private fun read(level: FloatArray, p: Double, q: Double): DoubleArray {
        val stride = Math.sqrt(level.size / 3.0).toInt()
        val x = (p + 1) / 2 * (stride - 2) + 0.5
        val y = (q + 1) / 2 * (stride - 2) + 0.5
        val (i, j) = Math.floor(x).toInt() to Math.floor(y).toInt()
        return DoubleArray(3) { k ->
            var sum = 0.0
            for ((di, wi) in listOf(0 to 1 - (x - i), 1 to x - i)) {
                for ((dj, wj) in listOf(0 to 1 - (y - j), 1 to y - j)) {
                    sum += wi * wj * level[3 * ((j + dj) * stride + i + di) + k]
                }
            }
            sum
        }
    }

    /** Returns the light that a matt surface with the unit normal [n] receives. */
    fun irradiance(n: Vector3d): DoubleArray {
        val (x, y, z) = local(n).let { Triple(it.x, it.y, it.z) }
        val basis = listOf(1.0, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y)
        return DoubleArray(3) { k -> factor * maxOf(0.0, basis.indices.sumOf { harmonics[k][it] * basis[it] }) }
    }

    private fun local(d: Vector3d) = Vector3d(
        Math.cos(angle) * d.x - Math.sin(angle) * d.z, d.y, Math.sin(angle) * d.x + Math.cos(angle) * d.z,
    )

    /**
     * Returns what a surface reflects.
     *
     * @param f0 reflectance at normal incidence, for each colour
     * @param diffuse colour of diffuse reflection
     * @param f90 reflectance at grazing incidence
     * @param r the direction that is mirrored, and [cosine] that between the normal [n] and the viewer
     * @param open the part of the light that reaches the point
     */
    fun reflected(
        f0: DoubleArray,
        diffuse: DoubleArray,
        f90: Double,
        roughness: Double,
        n: Vector3d,
        r: Vector3d,
        cosine: Double,
        open: Double,
    ): DoubleArray {
        val (scale, bias) = ALBEDOS.map { bilinear(it, minOf(1.0, cosine), roughness) }
        val (radiance, irradiance) = radiance(r, roughness) to irradiance(n)
        return DoubleArray(3) { k ->
            val once = f0[k] * scale + f90 * bias
            val mean = minOf(1.0, f0[k] + (f90 - f0[k]) / 21)
            val lost = 1 - scale - bias
            val more = lost * once * mean / (1 - mean * lost)
            val d = diffuse[k]
            val (a, b, c) = Triple(2.0404 * d - 0.3324, 0.6417 - 4.7951 * d, 2.7552 * d + 0.6903)
            val inHollow = if (open == 1.0) 1.0 else maxOf(open, ((open * a + b) * open + c) * open)
            once * open * radiance[k] + (more + d * maxOf(0.0, 1 - once - more)) * inHollow * irradiance[k]
        }
    }

    private companion object {
        /** The tables of scale and bias by cosine and roughness. */
        val ALBEDOS: List<FloatArray> = listOf("scales", "biases").map { name ->
            val field = Class.forName("dev.lazyz.shading.pbr.DirectionalAlbedo").getDeclaredField(name)
            field.isAccessible = true
            Inside.read(field.get(null), "numbers") as FloatArray
        }

        fun bilinear(table: FloatArray, first: Double, second: Double): Double {
            val size = Math.sqrt(table.size.toDouble()).toInt()
            val (x, y) = first * (size - 1) to second * (size - 1)
            val (i, j) = minOf(x.toInt(), size - 2) to minOf(y.toInt(), size - 2)
            fun row(at: Int) = table[at * size + i] + (table[at * size + i + 1] - table[at * size + i]) * (x - i)
            return row(j) + (row(j + 1) - row(j)) * (y - j)
        }
    }
}
