package dev.lazyz.scenes.fuzz.mutations

import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.node.JsonNodeFactory
import java.math.BigDecimal
import java.util.Base64
import java.util.Random

/** Values to put into a JSON tree. */
internal object JsonValues {
    private val make = JsonNodeFactory.instance
    private val texts =
        listOf("", "NaN", "Infinity", "a", "0", "t.png", "../a.obj", "\u001B[2J", "\uD800", "#ffffff", "/", "data:,")
    private val numbers =
        listOf("1e400", "-1e400", "1e-400", "0.1", "-0.0", "1e38", "3.5e38", "1e308", "1.5", "1e99999999")

    fun any(random: Random): JsonNode = when (random.nextInt(8)) {
        0 -> make.nullNode()
        1 -> make.booleanNode(random.nextBoolean())
        2 -> make.textNode(random.pick(texts))
        3 -> make.arrayNode()
        4 -> make.objectNode()
        5 -> make.numberNode(BigDecimal(random.pick(numbers)))
        else -> make.numberNode(random.pick(InterestingNumbers.whole))
    }

    /** A value of the same type as [value]. */
    fun near(value: JsonNode, random: Random): JsonNode = when {
        value.isIntegralNumber && random.nextBoolean() -> make.numberNode(value.longValue() + random.nextInt(5) - 2)
        value.isNumber -> when (random.nextInt(6)) {
            0 -> make.numberNode(-value.doubleValue())
            1 -> make.numberNode(value.doubleValue() * random.nextGaussian() * 10)
            2 -> make.numberNode(BigDecimal(random.pick(numbers)))
            else -> make.numberNode(random.pick(InterestingNumbers.whole))
        }
        value.isTextual -> make.textNode(text(value.textValue(), random))
        value.isBoolean -> make.booleanNode(!value.booleanValue())
        else -> any(random)
    }

    /** What is in a `data:` URI is changed as bytes, most of the time; other text as text. */
    private fun text(text: String, random: Random): String {
        val comma = text.indexOf(",")
        if (!text.startsWith("data:") || comma < 0 || random.nextInt(4) == 0) {
            return TextMutations.mutate(text, random.pick(texts), random)
        }
        val bytes = try {
            Base64.getDecoder().decode(text.substring(comma + 1))
        } catch (_: IllegalArgumentException) {
            return TextMutations.mutate(text, random.pick(texts), random)
        }
        val changed = ByteMutations.mutate(bytes, bytes, random)
        return text.substring(0, comma + 1) + Base64.getEncoder().encodeToString(changed)
    }

    /** Puts [value] into lists or objects, mostly few. */
    fun nested(value: JsonNode, random: Random): JsonNode {
        val key = random.pick(listOf("a", "extensions", "mesh", "children"))
        var node = value
        repeat(1 + random.small(MOST_DEEP)) {
            node = if (random.nextBoolean()) make.arrayNode().add(node) else make.objectNode().set<JsonNode>(key, node)
        }
        return node
    }

    private const val MOST_DEEP = 300
}
