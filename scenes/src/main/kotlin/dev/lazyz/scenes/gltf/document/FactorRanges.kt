package dev.lazyz.scenes.gltf.document

import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.node.ArrayNode
import com.fasterxml.jackson.databind.node.ObjectNode

/**
 * Clamps numbers that are outside the range that the specification gives: the factors of materials and the rotations of
 * nodes. Many programs write numbers slightly above 1, such as 1.0000001.
 */
internal object FactorRanges {
    private class Factor(path: String, val least: Double) {
        val steps = path.split('.')
        val sentence = "$path is outside ${least.toInt()}..1 and is clamped"
    }

    private val ofMaterials = listOf(
        "pbrMetallicRoughness.baseColorFactor",
        "pbrMetallicRoughness.metallicFactor",
        "pbrMetallicRoughness.roughnessFactor",
        "occlusionTexture.strength",
        "emissiveFactor",
    ).map { Factor(it, 0.0) }

    private val rotation = Factor("rotation", -1.0)

    /** What rounding may add to a number. A number that is farther outside its range causes a warning. */
    private const val ROUNDING = 1e-3

    /** Clamps the numbers in [tree], the JSON of a file. */
    fun clamp(tree: JsonNode, warnings: CountedWarnings) {
        for (material in tree.path("materials")) {
            warnings.source.step(ofMaterials.size)
            for (factor in ofMaterials) clamp(material, factor, "materials", warnings)
        }
        for (node in tree.path("nodes")) {
            warnings.source.step()
            clamp(node, rotation, "nodes", warnings)
        }
    }

    private fun clamp(element: JsonNode, factor: Factor, list: String, warnings: CountedWarnings) {
        val name = factor.steps.last()
        val owner = factor.steps.dropLast(1).fold(element) { node, step -> node.path(step) } as? ObjectNode ?: return
        val value = owner.path(name)
        var excess = 0.0

        fun clamped(number: Double): Double {
            val result = number.coerceIn(factor.least, 1.0)
            excess = maxOf(excess, StrictMath.abs(number - result))
            return result
        }
        if (value.isNumber) owner.put(name, clamped(value.asDouble()))
        if (value is ArrayNode) {
            for (i in 0 until value.size()) if (value[i].isNumber) value.set(i, clamped(value[i].asDouble()))
        }
        if (excess > ROUNDING) warnings.count("$list.${factor.sentence}")
    }
}
