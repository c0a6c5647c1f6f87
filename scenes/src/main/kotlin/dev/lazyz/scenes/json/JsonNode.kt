package dev.lazyz.scenes.json

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.EditDistance
import org.joml.Vector3d

/**
 * A value of a scene file together with its path, so that error messages can state the location.
 *
 * @property path for example `surfaces[2].material`; empty for the whole file
 */
internal class JsonNode(private val source: Source, val path: String, private val element: Any?) {
    val isText: Boolean get() = element is String

    val isList: Boolean get() = element is List<*>

    fun fail(problem: String, remedy: String? = null): Nothing = source.fail(path.ifEmpty { null }, problem, remedy)

    /** Runs [block]. If the block throws [IllegalArgumentException], reports it as an error in this value. */
    inline fun <T> checked(block: () -> T): T = try {
        block()
    } catch (e: IllegalArgumentException) {
        source.fail(path.ifEmpty { null }, e.message ?: "not a legal value", cause = e)
    }

    /** Returns the members of an object. A member that is not in [known] is an error. */
    fun members(vararg known: String): JsonMembers {
        source.step(known.size)
        if (element !is Map<*, *>) wrongType("an object with ${known.joinToString()}")
        for (key in element.keys) {
            source.step()
            key as String
            if (key !in known) {
                val meant = JsonKeys.nearest(key, known.asList())
                source.fail(
                    JsonKeys.path(path, key),
                    "unknown key \"$key\"",
                    if (meant != null) "did you mean \"$meant\"?" else "known here: ${known.joinToString()}",
                )
            }
        }
        return JsonMembers(this, known.asList(), children(element))
    }

    /** Returns the members of an object whose keys are user-defined names, in the order of the file. */
    fun named(): Map<String, JsonNode> {
        if (element !is Map<*, *>) wrongType("an object of names")
        return children(element)
    }

    fun items(): List<JsonNode> {
        if (element !is List<*>) wrongType("a list")
        return List(element.size) { item(element, it) }
    }

    fun text(): String {
        if (element !is String) wrongType("text in quotes")
        return element
    }

    /** Returns text as it is, or a number, true or false as words. */
    fun word(): String = when (element) {
        is String -> element
        is JsonNumber -> element.text
        is Boolean -> "$element"
        else -> wrongType("text in quotes, a number, true or false")
    }

    /** Returns the items of a list, or this node alone if it is none. */
    fun itemsOrSelf(): List<JsonNode> = if (element is List<*>) items() else listOf(this)

    /** Returns the enum constant for this text, which must be one of the [names]. */
    fun <T> choice(names: Map<String, T>): T {
        val text = text()
        val known = names.keys.joinToString { "\"$it\"" }
        return names[text] ?: fail("\"$text\" is not known here", "write one of $known")
    }

    fun integer(): Int = literal("a whole number").toIntOrNull() ?: wrongType("a whole number")

    fun long(): Long = literal("a whole number").toLongOrNull() ?: wrongType("a whole number")

    fun double(): Double {
        special()?.let { return it }
        val text = literal("a number")
        return text.toDouble().also { if (it.isInfinite()) fail("$text is too large", TOO_LARGE_REMEDY) }
    }

    fun float(): Float {
        special()?.let { return it.toFloat() }
        val text = literal("a number")
        return text.toFloat().also { if (it.isInfinite()) fail("$text is too large", TOO_LARGE_REMEDY) }
    }

    /** Returns a list of exactly [count] numbers. */
    fun doubles(count: Int): DoubleArray {
        if (element !is List<*>) wrongType("a list of $count numbers")
        if (element.size != count) fail("needs $count numbers, not ${element.size}")
        return DoubleArray(count) { item(element, it).double() }
    }

    fun floats(): FloatArray {
        if (element !is List<*>) wrongType("a list of numbers")
        return FloatArray(element.size) { finiteOrNull(element[it]) ?: item(element, it).float() }
    }

    fun integers(): IntArray {
        if (element !is List<*>) wrongType("a list of whole numbers")
        return IntArray(element.size) { wholeOrNull(element[it]) ?: item(element, it).integer() }
    }

