package dev.lazyz.scenes.builtin

import dev.lazyz.scenes.Builtin
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.json.JsonNode
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Surface

/** The list of built-in scenes, and their creation for scene files. */
internal object Builtins {
    private val size = ImageSize(640, 480)

    val all: List<Builtin> = listOf(
        Builtin("teapot", "the Utah teapot: smooth shading, highlights, a body that hides its inside", size) {
            teapot(TEAPOT_SEGMENTS)
        },
        Builtin("cycle", "three bars that overlap in a cycle: no order of painting is right", size) {
            CycleScene.scene()
        },
        Builtin("crossing", "three triangles that go through each other", size) { CrossingScene.scene() },
        Builtin("molecule", "a molecule of caffeine: intersecting spheres, no triangle", size) {
            MoleculeScene.scene()
        },
        Builtin("city", "a city seen from its main street: most of it is hidden", size) { city(CITY_BLOCKS, 1) },
        Builtin("layers", "a hundred squares on top of each other, the hidden ones first", size) { layers(LAYERS) },
        Builtin("plane", "a chequered plane to the horizon: texture in correct perspective", size) {
            PlaneScene.scene()
        },
        Builtin("star", "a concave polygon with a hole, and behind it one that crosses itself", size) {
            StarScene.scene()
        },
    )

    fun teapot(segments: Int): Scene = TeapotScene.scene(segments)

    fun city(blocks: Int, seed: Long): Scene = CityScene(blocks, seed).scene()

    fun layers(count: Int): Scene = LayersScene.scene(count)

    /** Returns the surfaces of the scene called [id], with the [parameters] from the scene file [source]. */
    fun surfaces(source: Source, node: JsonNode, id: String, parameters: Map<String, JsonNode>): List<Surface> {
        val builtin = all.firstOrNull { it.id == id }
            ?: node.fail("there is no built-in scene \"$id\"", "known: ${all.joinToString { it.id }}")
        val known = when (id) {
            "teapot" -> listOf("segments")
            "city" -> listOf("blocks", "seed")
            "layers" -> listOf("count")
            else -> emptyList()
        }
        for ((key, value) in parameters) {
            if (key !in known) value.fail("\"$id\" has no parameter \"$key\"", "remove it")
        }
        val size = parameters[known.firstOrNull()]?.integer()
        val triangles = triangles(id, size)
        source.loading.triangles(source, triangles)
        source.loading.vertices(source, triangles)
        if (parameters.isEmpty()) return builtin.scene().surfaces
        return node.checked {
            when (id) {
                "teapot" -> teapot(size ?: TEAPOT_SEGMENTS)
                "city" -> city(size ?: CITY_BLOCKS, parameters["seed"]?.long() ?: 1)
                else -> layers(size ?: LAYERS)
            }.surfaces
        }
    }

    /**
     * Returns the number of triangles of scene [id] with parameter [size]; 0 for the scenes that have few triangles.
     */
    private fun triangles(id: String, size: Int?): Long = when (id) {
        "teapot" -> (size ?: TEAPOT_SEGMENTS).toLong().let { 64 * it * it - 8 * it }
        "city" -> (size ?: CITY_BLOCKS).toLong().let { 40 * it * it }
        "layers" -> 2L * (size ?: LAYERS)
        else -> 0
    }.coerceAtLeast(0)

    private const val TEAPOT_SEGMENTS = 16
    private const val CITY_BLOCKS = 12
    private const val LAYERS = 100
}
