package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Scene

/**
 * Reads the 3D Manufacturing Format: a ZIP archive of XML (3MF Consortium, "3MF Core Specification", version 1.3.0).
 *
 * All items of the build are shown, each object a mesh (one for each texture), with the transforms of components and items,
 * also from other parts of the package (Production Extension). Colours are those of base materials, colour groups and mixes
 * of base materials, sRGB-encoded, and textures of texture groups (Materials Extension); an object without looks has those
 * of what it is a component of. Base materials with an alpha of 0 count as opaque. Where colours or textures let something through, so does the material. Of layers of
 * properties one is shown. Supports, beams, slices and what else is not triangles are passed over, with a warning. Units
 * are passed over, for a picture is the same in all. Normals are made smooth up to creases of [CREASE_ANGLE] degrees.
 *
 * The file's z axis is up, and stays as it is.
 */
internal object ThreeMfParser : SceneParser {
    /** Edges sharper than this stay sharp, degrees: printed parts have chamfers of 45. */
    const val CREASE_ANGLE = 30.0

    override fun parse(source: Source): Scene {
        if (source.bytes.isEmpty()) source.fail(null, "the file is empty", "export the model again")
        val meshes = ThreeMfBuild(source).meshes()
        if (meshes.isEmpty()) source.warn("there are no triangles, so there is nothing to see")
        return Scene(meshes)
    }
}
