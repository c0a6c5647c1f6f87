package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Scene

/**
 * Reads the 3D Manufacturing Format: a ZIP archive of XML (3MF Consortium, "3MF Core Specification", version 1.3.0).
 *
 * All items of the build are shown, each object as a mesh (one for each texture), with the transforms of components and
 * items, also from other parts of the package (Production Extension). Colours come from base materials, colour groups
 * and mixes of base materials, sRGB-encoded, and from textures of texture groups (Materials Extension). An object
 * without looks inherits those of the object that contains it as a component. Base materials with an alpha of 0 are
 * treated as opaque. If colours or textures are translucent, so is the material. Of several layers of properties, the
 * last texture is shown, on the mean colour of the layer below it. Supports, beams, slices and everything else that is
 * not a triangle are ignored with a warning. Units are ignored, because they do not change the picture. Normals are
 * smoothed up to creases of [CREASE_ANGLE] degrees.
 *
 * The file's z axis points upward. It is not converted.
 */
internal object ThreeMfParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. Printed parts have chamfers of 45 degrees. */
    const val CREASE_ANGLE = 30.0

    override fun parse(source: Source): Scene {
        val build = ThreeMfBuild(source)
        val meshes = build.meshes()
        if (meshes.isEmpty()) source.warn("${build.reasonForNothing}, so there is nothing to see")
        return Scene(meshes)
    }
}
