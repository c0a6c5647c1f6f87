package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.PixelDefaults
import dev.lazyz.scenes.obj.materials.MtlMaterial
import dev.lazyz.scenes.text.Statements
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface

/**
 * Points and lines of an OBJ file, by name and material, in the order of the file. Texture coordinates are not kept.
 * Not thread safe.
 */
internal class ObjPoints {
    private class Numbers {
        /** Vertex numbers, one for each point or two for each segment, and the lines of the file that contain them. */
        val vertices = Ints()
        val lines = Ints()
    }

    private val points = LinkedHashMap<Label, Numbers>()
    private val segments = LinkedHashMap<Label, Numbers>()

    val isEmpty: Boolean get() = points.isEmpty() && segments.isEmpty()

    /** Adds the point, or the segment between two vertices, given by [ends]. [line] is its line in the file. */
    fun add(label: Label, line: Int, vararg ends: Int) {
        val numbers = (if (ends.size == 1) points else segments).getOrPut(label) { Numbers() }
        for (end in ends) {
            numbers.vertices.add(end)
            numbers.lines.add(line)
        }
    }

    /**
     * Fails if a point or segment refers to a vertex that does not exist. Counts points and segments towards the
     * limits.
     */
    fun check(source: Source, vertexCount: Int) {
        for (numbers in points.values + segments.values) {
            source.step(numbers.vertices.size)
            if (numbers.vertices.areBelow(vertexCount)) continue
            val wrong = (0 until numbers.vertices.size).first { numbers.vertices[it] >= vertexCount }
            val problem = "a point or line refers to number ${numbers.vertices[wrong] + 1} of $vertexCount vertices"
            source.fail("line ${numbers.lines[wrong]}", problem, "correct the line or export the model again")
        }
        source.loading.vertices(source, (points.values + segments.values).sumOf { it.vertices.size.toLong() })
        source.loading.segments(source, segments.values.sumOf { it.vertices.size / 2L })
    }

    /** Returns the surfaces of all points, then those of all lines. */
    fun surfaces(model: ObjModel, materialOf: (String?) -> MtlMaterial): List<Surface> {
        val positions = model.positions.toArray()

        fun material(name: String?): Material {
            val named = if (name == null) null else materialOf(name).takeIf { it.isDefined }
            return named?.material ?: PixelDefaults.material(false, model.colors.size > 0, name.orEmpty())
        }
        val vertices = CornerVertices(positions.size / 3)
        return points.map { (label, numbers) ->
            val places = IntArray(numbers.vertices.size) { numbers.vertices[it] }
            Points(
                FloatArray(3 * places.size) { positions[3 * places[it / 3] + it % 3] },
                PixelDefaults.POINT_SIZE,
                material(label.material),
                colors = model.colors(places.size) { places[it] },
                origin = model.origin,
                name = label.name,
            )
        } + segments.map { (label, numbers) ->
            vertices.begin()
            val ends = IntArray(numbers.vertices.size) { vertices.vertex(numbers.vertices[it], -1, -1) }
            Lines(
                vertices.positions(positions), ends, PixelDefaults.LINE_WIDTH, material(label.material),
                model.colors(vertices.size, vertices::position), model.origin, label.name,
            )
        }
    }
}

/**
 * Reads the statements `p v1 v2 ...` and `l v1 v2 ...`. Vertices may be written as `v/vt`; texture coordinates are not
 * used.
 */
internal class ObjPointReader(
    private val source: Source,
    private val statements: Statements,
    private val model: ObjModel,
    private val faces: ObjFaceReader,
) {
    /** Reads the points of the current statement. */
    fun readPoints(label: Label) {
        statements.nextWord()
        while (statements.nextWord()) model.points.add(label, statements.number, faces.vertex("point"))
    }

    /** Reads the polyline of the current statement. */
    fun readLine(label: Label) {
        statements.nextWord()
        var previous = -1
        var count = 0
        while (statements.nextWord()) {
            val vertex = faces.vertex("line")
            if (count++ > 0) model.points.add(label, statements.number, previous, vertex)
            previous = vertex
        }
        if (count < 2) source.warn("", "line ${statements.number}", ": a line of $count vertices is left out")
    }
}
