package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenLight
import dev.lazyz.conformance.broken.BrokenMaps
import dev.lazyz.conformance.broken.BrokenShading
import dev.lazyz.conformance.broken.gallery.RuleNames.blended
import dev.lazyz.conformance.broken.gallery.RuleNames.footprints
import dev.lazyz.conformance.broken.gallery.RuleNames.lit
import dev.lazyz.conformance.broken.gallery.RuleNames.scenes
import dev.lazyz.conformance.broken.gallery.RuleNames.turned

/** The gallery's part about light, textures and materials. */
internal object ShadingGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenShading::normalsNotTurned, "lights back faces from the wrong side", turned, lit),
        Mutant(BrokenShading::highlightsLost, "light without highlights", turned, lit),
        Mutant(BrokenShading::vertexAlphaIgnored, "blends as if vertex colours were opaque", blended),
    ) + maps() + light()

    private fun maps() = listOf(
        Mutant(BrokenMaps::oneSetOfCoordinates, "reads all maps at the first texture coordinates", lit, scenes),
        Mutant(
            BrokenMaps::footprintOfANeighbour,
            "reads textures of fine meshes with the derivatives of the sample that was shaded before",
            footprints,
        ),
        Mutant(BrokenMaps::tangentsNotTurned, "reverses the normals of back faces, but not their tangents", turned),
        Mutant(BrokenMaps::metalsArePlastic, "all metals are plastic", lit, scenes),
        Mutant(BrokenMaps::spheresNotToned, "tone mapping is left out for spheres", lit, scenes),
    )

    private fun light() = listOf(
        Mutant(BrokenLight::environmentLost, "metals do not reflect the environment", lit, scenes),
        Mutant(BrokenLight::falloffLost, "light is equally strong at any distance", lit, scenes),
        Mutant(BrokenLight::visibilityLost, "ignores the visibility of ambient light", lit, scenes),
    )
}