    private fun item(list: List<*>, index: Int): JsonNode {
        source.step()
        return JsonNode(source, "$path[$index]", list[index])
    }

    private fun wholeOrNull(item: Any?): Int? {
        source.step()
        return (item as? JsonNumber)?.text?.toIntOrNull()
    }

    /** Fast path for the long lists of meshes: needs no path and no node. Null if [item] is not a finite number. */
    private fun finiteOrNull(item: Any?): Float? {
        source.step()
        return (item as? JsonNumber)?.text?.toFloat()?.takeIf { it.isFinite() }
    }

    private fun literal(wanted: String): String {
        if (element !is JsonNumber) wrongType(wanted)
        return element.text
    }

    /** Returns NaN or an infinity, which are written in quotes because JSON has no such numbers; otherwise null. */
    private fun special(): Double? = when {
        element == "NaN" -> Double.NaN
        element == "Infinity" -> Double.POSITIVE_INFINITY
        element == "-Infinity" -> Double.NEGATIVE_INFINITY
        else -> null
    }

    private fun children(members: Map<*, *>): Map<String, JsonNode> {
        val children = LinkedHashMap<String, JsonNode>()
        for ((key, value) in members) {
            source.step()
            key as String
            children[key] = JsonNode(source, JsonKeys.path(path, key), value)
        }
        return children
    }

    private fun wrongType(wanted: String): Nothing {
        val found = when (element) {
            is Map<*, *> -> "an object"
            is List<*> -> "a list"
            is String -> "the text \"${element.take(MOST_SHOWN)}\""
            else -> element.toString().take(MOST_SHOWN)
        }
        fail("must be $wanted, not $found")
    }

    override fun toString(): String = "JsonNode($path)"

    private companion object {
        const val MOST_SHOWN = 40
        const val TOO_LARGE_REMEDY = "write \"Infinity\" if infinity is intended"
    }
}

/** The members of an object by their keys. */
internal class JsonMembers(
    private val node: JsonNode,
    private val known: List<String>,
    private val values: Map<String, JsonNode>,
) {
    operator fun get(key: String): JsonNode? = values[key]

    fun required(key: String): JsonNode = values[key] ?: node.fail("\"$key\" is missing", "add it")

    /** Returns the origin that positions are relative to. */
    fun origin(): Vector3d = values["origin"]?.doubles(3)?.let { Vector3d(it[0], it[1], it[2]) } ?: Vector3d()

    /** Returns the only member present out of [kinds], which exclude each other. */
    fun one(vararg kinds: String): Pair<String, JsonNode> {
        val present = kinds.filter { it in values }
        val choices = kinds.joinToString { "\"$it\"" }
        if (present.size > 1) {
            node.fail("has ${present.joinToString(" and ") { "\"$it\"" }}", "keep one of $choices")
        }
        val kind = present.firstOrNull() ?: node.fail("has no kind", "add one of $choices")
        return kind to values.getValue(kind)
    }

    override fun toString(): String = "JsonMembers(${values.keys} of $known)"
}

/** Helpers for JSON paths and misspelt keys. */
internal object JsonKeys {
    /** Returns the path of member [key] of the object at [path]. */
    fun path(path: String, key: String): String = when {
        !isIdentifier(key) -> "$path[\"$key\"]"
        path.isEmpty() -> key
        else -> "$path.$key"
    }

    private fun isIdentifier(key: String): Boolean {
        val first = key.firstOrNull() ?: return false
        return (isLetter(first) || first == '_') && key.all { isLetter(it) || it in '0'..'9' || it in "_-" }
    }

    private fun isLetter(character: Char): Boolean = character in 'a'..'z' || character in 'A'..'Z'

    /** Returns the word of [known] that differs the least from [key], in at most two edits, or null. */
    fun nearest(key: String, known: List<String>): String? =
        known.filter { StrictMath.abs(it.length - key.length) <= MAX_EDITS }
            .map { it to EditDistance.between(key, it) }
            .filter { (word, edits) -> edits <= MAX_EDITS && edits < word.length / 2 }
            .minByOrNull { it.second }
            ?.first

    private const val MAX_EDITS = 2
}
