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
        Mutant(BrokenShading::emissionLost, "what gives off light by itself does not", lit),
        Mutant(BrokenShading::nearestTexel, "reads one texel where four are to be mixed", lit),
        Mutant(BrokenShading::clampsColumns, "repeats textures downward only", lit),
        Mutant(BrokenShading::flatInterpolation, "interpolates on the screen, without perspective", lit),
        Mutant(BrokenShading::strictMask, "cuts out what has exactly the alpha of the cutoff", scenes),
        Mutant(BrokenShading::vertexAlphaIgnored, "blends as if vertex colours were opaque", blended),
        Mutant(BrokenShading::blendsFrontFacesOnly, "leaves out what blends and is seen from behind", blended),
    )
}
