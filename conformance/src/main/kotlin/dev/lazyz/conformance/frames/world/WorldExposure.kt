package dev.lazyz.conformance.frames.world

import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.Hollows
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.world.Environment
import dev.lazyz.world.Scene
import dev.lazyz.world.ToneMapping
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

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
        mixed(3 to Arbitraries.just(same), 1 to oneOf(1f, 0.25f, 0f).map(::studio))

    private fun studio(intensity: Float) = SceneChange(
        { it.withEnvironment(Environment.studio(intensity)) },
        "\n    .withEnvironment(Environment.studio(${code(intensity)}))",
    )

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
