package dev.lazyz.scenes.gltf

import dev.lazyz.scenes.LengthUnit
import dev.lazyz.scenes.gltf.animation.GltfAnimation
import dev.lazyz.scenes.gltf.document.GltfAccessors
import dev.lazyz.scenes.gltf.document.GltfCompressedViews
import dev.lazyz.scenes.gltf.document.GltfContainer
import dev.lazyz.scenes.gltf.document.GltfDocument
import dev.lazyz.scenes.gltf.document.LobeExtensions
import dev.lazyz.scenes.gltf.document.SpecularGlossiness
import dev.lazyz.scenes.gltf.document.VARIANTS
import dev.lazyz.scenes.gltf.geometry.GltfInstances
import dev.lazyz.scenes.gltf.geometry.GltfMeshes
import dev.lazyz.scenes.gltf.geometry.GltfNodes
import dev.lazyz.scenes.gltf.geometry.GltfPoses
import dev.lazyz.scenes.gltf.geometry.GltfSkins
import dev.lazyz.scenes.gltf.geometry.GltfVertices
import dev.lazyz.scenes.gltf.geometry.PlacedNode
import dev.lazyz.scenes.gltf.geometry.RelativeToCenter
import dev.lazyz.scenes.gltf.materials.GltfMaterials
import dev.lazyz.scenes.gltf.materials.GltfTextures
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Scene
import dev.lazyz.world.light.Environment

/**
 * Reads glTF 2.0, as JSON (`.gltf`) or as one binary file (`.glb`). The content decides which of the two it is (Khronos
 * Group, "glTF 2.0 Specification", version 2.0.1; section numbers in this package refer to that document).
 *
 * It reads the scene that was asked for, or the default scene, or all nodes without a parent if there is none: node
 * transforms, triangles of all three modes, points, lines of all three modes, normals (without them, shading is flat,
 * 3.7.2.1), one set of texture coordinates, `COLOR_0`, materials as described at [GltfMaterials], and lights as
 * described at [GltfLights]. The first camera in the scene becomes the viewpoint, see [GltfCameras]; without one, a
 * camera is fitted to the scene. Skins and morph targets are applied, at rest or at a moment of the first animation
 * ([GltfAnimation], [GltfPoses]).
 * [GltfExtensions] lists the supported extensions. Features that are ignored give a warning.
 */
internal object GltfParser : SceneParser {
    override fun parse(source: Source): Scene {
        source.unit = LengthUnit.METRE
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

/** The supported extensions (section 3.12). */
internal object GltfExtensions {
    /** The extension for lights, see [GltfLights]. */
    const val LIGHTS: String = "KHR_lights_punctual"

    private val known = setOf(
        "KHR_materials_unlit",
        "KHR_materials_emissive_strength",
        "KHR_texture_transform",
        "KHR_mesh_quantization",
        GltfVertices.DRACO,
        LIGHTS,
        SpecularGlossiness.NAME,
        GltfInstances.NAME,
        GltfNodes.VISIBILITY,
        RelativeToCenter.NAME,
        VARIANTS,
    ) + LobeExtensions.all + GltfCompressedViews.NAMES + GltfTextures.extensions

    private const val MOST_SHOWN = 20

    /**
     * Prefixes of extensions that change only the appearance: without them the shapes are right, but colours may
     * differ.
     */
    private val appearance =
        listOf("KHR_materials_", "KHR_techniques_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "EXT_lights_")

    /** Fails if the file requires an unsupported extension without which its shapes cannot be read. */
    fun check(document: GltfDocument) {
        for (name in document.json.extensionsRequired) {
            if (name in known || appearance.any { name.startsWith(it) }) continue
            document.source.fail(
                "extensionsRequired",
                "the file requires the extension $name, which is not known",
                "export the model without it",
            )
        }
    }

    /** Reports the unsupported extensions that the file uses, in one warning. */
    fun warnOfUnknown(document: GltfDocument) {
        val unknown = (document.json.extensionsUsed + document.json.extensionsRequired).distinct() - known
        if (unknown.isEmpty()) return
        val shown = unknown.take(MOST_SHOWN).joinToString() + if (unknown.size > MOST_SHOWN) " and others" else ""
        document.warn("extensions that are not known are passed over, ${unknown.size} in all: $shown")
    }
}
