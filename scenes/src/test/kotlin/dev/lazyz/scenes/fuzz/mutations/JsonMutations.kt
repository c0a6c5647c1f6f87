package dev.lazyz.scenes.fuzz.mutations

import com.fasterxml.jackson.core.JsonProcessingException
import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.ObjectMapper
import com.fasterxml.jackson.databind.node.ArrayNode
import com.fasterxml.jackson.databind.node.ObjectNode
import java.io.CharConversionException
import java.util.Random

/** Changes members of a JSON tree, so that it stays JSON. */
internal object JsonMutations : Mutations {
    private val mapper = ObjectMapper()

    override fun mutate(input: ByteArray, other: ByteArray, random: Random): ByteArray? {
        val root = parsed(input) ?: return null
        val places = places(root)
        if (places.isEmpty()) return null
        val donors = parsed(other)?.let { places(it) }.orEmpty().ifEmpty { places }
        repeat(1 + random.small(2)) {
            random.pick(places).let { place ->
                place.value?.let { change(place, it, random.pick(donors).value ?: it, places, random) }
            }
        }
        return written(root)
    }

    private fun change(place: JsonPlace, value: JsonNode, donor: JsonNode, places: List<JsonPlace>, random: Random) {
        when (random.nextInt(10)) {
            0 -> place.remove()
            1 -> place.duplicate(random.pick(places).name, random)
            2 -> place.set(donor.deepCopy())
            3 -> random.pick(places).value?.let { place.set(it.deepCopy()) }
            4 -> place.set(JsonValues.nested(value.deepCopy(), random))
            5 -> place.set(JsonValues.any(random))
            else -> place.set(JsonValues.near(value, random))
        }
    }

    /** Text that is no JSON is left alone. */
    private fun parsed(bytes: ByteArray): JsonNode? = try {
        mapper.readTree(bytes)
    } catch (_: JsonProcessingException) {
        null
    } catch (_: CharConversionException) {
        null
    }

    /** Null for a tree that is too deep. */
    private fun written(root: JsonNode): ByteArray? = try {
        mapper.writeValueAsBytes(root)
    } catch (_: JsonProcessingException) {
        null
    }

    /** All members, outer ones first. */
    private fun places(root: JsonNode): List<JsonPlace> {
        val places = ArrayList<JsonPlace>()
        val open = ArrayDeque(listOf(root))
        while (open.isNotEmpty()) {
            val node = open.removeFirst()
            when (node) {
                is ObjectNode -> node.fieldNames().forEach { places.add(JsonPlace.Member(node, it)) }
                is ArrayNode -> for (i in 0 until node.size()) places.add(JsonPlace.Item(node, i))
            }
            open.addAll(node)
        }
        return places
    }
}
