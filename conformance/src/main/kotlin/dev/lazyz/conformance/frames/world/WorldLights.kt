package dev.lazyz.conformance.frames.world

import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.world.Light
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import org.joml.Vector3d

/** Generates lights: none, which means [Light.studio]; only ambient light; one or several of any kind. */
internal object WorldLights {
    /** Generates at most four lights. Shrinks to none, which means [Light.studio]. */
    fun any(): Arbitrary<List<Coded<Light>>> = mixed(
        1 to Arbitraries.just(emptyList()),
        4 to mixed(2 to ambient(), 3 to directional(), 4 to point()).list().ofMinSize(1).ofMaxSize(4),
    )

    /**
     * Generates one light from a direction or a point, for which the direction of normals matters, and possibly an
     * ambient one.
     */
    fun directed(): Arbitrary<List<Coded<Light>>> =
        Combinators.combine(mixed(1 to directional(), 1 to point()), ambient().list().ofMaxSize(1))
            .`as` { light, others -> listOf(light) + others }

    private fun ambient(): Arbitrary<Coded<Light>> = WorldMaterials.colors.map {
        val color = it.scaled(0.25f).withAlpha(1f)
        Coded(Light.Ambient(color), "Light.Ambient(${code(color)})")
    }

    private fun directional(): Arbitrary<Coded<Light>> = Combinators.combine(ints(0, 124), WorldMaterials.colors)
        .`as` { number, color ->
            // The centre of the cube is not a direction
            val direction = lattice(if (number == 62) 0 else number)
            Coded(Light.Directional(direction, color), "Light.Directional(${code(direction)}, ${code(color)})")
        }

    private fun point(): Arbitrary<Coded<Light>> = Combinators.combine(ints(0, 124), WorldMaterials.colors)
        .`as` { number, color ->
            val position = lattice(number).mul(1.5)
            Coded(Light.Point(position, color), "Light.Point(${code(position)}, ${code(color)})")
        }

    /** Returns one of the 125 points with integer coordinates from -2 to 2. */
    private fun lattice(number: Int): Vector3d =
        Vector3d(number % 5 - 2.0, number / 5 % 5 - 2.0, number / 25 - 2.0)
}
