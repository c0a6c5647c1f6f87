package dev.lazyz.scenes.gltf

import dev.lazyz.Rgba
import dev.lazyz.geometry.Box
import dev.lazyz.scenes.LengthUnit
import dev.lazyz.scenes.NamedCamera
import dev.lazyz.scenes.gltf.animation.GltfAnimation
import dev.lazyz.scenes.gltf.document.CameraJson
import dev.lazyz.scenes.gltf.document.ExtensionValues
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
import dev.lazyz.scenes.printable
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import org.joml.Matrix4dc
import org.joml.Vector3d

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

/**
 * Reads the lights of `KHR_lights_punctual`. A light of an unknown type, or with invalid numbers, is ignored with a
 * warning.
 *
 * The file gives illuminance, lux, at any distance for directional lights, and luminous intensity, candela, for the
 * others, with distances in metres. A matt white surface reflects `illuminance / pi`, so this is the colour of a
 * [Light]. Some programs write such numbers for a viewer whose white is 1, and others those of real lights, which are
 * thousands of times larger. Therefore the light is measured as by a photographer: at the centre of the scene, at least
 * half a diagonal of the scene away from each light. If the sum is out of [LEAST]..[MOST], all lights are multiplied by
 * one factor that makes it 1.
 */
internal class GltfLights(private val document: GltfDocument) {
    private val lights: List<*> by lazy {
        document.json.extension(GltfExtensions.LIGHTS)?.get("lights") as? List<*> ?: emptyList<Any>()
    }

    /** Returns the lights of [nodes] for [scene]. */
    fun of(nodes: List<PlacedNode>, scene: Scene): List<Light> {
        val own = nodes.mapNotNull { node ->
            val reference = node.node.extension(GltfExtensions.LIGHTS) ?: return@mapNotNull null
            val where = "nodes[${node.index}].extensions.${GltfExtensions.LIGHTS}.light"
            val index = (reference["light"] as? Number)?.toInt()
            val json = document.element(lights, index, "lights", where) as? Map<*, *>
                ?: document.fail("lights[$index]", "it is not an object")
            try {
                light(json, node)
            } catch (e: IllegalArgumentException) {
                document.warn("lights[$index]", " is passed over: ${e.message}")
                null
            }
        }
        if (own.isEmpty()) return own
        val bounds = scene.bounds
        val sum = own.sumOf { measure(it, bounds) }
        if (sum in LEAST..MOST || !(sum > 0.0)) return own
        return own.map { it.scaled((1.0 / sum).toFloat()) }
    }

    private fun light(json: Map<*, *>, node: PlacedNode): Light {
        val toWorld = node.toWorld
        val color = (json["color"] as? List<*>)?.map { (it as? Number)?.toDouble() ?: 1.0 } ?: listOf(1.0, 1.0, 1.0)
        require(color.size == 3 && color.all { it >= 0.0 && it.isFinite() }) { "its color must be three numbers" }
        val intensity = ExtensionValues.number(json, "intensity", 1.0)
        require(intensity >= 0.0) { "its intensity is negative" }
        val strength = intensity / StrictMath.PI
        val rgba = Rgba(
            (color[0] * strength).toFloat(),
            (color[1] * strength).toFloat(),
            (color[2] * strength).toFloat(),
        )

        // A light shines along its -z axis
        val position = Vector3d(toWorld.m30(), toWorld.m31(), toWorld.m32())
        val direction = Vector3d(-toWorld.m20(), -toWorld.m21(), -toWorld.m22())
        val falloff = Falloff.inverseSquare(ExtensionValues.number(json, "range", Double.POSITIVE_INFINITY))
        return when (val type = json["type"]) {
            "directional" -> Light.Directional(direction, rgba)
            "point" -> Light.Point(position, rgba, falloff)
            "spot" -> {
                val cone = json["spot"] as? Map<*, *> ?: emptyMap<Any, Any>()
                val outer = ExtensionValues.number(cone, "outerConeAngle", StrictMath.PI / 4)
                val inner = ExtensionValues.number(cone, "innerConeAngle", 0.0)
                Light.Spot(position, direction, rgba, degrees(inner), degrees(outer), falloff)
            }
            else -> throw IllegalArgumentException("its type $type is unknown")
        }
    }

