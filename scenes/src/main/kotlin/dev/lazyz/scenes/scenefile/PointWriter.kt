package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.json.JsonWriter
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points

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
