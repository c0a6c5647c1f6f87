package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.json.JsonMembers
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points

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
