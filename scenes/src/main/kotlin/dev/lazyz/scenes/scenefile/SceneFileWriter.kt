package dev.lazyz.scenes.scenefile

import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.Tint
import dev.lazyz.scenes.json.JsonWriter
import dev.lazyz.scenes.writers.AtomicFile
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.io.IOException
import java.nio.channels.Channels
import java.nio.file.Path
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Lazy Z's scene file format: a whole [Scene] as JSON, to store, to send, and to write by hand. docs/scene-file.md of
 * the project describes the format.
 *
 * `Scenes.load` returns a scene that renders bit for bit like the scene that [write] wrote. A written file needs no
 * other files: it contains meshes as numbers and textures as embedded PNG. Large meshes are better kept in separate
 * mesh files, which a scene file written by hand can refer to: as JSON they take several times the space and the time.
 */
public object SceneFile {
    /** The format version that is written, and the only one that can be read. */
    public const val VERSION: Int = 1

    /**
     * Writes [scene] to a file, either completely or not at all.
     *
     * Every number is written so that it reads back bit for bit the same. Numbers that are not finite are written as
     * the text `"NaN"`, `"Infinity"` or `"-Infinity"`.
     *
     * @param size the size of the image, or null to let the reader of the file choose it
     * @param depth the depth rules
     * @throws IllegalArgumentException if a surface is not a [Mesh], [Polygon], [Sphere], [Points] or [Lines], the
     *   viewpoint is not a [Camera] or [FittedViewpoint], a material has a shader other than [Tint], or the scene has
     *   a visibility of ambient light: the format cannot represent those
     * @throws IOException if the file cannot be written; the message states which file, why, and what to do
     */
    @JvmStatic
    @JvmOverloads
    @Throws(IOException::class)
    public fun write(scene: Scene, path: Path, size: ImageSize? = null, depth: DepthRules = DepthRules()) {
        SceneFileWriter.requireWritable(scene)
        AtomicFile.write(path) { channel ->
            Channels.newWriter(channel, Charsets.UTF_8).use { SceneFileWriter(it).write(scene, size, depth) }
        }
    }

    /**
     * Returns the text that [write] would write.
     *
     * @throws IllegalArgumentException as [write] does
     */
    @JvmStatic
    @JvmOverloads
    public fun format(scene: Scene, size: ImageSize? = null, depth: DepthRules = DepthRules()): String {
        SceneFileWriter.requireWritable(scene)
        return buildString { SceneFileWriter(this).write(scene, size, depth) }
    }
}

/** Writes a whole scene file. */
internal class SceneFileWriter(private val out: Appendable) {
    fun write(scene: Scene, size: ImageSize?, depth: DepthRules) {
        val materials = MaterialWriter(scene.surfaces.map(::materialOf))
        JsonWriter(out).members {
            key("lazyz").integer(SceneFile.VERSION)
            if (size != null) key("size").integers(size.width, size.height)
            key("background").color(scene.background)
            if (depth != DepthRules()) depth(key("depth"), depth)
            viewpoint(key("camera"), scene)
            if (scene.lights.isNotEmpty()) key("lights").items(scene.lights) { LightWriter.write(this, it) }
            scene.environment?.let { key("environment").members { key("studio").float(it.intensity) } }
            if (scene.lightIntensity != 1f) key("lightIntensity").float(scene.lightIntensity)
            scene.toneMapping?.let { LightWriter.write(key("toneMapping"), it) }
            if (!materials.isEmpty) materials.write(key("materials"))
            key("surfaces").items(scene.surfaces) { surface(this, it, materials.name(materialOf(it))) }
        }
        out.append('\n')
    }

    private fun depth(out: JsonWriter, depth: DepthRules) = out.members {
        key("convention").text(SceneFileNames.of(depth.convention))
        key("test").text(SceneFileNames.of(depth.test))
        key("background").integer(depth.background)
    }

    private fun viewpoint(out: JsonWriter, scene: Scene) = out.members {
        when (val viewpoint = scene.viewpoint) {
            is Camera -> camera(this, viewpoint)
            is FittedViewpoint -> key("fit").members {
                key("azimuth").double(viewpoint.azimuth)
                key("elevation").double(viewpoint.elevation)
                key("zoom").double(viewpoint.zoom)
                key("projection").text(SceneFileNames.of(viewpoint.kind))
                key("margin").double(viewpoint.margin)
                key("fieldOfView").double(viewpoint.fieldOfView)
            }
        }
    }

    private fun camera(out: JsonWriter, camera: Camera) {
        val (kind, scale, value) = when (val projection = camera.projection) {
            is Projection.Perspective -> Triple("perspective", "fieldOfView", projection.verticalFieldOfView)
            is Projection.Orthographic -> Triple("orthographic", "height", projection.height)
            Projection.Screen -> return screen(out, camera)
        }
        out.key(kind).members {
            key("eye").vector(camera.eye)
            key("target").vector(camera.target)
            key("up").vector(camera.up)
            key(scale).double(value)
            key("near").double(camera.near)
            key("far").double(camera.far)
        }
    }

    private fun screen(out: JsonWriter, camera: Camera) = out.key("screen").members {
        key("near").double(camera.near)
        key("far").double(camera.far)
    }

    private fun surface(out: JsonWriter, surface: Surface, material: String?) = out.members {
        if (surface.name.isNotEmpty()) key("name").text(surface.name)
        if (material != null) key("material").text(material)
        when (surface) {
            is Mesh -> mesh(key("mesh"), surface)
            is Polygon -> polygon(key("polygon"), surface)
            is Sphere -> key("sphere").members {
                key("center").vector(surface.center)
                key("radius").double(surface.radius)
            }
            is Points -> PointWriter.write(key("points"), surface)
            is Lines -> PointWriter.write(key("lines"), surface)
        }
    }

