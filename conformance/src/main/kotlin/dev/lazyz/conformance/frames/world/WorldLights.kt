package dev.lazyz.conformance.frames.world

import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.Hollows
import dev.lazyz.conformance.cases.Skies
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.world.Scene
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import org.joml.Vector3d

/** Generates lights: none, which means [Light.studio]; only ambient light; one or several of any kind. */
internal object WorldLights {
    /** Generates at most four lights. Shrinks to none, which means [Light.studio]. */
    fun any(): Arbitrary<List<Coded<Light>>> = mixed(
        1 to Arbitraries.just(emptyList()),
        4 to mixed(2 to ambient(), 3 to directional(), 4 to point(), 2 to spot()).list().ofMinSize(1).ofMaxSize(4),
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

    private fun point(): Arbitrary<Coded<Light>> =
        Combinators.combine(ints(0, 124), WorldMaterials.colors, falloffs()).`as` { number, color, falloff ->
            val position = lattice(number).mul(1.5)
            val light = seen(color, falloff)
            Coded(
                Light.Point(position, light, falloff),
                listOfNotNull(code(position), code(light), code(falloff)).joinToString(", ", "Light.Point(", ")"),
            )
        }

    /** Generates spots that are directed at the surfaces: narrow and wide, with sharp and soft edges. */
    private fun spot(): Arbitrary<Coded<Light>> {
        val angles = oneOf(20.0 to 45.0, 0.0 to 30.0, 15.0 to 15.1, 60.0 to 90.0)
        return Combinators.combine(ints(0, 124), ints(0, 124), WorldMaterials.colors, angles, falloffs())
            .`as` { from, to, color, (inner, outer), falloff ->
                // A spot at its target has no direction
                val position = lattice(from).mul(1.5)
                val target = lattice(to).mul(0.25)
                val direction = if (position == target) Vector3d(0.0, 0.0, -1.0) else target.sub(position)
                val light = seen(color, falloff)
                val words = listOfNotNull(
                    code(position), code(direction), code(light), code(inner), code(outer), code(falloff),
                )
                Coded(
                    Light.Spot(position, direction, light, inner, outer, falloff),
                    words.joinToString(", ", "Light.Spot(", ")"),
                )
            }
    }

    /** Generates falloffs: mostly none, otherwise with and without a range that ends among the surfaces. */
    private fun falloffs(): Arbitrary<Falloff> = mixed(
        2 to Arbitraries.just(Falloff.NONE),
        1 to oneOf(Falloff.inverseSquare(), Falloff.inverseSquare(3.5), Falloff.inverseSquare(6.0)),
    )

    /** Returns a colour that is bright enough to be seen at the surfaces. */
    private fun seen(color: Rgba, falloff: Falloff): Rgba = if (falloff.isInverseSquare) color.scaled(8f) else color

    private fun code(falloff: Falloff): String? = when {
        !falloff.isInverseSquare -> null
        falloff.range.isInfinite() -> "Falloff.inverseSquare()"
        else -> "Falloff.inverseSquare(${code(falloff.range)})"
    }

    /** Returns one of the 125 points with integer coordinates from -2 to 2. */
    private fun lattice(number: Int): Vector3d = Vector3d(number % 5 - 2.0, number / 5 % 5 - 2.0, number / 25 - 2.0)
}

/** A change of a scene. Its code is a call of member functions of the scene, or empty. */
internal typealias SceneChange = Coded<(Scene) -> Scene>

/**
 * Generates what scenes have besides surfaces, lights and a camera: the environment, the intensity of all light, the
 * visibility of ambient light, exposure and tone curves.
 */
internal object WorldExposure {
    private val same = SceneChange({ it }, "")

    /** Mostly without tone mapping, so that most colours are finished when light has been added up. */
    fun any(): Arbitrary<SceneChange> =
        Combinators.combine(environments(), toneMappings(), intensities(), visibilities())
            .`as` { first, second, third, fourth ->
                val all = listOf(first, second, third, fourth)
                SceneChange(
                    { scene -> all.fold(scene) { changed, change -> change.value(changed) } },
                    all.joinToString("") { it.code },
                )
            }

    private fun environments(): Arbitrary<SceneChange> =
        mixed(3 to Arbitraries.just(same), 1 to oneOf(*ENVIRONMENTS))

    private fun studio(intensity: Float) = SceneChange(
        { it.withEnvironment(Environment.studio(intensity)) },
        "\n    .withEnvironment(Environment.studio(${code(intensity)}))",
    )

    private fun sky(number: Int, intensity: Float, rotation: Double) = SceneChange(
        { it.withEnvironment(Environment.of(Skies.map(number), intensity, rotation)) },
        "\n    .withEnvironment(Environment.of(Skies.map($number), ${code(intensity)}, ${code(rotation)}))",
    )

    private val ENVIRONMENTS = arrayOf(studio(1f), studio(0.25f), studio(0f)) +
        Array(Skies.COUNT) { sky(it, if (it == 0) 0.5f else 1f, 75.0 * it) }

    /** Generates intensities that are mostly 1. Others are both weaker and stronger. */
    private fun intensities(): Arbitrary<SceneChange> = mixed(
        3 to Arbitraries.just(same),
        1 to oneOf(2f, 0.5f, 3f).map { intensity ->
            SceneChange({ it.withLightIntensity(intensity) }, "\n    .withLightIntensity(${code(intensity)})")
        },
    )

    private fun visibilities(): Arbitrary<SceneChange> = mixed(
        3 to Arbitraries.just(same),
        1 to ints(0, 63).map { seed ->
            val hollows = Hollows(seed)
            SceneChange({ it.withAmbientVisibility(hollows) }, "\n    .withAmbientVisibility($hollows)")
        },
    )

    private fun toneMappings(): Arbitrary<SceneChange> {
        val mappings = mixed(
            4 to Arbitraries.just(ToneMapping.NONE),
            2 to Combinators.combine(oneOf(*ToneMapping.Curve.values()), oneOf(0.0, 1.0, -0.5)).`as`(::ToneMapping),
        )
        val changes = mappings.map { mapping ->
            SceneChange(
                { it.withToneMapping(mapping) },
                "\n    .withToneMapping(ToneMapping(ToneMapping.Curve.${mapping.curve}, ${code(mapping.exposure)}))",
            )
        }
        return mixed(2 to Arbitraries.just(same), 5 to changes)
    }
}
