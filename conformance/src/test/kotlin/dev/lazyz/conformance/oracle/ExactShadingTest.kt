package dev.lazyz.conformance.oracle

import dev.lazyz.Frame
import dev.lazyz.conformance.TestEffort
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Skies
import dev.lazyz.conformance.frames.some
import dev.lazyz.conformance.frames.world.WorldFrames
import dev.lazyz.conformance.mutants.wrappers.Changes
import dev.lazyz.conformance.mutants.wrappers.Inside
import dev.lazyz.conformance.mutants.wrappers.LightChanges
import dev.lazyz.conformance.mutants.wrappers.MapChanges
import dev.lazyz.conformance.mutants.wrappers.ShadingMistakes
import dev.lazyz.shared.NotByDefault
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import net.jqwik.api.Arbitrary
import net.jqwik.api.Example
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue

/** Compares set-up, light and textures of a scene with the contract in double precision. */
class ExactShadingTest {
    private val kinds = listOf(
        WorldFrames.cases(WorldFrames.rasters(24), 4),
        WorldFrames.blended(WorldFrames.rasters(24), 4),
        WorldFrames.turned(WorldFrames.rasters(24)),
    )

    @Example
    @AddLifecycleHook(NotByDefault::class)
    fun rule_6_5_coloursAreExact() {
        val comparison = Comparison()
        for (case in kinds.flatMap { known(it, 20) }) {
            assertNull(comparison.fault(case, exact(case))) { "in\n$case" }
        }
        assertTrue(comparison.judged > 0.9 * comparison.samples) { "$comparison" }
        assertTrue(comparison.exact > 0.99 * comparison.judged) { "$comparison" }
    }

    /** Each mistake in the library's shading would be noticed. Takes long, so not by default. */
    @Example
    fun rule_6_5_mistakesAreFound() {
        if (TestEffort.isDefault) return
        val cases = kinds.flatMap { known(it, 60) }
        val exact = cases.associateWith { exact(it) }
        val mistakes = mapOf<String, (Inside, Changes) -> Unit>(
            "highlights" to Inside.Companion::loseHighlight,
            "emission" to Inside.Companion::loseEmission,
            "normals" to Inside.Companion::turnNormals,
            "filter" to Inside.Companion::readNearest,
            "perspective" to Inside.Companion::interpolateOnScreen,
            "cones" to LightChanges::loseCones,
            "falloff" to LightChanges::loseFalloff,
            "tone mapping" to MapChanges::loseToneMappingOfSpheres,
            "metalness" to MapChanges::loseMetalness,
            "occlusion" to MapChanges::loseOcclusion,
            "emission map" to MapChanges::loseEmissionMap,
            "second coordinates" to MapChanges::readFirstCoordinates,
            "transforms" to MapChanges::loseTransforms,
            "tangents" to MapChanges::turnTangentsBack,
            "visibility" to LightChanges::loseVisibility,
            "visibility from behind" to LightChanges::turnVisibility,
            "stronger light" to LightChanges::dimLights,
            "environment" to LightChanges::loseEnvironment,
            "turned environment" to LightChanges::turnEnvironment,
        )
        for ((name, mistake) in mistakes) {
            val fault = cases.firstNotNullOfOrNull { case ->
                ShadingMistakes.changed(case.frame, mistake) { Comparison().fault(case, exact.getValue(case)) }
            }
            assertNotNull(fault, name)
        }
    }

    /** Uses copies of the materials and textures, which the mistakes do not affect. */
    private fun exact(case: FrameCase): ExactShading {
        val copy = checkNotNull(case.scene).withMaterials { it.withMipFilter(MipFilter.NONE) }
        return ExactShading(copy, case.frame.raster)
    }

    /** Generates frames, and removes what the oracle does not know from their scenes. */
    private fun known(frames: Arbitrary<FrameCase>, count: Int) = some(frames, count).mapIndexed { i, case ->
        val sky = Environment.of(Skies.map(i % Skies.COUNT), 0.5f, 75.0 * i)
        val scene = checkNotNull(case.scene)
        val raster = case.frame.raster
        val isPhysical = scene.surfaces.mapNotNull(ExactShading::materialOf).any(ExactLight::isPhysical)
        val lights = scene.lights.ifEmpty { Light.studio(scene.camera(raster.width, raster.height)) }
        val known = scene.withSurfaces(scene.surfaces.filterNot { it is Points || it is Lines })
            .withMaterials { withKnownLobes(it.withMipFilter(MipFilter.NONE)) }
            .withLights(if (isPhysical) lights.filterNot { it is Light.Ambient } else scene.lights)
            .withEnvironment(if (isPhysical) sky else Environment.NONE)
        FrameCase(known.frame(raster), "// without what the oracle does not know\n${case.code}", known)
    }

    /** Without sheen and transmission, whose albedos are tables, and without films; all with anisotropy. */
    private fun withKnownLobes(material: Material): Material {
        val model = material.metallicRoughness ?: return material
        val lobes = model.lobes?.let {
            Lobes(it.specular, clearcoat = it.clearcoat, anisotropy = it.anisotropy ?: Lobes.Anisotropy(0.75f, 30f))
        }
        return material.withMetallicRoughness(model.withLobes(lobes))
    }

    /** Compares the colours of all primitives at all samples that they cover, hidden or not. */
    private class Comparison {
        var samples = 0
        var judged = 0
        var exact = 0

        /** Describes the first colour that is not permitted; null if there is none. */
        fun fault(case: FrameCase, shading: ExactShading): String? {
            val frame = case.frame
            check(shading.primitives.size == frame.primitives.size)
            for (i in frame.primitives.indices) {
                for (y in 0 until frame.height) fault(frame, i, y, shading.primitives[i])?.let { return it }
            }
            return null
        }

        private fun fault(frame: Frame, i: Int, y: Int, exactColor: ExactColor): String? {
            val primitive = frame.primitives[i]
            val spans = Spans().also { primitive.spans(y, it) }
            val fragment = Fragment()
            for (span in 0 until spans.count) {
                for (x in spans.start(span) until spans.end(span)) {
                    fragment.moveTo(x, y)
                    primitive.shade(fragment)
                    val words = fault(fragment.toArgb(), exactColor.at(x, y)) ?: continue
                    return "primitive $i at ($x, $y): $words"
                }
            }
            return null
        }

        private fun fault(argb: Int, permitted: List<DoubleArray>): String? {
            samples++
            if (permitted.isEmpty()) return null
            judged++
            val codes = permitted.map { color ->
                List(4) { k ->
                    if (k < 3) ExactTexture.encoded(color[k]) else 255.0 * color[3].coerceIn(0.0, 1.0)
                }
            }
            val actual = listOf(argb ushr 16 and 0xFF, argb ushr 8 and 0xFF, argb and 0xFF, argb ushr 24)
            if (codes.any { code -> (0 until 4).all { Math.abs(code[it] - actual[it]) <= 0.5 } }) exact++
            for (k in 0 until 4) {
                val range = codes.minOf { it[k] } - 1.0..codes.maxOf { it[k] } + 1.0
                if (actual[k].toDouble() !in range) {
                    return "component $k of #%08x is not in %s".format(argb, range)
                }
            }
            return null
        }

        override fun toString(): String = "of $samples samples $judged were judged, and $exact of them exact"
    }
}