    private fun mesh(out: JsonWriter, mesh: Mesh) = out.members {
        origin(mesh.origin)
        key("positions").long(mesh.positions.size) { float(mesh.positions[it]) }
        key("triangles").long(mesh.triangles.size) { integer(mesh.triangles[it]) }
        mesh.normals?.let { normals -> key("normals").long(normals.size) { float(normals[it]) } }
        mesh.uvs?.let { uvs -> key("uvs").long(uvs.size) { float(uvs[it]) } }
        mesh.colors?.let { colors -> key("colors").long(colors.size) { float(colors[it]) } }
        mesh.uvs2?.let { uvs -> key("uvs2").long(uvs.size) { float(uvs[it]) } }
        mesh.tangents?.let { tangents -> key("tangents").long(tangents.size) { float(tangents[it]) } }
    }

    private fun polygon(out: JsonWriter, polygon: Polygon) = out.members {
        if (polygon.fillRule != FillRule.EVEN_ODD) key("fillRule").text(SceneFileNames.of(polygon.fillRule))
        key("contours").items(polygon.contours) { contour -> items(contour) { vertex(this, it) } }
    }

    private fun vertex(out: JsonWriter, vertex: Vertex) {
        val isPlain = vertex.u.toRawBits() == 0 && vertex.v.toRawBits() == 0 && vertex.color == Rgba.WHITE
        if (isPlain) return out.doubles(vertex.x, vertex.y, vertex.z)
        out.members {
            key("position").doubles(vertex.x, vertex.y, vertex.z)
            key("uv").floats(vertex.u, vertex.v)
            key("color").color(vertex.color)
        }
    }

    companion object {
        /** Throws [IllegalArgumentException] unless the format can represent all of [scene]. */
        fun requireWritable(scene: Scene) {
            val viewpoint = scene.viewpoint
            require(viewpoint is Camera || viewpoint is FittedViewpoint) {
                "a scene file holds a Camera or Camera.fit(), not $viewpoint: " +
                    "write scene.withViewpoint(scene.camera(width, height)) instead"
            }
            require(scene.ambientVisibility == null) {
                "a scene file holds no visibility of ambient light: write scene.withAmbientVisibility(null) instead"
            }
            require(scene.environment?.map == null) {
                "a scene file holds no picture of surroundings: write scene.withEnvironment(null) instead, and name " +
                    "the picture's file in \"environment\""
            }
            scene.surfaces.forEachIndexed { index, surface ->
                val material = requireNotNull(surface.material.takeIf { isKnown(surface) }) {
                    "a scene file holds meshes, polygons, spheres, points and lines only: surfaces[$index] is $surface"
                }
                val shader = material.shader
                require(shader == null || shader is Tint) {
                    "a scene file holds no shader but Tint: surfaces[$index] has one of its own"
                }
            }
        }

        private fun materialOf(surface: Surface): Material = checkNotNull(surface.material) {
            "not checked: $surface"
        }

        private fun isKnown(surface: Surface): Boolean =
            surface is Mesh || surface is Polygon || surface is Sphere || surface is Points || surface is Lines
    }
}

/** Writes the lights and the tone mapping of a scene file. */
internal object LightWriter {
    fun write(out: JsonWriter, light: Light) = out.members {
        when (light) {
            is Light.Ambient -> key("ambient").members { key("color").color(light.color) }
            is Light.Directional -> key("directional").members {
                key("direction").vector(light.direction)
                key("color").color(light.color)
            }
            is Light.Point -> key("point").members {
                key("position").vector(light.position)
                key("color").color(light.color)
                falloff(this, light.falloff)
            }
            is Light.Spot -> key("spot").members {
                key("position").vector(light.position)
                key("direction").vector(light.direction)
                key("color").color(light.color)
                key("innerAngle").double(light.innerAngle)
                key("outerAngle").double(light.outerAngle)
                falloff(this, light.falloff)
            }
        }
    }

    private fun falloff(out: JsonWriter, falloff: Falloff) {
        if (falloff == Falloff.NONE) return
        out.key("falloff").text(SceneFileNames.INVERSE_SQUARE)
        if (falloff.range.isFinite()) out.key("range").double(falloff.range)
    }

    fun write(out: JsonWriter, toneMapping: ToneMapping) = out.members {
        key("curve").text(SceneFileNames.of(toneMapping.curve))
        key("exposure").double(toneMapping.exposure)
    }
}

/** Writes points and lines inline, as numbers. */
internal object PointWriter {
    fun write(out: JsonWriter, points: Points) = out.members {
        key("size").double(points.size)
        origin(points.origin)
        numbers(key("positions"), points.positions)
        points.normals?.let { numbers(key("normals"), it) }
        points.colors?.let { numbers(key("colors"), it) }
    }

    fun write(out: JsonWriter, lines: Lines) = out.members {
        key("width").double(lines.width)
        origin(lines.origin)
        numbers(key("positions"), lines.positions)
        key("segments").long(lines.segments.size) { integer(lines.segments[it]) }
        lines.colors?.let { numbers(key("colors"), it) }
    }

    private fun numbers(out: JsonWriter, numbers: FloatArray) = out.run { long(numbers.size) { float(numbers[it]) } }
}

private val WORLD_ORIGIN = Vector3d()

internal fun JsonWriter.vector(v: Vector3dc) = doubles(v.x(), v.y(), v.z())

/** Writes the key `origin`, unless it is the world's origin. */
internal fun JsonWriter.origin(origin: Vector3dc) {
    if (origin != WORLD_ORIGIN) key("origin").vector(origin)
}
