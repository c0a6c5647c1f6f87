package dev.lazyz.conformance.frames.world

import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/**
 * The attributes of a mesh's vertices other than positions; null for none.
 *
 * Most consist of a few values that repeat along the vertices. A single value is the same at all vertices.
 */
internal class WorldAttributes(
    private val normals: Pattern?,
    private val uvs: Pattern?,
    private val colors: Pattern?,
    private val uvs2: Pattern?,
    private val tangents: Pattern?,
) {
    fun normals(positions: FloatArray): FloatArray? = normals?.of(positions, 3)

    fun uvs(positions: FloatArray): FloatArray? = uvs?.of(positions, 2)

    fun colors(positions: FloatArray): FloatArray? = colors?.of(positions, 4)

    fun uvs2(positions: FloatArray): FloatArray? = uvs2?.of(positions, 2)

    fun tangents(positions: FloatArray): FloatArray? = tangents?.of(positions, 4)

    /** Determines the values of each vertex. */
    fun interface Pattern {
        fun at(vertex: Int, positions: FloatArray, part: Int): Float

        fun of(positions: FloatArray, size: Int): FloatArray =
            FloatArray(positions.size / 3 * size) { at(it / size, positions, it % size) }
    }

    companion object {
        fun any(): Arbitrary<WorldAttributes> = Combinators
            .combine(maybe(1, 2, normals()), maybe(1, 5, uvs()), maybe(1, 2, colors()), seldom())
            .`as` { normals, uvs, colors, (uvs2, tangents) ->
                WorldAttributes(normals.first, uvs.first, colors.first, uvs2.first, tangents.first)
            }

        /**
         * Generates normals that are equal or nearly equal at all vertices. Half of them point away from the viewer.
         * Half of the meshes also have what a normal map needs.
         */
        fun withNormals(): Arbitrary<WorldAttributes> {
            val same = mixed(3 to cycle(directions, 1), 1 to normals())
            val places = Combinators.combine(uvs(), tangents()).`as`(::Pair)
            return Combinators.combine(same, maybe(1, 1, colors()), places, ints(0, 1))
                .`as` { normals, colors, (uvs, tangents), isMapped ->
                    if (isMapped == 0) {
                        WorldAttributes(normals, null, colors.first, null, null)
                    } else {
                        WorldAttributes(normals, uvs, colors.first, null, tangents)
                    }
                }
        }

        /** Generates second texture coordinates for half of the meshes, and tangents for two of five. */
        private fun seldom(): Arbitrary<Pair<Maybe, Maybe>> =
            Combinators.combine(maybe(1, 1, uvs()), maybe(3, 2, tangents())).`as`(::Pair)

        /**
         * Generates normals of any direction, including opposite and zero ones, or normals that point away from or
         * towards the origin.
         */
        private fun normals(): Arbitrary<Pattern> {
            val radial = oneOf(1f, -1f, 3f).map { factor ->
                Pattern { vertex, p, part -> factor * p[3 * vertex + part] }
            }
            return mixed(3 to cycle(directions, 4), 1 to radial)
        }

        private val directions: Arbitrary<FloatArray> = mixed(
            1 to ints(0, 1).map { floatArrayOf(0f, 0f, if (it == 0) 1f else -1f) },
            3 to Combinators.combine(ints(-2, 2), ints(-2, 2), ints(-2, 2))
                .`as` { x, y, z -> floatArrayOf(x.toFloat(), y.toFloat(), z / 2f) },
        )

        /** Generates a few arbitrary coordinates, rarely far outside; or scaled x and y. */
        private fun uvs(): Arbitrary<Pattern> {
            val near = Combinators.combine(ints(-6, 6), ints(-6, 6)).`as` { u, v -> floatArrayOf(u / 4f, v / 4f) }
            val far = Combinators.combine(ints(-99, 99), ints(-9999, 9999)).`as` { u, v ->
                floatArrayOf(u + 0.5f, v / 8f)
            }
            val flat = oneOf(0.5f, 1f, 3f, 40f).map { scale ->
                Pattern { vertex, p, part -> (p[3 * vertex + part] + if (part == 0) 0.25f else -1f) * scale }
            }
            return mixed(2 to cycle(mixed(8 to near, 1 to far), 4), 3 to flat)
        }

        private fun colors(): Arbitrary<Pattern> =
            cycle(WorldMaterials.colors.map { floatArrayOf(it.red, it.green, it.blue, it.alpha) }, 4)

        /** Generates tangents of any direction, including zero ones, with either sign of the bitangent. */
        private fun tangents(): Arbitrary<Pattern> {
            val any = Combinators.combine(directions, oneOf(1f, -1f)).`as` { (x, y, z), sign ->
                floatArrayOf(x, y, z, sign)
            }
            val right = floatArrayOf(1f, 0f, 0f, 1f)
            return mixed(1 to Arbitraries.just(Pattern { _, _, part -> right[part] }), 2 to cycle(any, 3))
        }

        private fun cycle(values: Arbitrary<FloatArray>, most: Int): Arbitrary<Pattern> =
            values.list().ofMinSize(1).ofMaxSize(most).map { list ->
                Pattern { vertex, _, part -> list[vertex % list.size][part] }
            }

        /** Generates null or a pattern, with these weights. */
        private fun maybe(none: Int, some: Int, patterns: Arbitrary<Pattern>): Arbitrary<Maybe> =
            mixed(none to Arbitraries.just(Maybe(null)), some to patterns.map(::Maybe))

        private class Maybe(val first: Pattern?)
    }
}
