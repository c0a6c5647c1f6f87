package dev.lazyz.scenes.fuzz.mutations

import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.node.ArrayNode
import com.fasterxml.jackson.databind.node.ObjectNode
import java.util.Random

/** Where a value stands in a JSON tree. */
internal sealed interface JsonPlace {
    /** The key, or `item` in a list. */
    val name: String

    /** What stands there; null if it was taken away. */
    val value: JsonNode?

    fun set(node: JsonNode)

    fun remove()

    /** Puts a copy into the same list, or under the key [key] into the same object. */
    fun duplicate(key: String, random: Random)

    class Member(private val parent: ObjectNode, override val name: String) : JsonPlace {
        override val value: JsonNode? get() = parent.get(name)

        override fun set(node: JsonNode) {
            parent.set<JsonNode>(name, node)
        }

        override fun remove() {
            parent.remove(name)
        }

        override fun duplicate(key: String, random: Random) {
            value?.let { parent.set<JsonNode>(key, it.deepCopy<JsonNode>()) }
        }
    }

    class Item(private val parent: ArrayNode, private val index: Int) : JsonPlace {
        override val name: String get() = "item"
        override val value: JsonNode? get() = parent.get(index)

        override fun set(node: JsonNode) {
            if (index < parent.size()) parent.set(index, node)
        }

        override fun remove() {
            parent.remove(index)
        }

        override fun duplicate(key: String, random: Random) {
            val copy = value ?: return
            val at = random.nextInt(parent.size() + 1)
            repeat(1 + random.small(MOST_COPIES)) { parent.insert(at, copy.deepCopy<JsonNode>()) }
        }
    }

    companion object {
        private const val MOST_COPIES = 100
    }
}
