package dev.lazyz.scenes.gltf

import dev.lazyz.scenes.gltf.animation.GltfAnimation
import dev.lazyz.scenes.gltf.document.GltfAccessors
import dev.lazyz.scenes.gltf.document.GltfContainer
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.geometry.GltfMeshes
import dev.lazyz.scenes.gltf.geometry.GltfNodes
import dev.lazyz.scenes.gltf.geometry.GltfPoses
import dev.lazyz.scenes.gltf.geometry.GltfSkins
import dev.lazyz.scenes.gltf.geometry.PlacedNode
import dev.lazyz.scenes.gltf.materials.GltfMaterials
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Environment
import dev.lazyz.world.Scene

/**
 * Reads glTF 2.0, as JSON (`.gltf`) or as one binary file (`.glb`). The content decides which of the two it is (Khronos
 * Group, "glTF 2.0 Specification", version 2.0.1; section numbers in this package refer to that document).
 *
 * It reads the default scene, or all nodes without a parent if there is none: node transforms, triangles of all three
 * modes, points, lines of all three modes, normals (without them, shading is flat, 3.7.2.1), one set of texture
 * coordinates, `COLOR_0`, materials as described at [GltfMaterials], and lights as described at [GltfLights]. The first
 * camera in the scene becomes the viewpoint, see [GltfCameras]; without one, a camera is fitted to the scene. Skins and
 * morph targets are applied, at rest or at a moment of the first animation ([GltfAnimation], [GltfPoses]).
 * [GltfExtensions] lists the supported extensions. Features that are ignored give a warning.
 */
internal object GltfParser : SceneParser {
    override fun parse(source: Source): Scene {
        val document = GltfContainer.open(source)
        GltfExtensions.check(document)
        val accessors = GltfAccessors(document)
        val poses = GltfAnimation(document, accessors).poses(source.loading.options.animationTime)
        val tree = GltfNodes(document, poses)
        val nodes = tree.walk()
        val skins = GltfSkins(document, accessors, tree)
        val meshes = GltfMeshes(document, accessors, GltfPoses(document, accessors, skins, poses))
        val visible = nodes.filter {
            source.step()
            it.isVisible
        }
        val surfaces = visible.flatMap { meshes.of(it) }
        if (surfaces.isEmpty()) source.warn("${reasonForNothing(document, nodes)}, so there is nothing to see")
        source.cameras += GltfCameras(document, Scene(surfaces)).all(nodes)
        val first = source.cameras.firstOrNull()
        val scene = if (first == null) Scene(surfaces) else Scene(surfaces, viewpoint = first.camera)
        val lights = GltfLights(document).of(visible, scene)
        GltfExtensions.warnOfUnknown(document)
        document.warnOfCounts()
        if (lights.isEmpty()) return scene
        return scene.withLights(lights).withEnvironment(Environment.FAINT)
    }

    private fun reasonForNothing(document: GltfDocument, nodes: List<PlacedNode>): String {
        val withMesh = nodes.filter { it.node.mesh != null }
        return when {
            document.json.meshes.isEmpty() -> "there are no meshes"
            withMesh.isEmpty() -> "no node of the scene has a mesh"
            withMesh.none { it.isVisible } -> "all nodes with meshes are hidden"
            else -> "the meshes are empty"
        }
    }
}
