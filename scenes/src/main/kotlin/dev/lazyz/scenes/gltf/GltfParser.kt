package dev.lazyz.scenes.gltf

import dev.lazyz.Scene
import dev.lazyz.scenes.SceneParser
import dev.lazyz.scenes.Source

/**
 * Reads glTF 2.0, as JSON (`.gltf`) and in one binary file (`.glb`); which one is told from the content (Khronos Group,
 * "glTF 2.0 Specification", version 2.0.1; section numbers in this package are of that document).
 *
 * It reads the default scene, or all nodes without a parent if there is none: node transforms, triangles of all three
 * kinds, points, lines of all three kinds, normals (flat without them, 3.7.2.1), one set of texture coordinates, `COLOR_0`, and materials as
 * [GltfMaterials] says. The first camera met becomes the viewpoint, see [GltfCameras]; without one the scene is fitted.
 * Skins, morph targets and animations are not applied: the meshes appear as they are stored. Of extensions it knows
 * `KHR_materials_unlit`, `KHR_materials_emissive_strength`, `KHR_texture_transform` and `KHR_mesh_quantization`.
 */
internal object GltfParser : SceneParser {
    override fun parse(source: Source): Scene {
        if (source.bytes.isEmpty()) source.fail(null, "the file is empty", "export the model again")
        val document = GltfContainer.open(source)
        GltfExtensions.check(document)
        val nodes = GltfNodes(document).walk()
        val meshes = GltfMeshes(document)
        val surfaces = nodes.flatMap { meshes.of(it) }
        if (surfaces.isEmpty()) source.warn("there are no meshes, so there is nothing to see")
        document.warnOfTheRest()
        return when (val camera = GltfCameras(document).first(nodes)) {
            null -> Scene(surfaces)
            else -> Scene(surfaces, viewpoint = camera)
        }
    }
}