    /** Returns the mean of the three components that a light gives to a white surface at the centre of [bounds]. */
    private fun measure(light: Light, bounds: Box?): Double {
        val color = (light.color.red.toDouble() + light.color.green + light.color.blue) / 3
        val position = (light as? Light.Point)?.position ?: (light as? Light.Spot)?.position ?: return color
        if (bounds == null) return 0.0
        val center = Vector3d(bounds.center)
        val x = position.x() - center.x
        val y = position.y() - center.y
        val z = position.z() - center.z
        val corner = bounds.corner(0)
        val cx = corner.x - center.x
        val cy = corner.y - center.y
        val cz = corner.z - center.z
        return color / maxOf(x * x + y * y + z * z, cx * cx + cy * cy + cz * cz, LEAST_SQUARE)
    }

    private fun degrees(radians: Double): Double = minOf(radians * (180.0 / StrictMath.PI), RIGHT_ANGLE)

    private companion object {
        const val LEAST = 0.125
        const val MOST = 8.0
        const val LEAST_SQUARE = 1e-12
        const val RIGHT_ANGLE = 90.0
    }
}

/**
 * Reads the cameras of a scene with the given surfaces (section 3.10). The aspect ratio in the file is ignored: the
 * camera's height is used, and the raster determines the width.
 *
 * A perspective camera without a far plane gets one behind the whole scene. An invalid camera (without an angle or a
 * direction) is ignored with a warning.
 */
internal class GltfCameras(private val document: GltfDocument, private val scene: Scene) {
    /** Returns the cameras among [nodes], in the same order. */
    fun all(nodes: List<PlacedNode>): List<NamedCamera> = nodes.mapNotNull { placed ->
        placed.node.camera?.let { index ->
            val json = document.element(document.json.cameras, index, "cameras", "nodes[${placed.index}].camera")
            try {
                NamedCamera(printable(json.name ?: placed.node.name.orEmpty()), camera(json, placed.toWorld))
            } catch (e: IllegalArgumentException) {
                document.warn("cameras[$index]", " is passed over: ${e.message}")
                null
            }
        }
    }

    private fun camera(json: CameraJson, toWorld: Matrix4dc): Camera {
        // The camera looks along its -z axis, with y up
        val eye = Vector3d(toWorld.m30(), toWorld.m31(), toWorld.m32())
        val up = Vector3d(toWorld.m10(), toWorld.m11(), toWorld.m12())
        val target = Vector3d(eye.x - toWorld.m20(), eye.y - toWorld.m21(), eye.z - toWorld.m22())

        json.orthographic?.let {
            val height = 2.0 * StrictMath.abs(number(it.ymag, "ymag"))
            return Camera.orthographic(eye, target, up, height, number(it.znear, "znear"), number(it.zfar, "zfar"))
        }
        val perspective = requireNotNull(json.perspective) { "it is neither perspective nor orthographic" }
        val degrees = number(perspective.yfov, "yfov") * (180.0 / StrictMath.PI)
        val near = number(perspective.znear, "znear")
        return Camera.perspective(eye, target, up, degrees, near, perspective.zfar?.toDouble() ?: farthest(eye, near))
    }

    private fun farthest(eye: Vector3d, near: Double): Double {
        val bounds = scene.bounds ?: return 2 * near
        val most = (0 until 8).maxOf { number ->
            val corner = bounds.corner(number)
            val x = corner.x - eye.x
            val y = corner.y - eye.y
            val z = corner.z - eye.z
            StrictMath.sqrt(x * x + y * y + z * z)
        }
        return maxOf(MARGIN * most, 2 * near)
    }

    private fun number(value: Float?, name: String): Double = requireNotNull(value) { "$name is missing" }.toDouble()

    private companion object {
        const val MARGIN = 1.01
    }
}
