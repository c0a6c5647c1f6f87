package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenLight
import dev.lazyz.conformance.broken.BrokenMaps
import dev.lazyz.conformance.broken.BrokenShading
import dev.lazyz.conformance.broken.gallery.RuleNames.blended
import dev.lazyz.conformance.broken.gallery.RuleNames.footprints
import dev.lazyz.conformance.broken.gallery.RuleNames.lit
import dev.lazyz.conformance.broken.gallery.RuleNames.options
import dev.lazyz.conformance.broken.gallery.RuleNames.scenes
import dev.lazyz.conformance.broken.gallery.RuleNames.turned

/** The gallery's part about light, textures and materials. */
internal object ShadingGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(BrokenShading::normalsNotTurned, "lights back faces from the wrong side", turned, lit),
        Mutant(
            BrokenShading::equalNormalsNotTurned,
            "lights back faces from the wrong side where the normals of the vertices are equal",
            turned,
        ),
        Mutant(BrokenShading::highlightsLost, "light without highlights", turned, lit),
        Mutant(BrokenShading::emissionLost, "ignores the light that materials emit", lit),
        Mutant(BrokenShading::nearestTexel, "reads the nearest texel instead of mixing four", lit),
        Mutant(BrokenShading::clampsColumns, "repeats textures vertically, but clamps them horizontally", lit),
        Mutant(BrokenShading::flatInterpolation, "interpolates on the screen, without perspective", lit),
        Mutant(BrokenShading::strictMask, "removes fragments whose alpha equals the cutoff", scenes),
        Mutant(BrokenShading::vertexAlphaIgnored, "blends as if vertex colours were opaque", blended),
        Mutant(
            BrokenShading::blendsFrontFacesOnly,
            "does not draw translucent faces that are seen from behind",
            blended,
        ),
    ) + maps() + light()

    private fun maps() = listOf(
        Mutant(BrokenMaps::oneSetOfCoordinates, "reads all maps at the first texture coordinates", lit, scenes),
        Mutant(
            BrokenMaps::footprintOfTheLastSample,
            "reads textures with the derivatives of the sample that was shaded before",
            lit, scenes,
        ),
        Mutant(
            BrokenMaps::footprintOfANeighbour,
            "reads textures of fine meshes with the derivatives of the sample that was shaded before",
            footprints,
        ),
        Mutant(
            BrokenMaps::footprintOfAnotherSurface,
            "reads textures of surfaces without coordinates with the derivatives of another surface",
            scenes,
        ),
        Mutant(BrokenMaps::mipFilterLost, "reads textures without their mip filters", lit, scenes),
        Mutant(BrokenMaps::transformLost, "reads textures at coordinates that are not transformed", lit, scenes),
        Mutant(
            BrokenMaps::stepsForgetAttributes,
            "stepped colours lack derivatives, second texture coordinates and tangents",
            options,
        ),
        Mutant(
            BrokenMaps::normalOfTheLastSample,
            "a normal map changes the normal that it made at the sample before",
            lit, scenes, turned,
        ),
        Mutant(BrokenMaps::tangentsNotTurned, "reverses the normals of back faces, but not their tangents", turned),
        Mutant(BrokenMaps::occlusionLost, "ignores occlusion maps", lit),
        Mutant(BrokenMaps::emissionMapLost, "ignores emission maps", lit, scenes),
        Mutant(BrokenMaps::metalsArePlastic, "all metals are plastic", lit, scenes),
        Mutant(BrokenMaps::spheresNotToned, "tone mapping is left out for spheres", lit, scenes),
    )

    private fun light() = listOf(
        Mutant(BrokenLight::environmentLost, "metals do not reflect the environment", lit, scenes),
        Mutant(BrokenLight::conesLost, "spots shine in all directions", lit, scenes),
        Mutant(BrokenLight::falloffLost, "light is equally strong at any distance", lit, scenes),
        Mutant(BrokenLight::visibilityLost, "ignores the visibility of ambient light", lit, scenes),
        Mutant(
            BrokenLight::visibilityLostOnMetals,
            "ignores the visibility of ambient light on metallic-roughness materials",
            lit, scenes,
        ),
        Mutant(
            BrokenLight::visibilityOfTheLastPoint,
            "uses the visibility of the point that was lit before",
            lit, scenes,
        ),
        Mutant(BrokenLight::studioAtMostOne, "the environment is never brighter than 1", lit, scenes),
    )
}
