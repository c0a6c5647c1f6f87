package dev.lazyz.scenes.scenefile

import dev.lazyz.Rgba
import dev.lazyz.geometry.FillRule
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.builtin.Builtins
import dev.lazyz.scenes.json.JsonMembers
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.loading.PartNames
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.nio.file.Path
import org.joml.Matrix4d
import org.joml.Vector3d

/** Reads surfaces in the order of the file. A mesh file that several surfaces refer to is read once. */
internal class SurfaceReader(
    private val source: Source,
    private val models: (file: Path, format: SceneFormat?) -> LoadedScene,
    private val materials: MaterialReader,
    private val up: UpAxis,
) {
    private val files = HashMap<String, List<Surface>>()
    private val points = PointReader(source)

    /** Returns the surfaces of one entry: one surface, or all surfaces of a mesh file or a built-in scene. */
    fun read(node: JsonNode): List<Surface> {
        val members = node.members(*KINDS, "name", "material", "transform", "smoothNormals")
        val (kind, value) = members.one(*KINDS)
        val material = members["material"]?.let(materials::read)
        val surfaces = when (kind) {
            "mesh" -> if (value.isText) file(value) else listOf(mesh(value))
            "polygon" -> listOf(polygon(value))
            "sphere" -> listOf(sphere(value))
            "points" -> listOf(points.points(value))
            "lines" -> listOf(points.lines(value))
            else -> builtin(value)
        }

        // Compute normals, then set the material, then transform
        val smoothed = members["smoothNormals"]?.let { smooth(surfaces, kind, it) } ?: surfaces
        val painted = if (material != null) painted(smoothed, material, value) else smoothed
        val moved = members["transform"]?.let { node ->
            val transform = TransformReader.read(node)
            node.checked { painted.map { moved(it, transform) } }
        }
        val name = members["name"]?.text().orEmpty()
        return (moved ?: painted).map { it.withName(PartNames.path(name, it.name)).withUpAxis(up) }
    }

    /**
     * Returns [surfaces] with [material]. Those of a file that [node] names are without its maps if they have no
     * texture coordinates, with a warning; fails if none has any.
     */
    private fun painted(surfaces: List<Surface>, material: Material, node: JsonNode): List<Surface> {
        val set = material.textureMap?.uvSet
        val bare = surfaces.filter {
            node.isText && set != null && it is Mesh &&
                (if (set == 0) it.uvs else it.uvs2) == null
        }
        if (bare.isNotEmpty()) {
            val lack = "no texture coordinates for the texture of its material"
            if (bare.size == surfaces.size) node.fail("\"${node.text()}\" has $lack", "remove the texture")
            val which = "${bare.size} of ${surfaces.size} surfaces of ${node.text()}"
            source.warn("", which, " have $lack, and are shown without")
        }
        return surfaces.map { surface ->
            surface.withMaterials { if (surface in bare) material.withoutMaps() else material }
        }
    }

    private fun smooth(surfaces: List<Surface>, kind: String, node: JsonNode): List<Surface> {
        if (kind != "mesh") node.fail("is for meshes, not for a $kind", "remove it")
        val angle = node.double()
        return node.checked { surfaces.map { if (it is Mesh) it.withSmoothNormals(angle) else it } }
    }

    private fun moved(surface: Surface, transform: Matrix4d): Surface = when (surface) {
        is Mesh -> surface.transformed(transform)
        is Polygon -> surface.transformed(transform)
        is Sphere -> surface.transformed(transform)
        is Points -> surface.transformed(transform)
        is Lines -> surface.transformed(transform)
        else -> error("no reader makes a $surface")
    }

    private fun file(node: JsonNode): List<Surface> {
        val reference = node.text()
        return files.getOrPut(reference) {
            val format = SceneFormat.ofFileName(reference)
            if (format == SceneFormat.SCENE) {
                node.fail("a scene file cannot contain another: $reference", "copy its surfaces")
            }
            if (source.folder == null) {
                node.fail("there is no folder to look for $reference in", "read the scene from a file")
            }
            if (node.checked { Path.of(reference) }.isAbsolute) {
                node.fail("must be relative to the scene file: $reference")
            }
            val found = source.references.find(reference)
            val file = found.file ?: node.fail("the file $reference ${found.problem}", found.remedy)
            val loaded = models(file, format)
            source.warnAll(loaded)
            loaded.scene.surfaces
        }
    }

    private fun builtin(node: JsonNode): List<Surface> {
        if (node.isText) return Builtins.surfaces(source, node, node.text(), emptyMap())
        val members = node.members("name", "segments", "count", "blocks", "seed")
        val numbers = listOf("segments", "count", "blocks", "seed").mapNotNull { key ->
            members[key]?.let { key to it }
        }
        return Builtins.surfaces(source, node, members.required("name").text(), numbers.toMap())
    }

    private fun mesh(node: JsonNode): Mesh {
        val members = node.members("origin", "positions", "triangles", "normals", "uvs", "colors", "uvs2", "tangents")
        val positions = members.required("positions").floats()
        val triangles = members.required("triangles").integers()
        source.loading.vertices(source, positions.size / 3L)
        source.loading.triangles(source, triangles.size / 3L)
        return node.checked {
            Mesh(
                positions,
                triangles,
                Material(),
                members["normals"]?.floats(),
                members["uvs"]?.floats(),
                members["colors"]?.floats(),
                members.origin(),
                members["uvs2"]?.floats(),
                members["tangents"]?.floats(),
            )
        }
    }

    private fun polygon(node: JsonNode): Polygon {
        val members = node.members("contours", "fillRule")
        val contours = members.required("contours").items().map { contour ->
            val vertices = contour.items()
            source.loading.vertices(source, vertices.size.toLong())
            vertices.map(::vertex)
        }
        val fillRule = members["fillRule"]?.choice(SceneFileNames.fillRules) ?: FillRule.EVEN_ODD
        return Polygon(contours, Material(), fillRule)
    }

    private fun vertex(node: JsonNode): Vertex {
        if (node.isList) return node.doubles(3).let { Vertex(it[0], it[1], it[2]) }
        val members = node.members("position", "uv", "color")
        val position = members.required("position").doubles(3)
        val uvNode = members["uv"]
        val uv = uvNode?.floats() ?: floatArrayOf(0f, 0f)
        if (uv.size != 2) uvNode?.fail("needs 2 numbers, not ${uv.size}")
        val color = members["color"]?.let(ColorReader::read) ?: Rgba.WHITE
        return Vertex(position[0], position[1], position[2], uv[0], uv[1], color)
    }

    private fun sphere(node: JsonNode): Sphere {
        val members = node.members("center", "radius")
        val center = members.required("center").doubles(3)
        return node.checked {
            Sphere(Vector3d(center[0], center[1], center[2]), members.required("radius").double())
        }
    }

    private companion object {
        val KINDS = arrayOf("mesh", "polygon", "sphere", "points", "lines", "builtin")
    }
}

/** Reads points and lines that are inline in a scene file. */
internal class PointReader(private val source: Source) {
    fun points(node: JsonNode): Points {
        val members = node.members("origin", "positions", "size", "normals", "colors")
        val positions = positions(members)
        val size = members["size"]?.double() ?: 1.0
        return node.checked {
            Points(
                positions,
                size,
                normals = members["normals"]?.floats(),
                colors = members["colors"]?.floats(),
                origin = members.origin(),
            )
        }
    }

    fun lines(node: JsonNode): Lines {
        val members = node.members("origin", "positions", "segments", "width", "colors")
        val positions = positions(members)
        val segments = members.required("segments").integers()
        source.loading.segments(source, segments.size / 2L)
        val width = members["width"]?.double() ?: 1.0
        return node.checked {
            Lines(positions, segments, width, colors = members["colors"]?.floats(), origin = members.origin())
        }
    }

    private fun positions(members: JsonMembers): FloatArray {
        val positions = members.required("positions").floats()
        source.loading.vertices(source, positions.size / 3L)
        return positions
    }
}
