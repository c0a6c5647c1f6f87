package dev.lazyz.scenes.gltf.document

/**
 * A JSON object of a glTF file with its place in the file.
 *
 * A value of the wrong type is an error. A value of the right type that the specification does not allow, such as a
 * negative count, is taken as missing, with a warning, because many files contain such values; factors outside their
 * range are clamped. A value where a list is expected is the only item of a list. Unknown members are allowed.
 *
 * @param path the place, for example `meshes[0].primitives[1]`; empty for the whole file
 */
internal class GltfObject(
    private val warnings: CountedWarnings,
    private val path: String,
    private val members: Map<*, *>,
) {
    init {
        warnings.source.step(1 + members.size)
    }

    fun text(name: String): String? = when (val value = members[name]) {
        null -> null
        is String -> value
        is Number, is Boolean -> value.toString()
        else -> wrongType(place(name), "text", value)
    }

    /** Returns one of the words in [valid], or null. */
    fun word(name: String, vararg valid: String): String? =
        text(name)?.let { if (it in valid) it else notAllowed(name, notOneOf(name, it, valid.asList())) }

    /** Returns true or false; numbers are true unless they are 0. */
    fun flag(name: String): Boolean? = when (val value = members[name]) {
        null -> null
        is Boolean -> value
        is Number -> value.toDouble() != 0.0
        else -> wrongType(place(name), "true or false", value)
    }

    /** Returns a whole number in [range], or null. */
    fun whole(name: String, range: IntRange = Int.MIN_VALUE..Int.MAX_VALUE): Int? {
        val value = members[name]?.let { whole(it, place(name)) } ?: return null
        return when {
            value < range.first -> notAllowed(name, "$name < ${range.first}")
            value > range.last -> notAllowed(name, "$name > ${range.last}")
            else -> value
        }
    }

    /** Returns one of the whole numbers in [valid], or null. */
    fun code(name: String, vararg valid: Int): Int? =
        whole(name)?.let { if (it in valid) it else notAllowed(name, notOneOf(name, it, valid.asList())) }

    /** Returns a number of at least [least] that is above [above], or null. */
    fun number(name: String, least: Float? = null, above: Float? = null): Float? {
        val value = members[name]?.let { number(it, place(name)).toFloat() } ?: return null
        return when {
            least != null && value < least -> notAllowed(name, "$name < $least")
            above != null && value <= above -> notAllowed(name, "$name <= $above")
            else -> value
        }
    }

    /** Returns a number, clamped to 0..1, or null. */
    fun fraction(name: String): Float? = members[name]?.let { value ->
        val number = number(value, place(name))
        clamped(name, doubleArrayOf(number), 0.0)[0]
    }

    /** Returns [count] numbers, or null. */
    fun floats(name: String, count: Int): FloatArray? =
        doubles(name, count)?.let { numbers -> FloatArray(count) { numbers[it].toFloat() } }

    /** Returns [count] numbers, clamped to [least]..1, or null. */
    fun fractions(name: String, count: Int, least: Double = 0.0): FloatArray? =
        doubles(name, count)?.let { clamped(name, it, least) }

    private fun doubles(name: String, count: Int): DoubleArray? {
        val value = members[name] ?: return null
        if (value is String || value is Map<*, *>) wrongType(place(name), "a list", value)
        val numbers = list(name) { item, where -> item?.let { number(it, where) } ?: 0.0 }.orEmpty()
        if (numbers.size < count) return notAllowed(name, "Number of $name elements is < $count")
        if (numbers.size > count) return notAllowed(name, "Number of $name elements is > $count")
        return numbers.toDoubleArray()
    }

    private fun clamped(name: String, numbers: DoubleArray, least: Double): FloatArray {
        var excess = 0.0
        val clamped = FloatArray(numbers.size) {
            val result = numbers[it].coerceIn(least, 1.0)
            excess = maxOf(excess, StrictMath.abs(numbers[it] - result))
            result.toFloat()
        }
        if (excess > ROUNDING) warnings.count("${kind(name)} is outside ${least.toInt()}..1 and is clamped")
        return clamped
    }

    /** Returns a list of numbers, in which null is allowed, or null. */
    fun numbers(name: String): List<Float?>? = list(name) { value, where -> value?.let { number(it, where).toFloat() } }

    /** Returns a list of element numbers, in which null is allowed, or null. */
    fun references(name: String): List<Int?>? {
        val all = list(name) { value, where -> value?.let { whole(it, where) } }
        return if (all != null && all.any { it != null && it < 0 }) notAllowed(name, "${name}Element < 0") else all
    }

    /** Returns element numbers by name, or null. */
    fun referencesByName(name: String): Map<String, Int?>? = members[name]?.let { referencesByName(it, place(name)) }

    /** Returns a list of element numbers by name, in which null is allowed, or null. */
    fun listOfReferencesByName(name: String): List<Map<String, Int?>?>? =
        list(name) { value, where -> value?.let { referencesByName(it, where) } }

    private fun referencesByName(value: Any, where: String): Map<String, Int?> =
        membersOf(value, where).entries.associate { (key, item) ->
            warnings.source.step()
            "$key" to item?.let { whole(it, "$where.$key") }
        }

    /** Returns a list of texts, without nulls; empty if there is none. */
    fun texts(name: String): List<String> = list(name) { value, where ->
        if (value is List<*> || value is Map<*, *>) wrongType(where, "text", value)
        value?.toString()
    }.orEmpty().filterNotNull()

    /** Returns what [make] makes of an object, or null. */
    fun <T : Any> one(name: String, make: (GltfObject) -> T): T? = members[name]?.let { make(child(it, place(name))) }

    /** Returns what [make] makes of each object in a list, null for null; empty if there is none. */
    fun <T : Any> all(name: String, make: (GltfObject) -> T): List<T?> =
        list(name) { value, where -> value?.let { make(child(it, where)) } }.orEmpty()

    /** Returns the objects of extensions by their names, or null. */
    fun extensions(): Map<*, *>? = members["extensions"]?.let { membersOf(it, place("extensions")) }

    /** Returns what [make] makes of the object of the extension [name], or null. */
    fun <T : Any> extension(name: String, make: (GltfObject) -> T): T? =
        extensions()?.get(name)?.let { make(child(it, "${place("extensions")}.$name")) }

    private fun child(value: Any, where: String) = GltfObject(warnings, where, membersOf(value, where))

    private fun membersOf(value: Any, where: String): Map<*, *> =
        value as? Map<*, *> ?: wrongType(where, "an object", value)

    private fun <T> list(name: String, item: (Any?, String) -> T): List<T>? = members[name]?.let { value ->
        val where = place(name)
        items(value).mapIndexed { i, it ->
            warnings.source.step()
            item(it, "$where[$i]")
        }
    }

    private fun items(value: Any): List<*> = value as? List<*> ?: listOf(value)

    /** Numbers with a fraction of 0, such as 1.0, are whole. */
    private fun whole(value: Any, where: String): Int {
        val number = (value as? Number)?.toDouble() ?: Double.NaN
        return number.toInt().takeIf { it.toDouble() == number } ?: wrongType(where, "a whole number", value)
    }

    private fun number(value: Any, where: String): Double =
        (value as? Number)?.toDouble() ?: wrongType(where, "a number", value)

    private fun place(name: String): String = if (path.isEmpty()) name else "$path.$name"

    /** Returns the place of [name] without numbers of elements. */
    private fun kind(name: String): String = place(name).split('[').joinToString("") { it.substringAfter(']') }

    private fun notOneOf(name: String, value: Any, valid: List<*>) = "Invalid value for $name: $value, valid: $valid"

    private fun notAllowed(name: String, problem: String): Nothing? {
        warnings.count("${kind(name)} is passed over", example = problem.lineSequence().first().take(MAX_PROBLEM))
        return null
    }

    private fun wrongType(where: String, wanted: String, found: Any): Nothing {
        val shown = when (found) {
            is String -> "text"
            is List<*> -> "a list"
            is Map<*, *> -> "an object"
            else -> found.toString().take(MAX_NUMBER)
        }
        warnings.source.fail(where, "$wanted is expected, not $shown", REMEDY)
    }

    companion object {
        /** What to do about JSON that is wrong. */
        const val REMEDY: String = "correct it or export the model again"

        /** What rounding may add to a number. A number that is farther outside its range causes a warning. */
        private const val ROUNDING = 1e-3
        private const val MAX_PROBLEM = 200
        private const val MAX_NUMBER = 40
    }
}
