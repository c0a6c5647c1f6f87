package dev.lazyz.conformance.broken.gallery

import dev.lazyz.conformance.broken.BrokenShading
import dev.lazyz.conformance.broken.gallery.RuleNames.blended
import dev.lazyz.conformance.broken.gallery.RuleNames.lit
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
    )
}
