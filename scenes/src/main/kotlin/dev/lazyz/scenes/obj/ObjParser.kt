package dev.lazyz.scenes.obj

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.obj.materials.MtlLibrary
import dev.lazyz.world.Scene

/**
 * Reads Wavefront OBJ files with their material libraries (Wavefront Technologies, "Advanced Visualizer" manual,
 * appendix B1, "Object Files", version 3.0).
 *
 * It reads polygons with any number of corners, normals, texture coordinates (v upward, converted to `1 - v`),
 * materials, and vertex colours `v x y z red green blue`, which are sRGB-encoded numbers in 0..1. Groups are ignored.
 * Objects and materials divide the file into meshes, see [ObjMeshes]. Faces without normals are smooth up to creases of
 * [CREASE_ANGLE] degrees, or flat after `s off`; other numbers of smoothing groups are ignored. Points and lines follow
 * the meshes, by material; if there is none of these, all vertices are points. Free-form geometry and unknown
 * statements are ignored with a warning.
 */
internal object ObjParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. */
    const val CREASE_ANGLE = 45.0

    override fun parse(source: Source): Scene {
        source.decodeText()
        val model = model(source)
        if (model.positions.size == 0) {
            source.fail(null, "there is no vertex in the file", "check what kind of file it is")
        }
        source.release()
        model.checkReferences()
        val faces = model.faces
        source.loading.vertices(source, model.positions.size / 3L)
        source.loading.triangles(source, faces.positions.size - 2L * faces.size)
        if (faces.size == 0 && model.points.isEmpty) return Scene(model.vertices().points())

        val library = MtlLibrary(source)
        for (reference in model.libraries.distinct()) library.add(reference)
        val meshes = ObjMeshes(source, model, library::material).build()
        return Scene(meshes + model.points.surfaces(model, library::material))
    }

    private fun model(source: Source): ObjModel {
        val reader = FarOrigin.reading(
            source.loading,
            read = { origin -> ObjReader(source, ObjModel(source, origin)).also { it.read() } },
            bounds = { Box.around(it.model.positions.toArray()) },
        )
        reader.warn()
        return reader.model
    }
}
