package dev.lazyz.scenes.gltf.document

import com.fasterxml.jackson.databind.JsonMappingException
import com.fasterxml.jackson.databind.JsonNode
import com.fasterxml.jackson.databind.exc.MismatchedInputException

/** Says what is wrong with a value whose type is not the expected one. */
internal object WrongTypes {
    private const val MAX_NUMBER = 40

    /** Returns which type is expected where [e] occurred in [tree], and what is there. */
    fun problem(e: JsonMappingException, tree: JsonNode): String {
        // A value where a list is expected is read as the only element of a list
        val found = e.path.fold(tree) { node, step ->
            when {
                step.fieldName != null -> node.path(step.fieldName)
                node.isArray -> node.path(step.index)
                else -> node
            }
        }

        // For an element of an array, Jackson names the type of the array
        val type = (e as? MismatchedInputException)?.targetType
        val isElement = e.path.lastOrNull()?.fieldName == null
        val wanted = if (isElement) type?.componentType ?: type else type
        return "${expected(wanted)} is expected, not ${shown(found)}"
    }

    private fun expected(type: Class<*>?): String = when {
        type == null -> "a value of another type"
        type == Int::class.javaObjectType || type == Int::class.javaPrimitiveType -> "a whole number"
        Number::class.java.isAssignableFrom(type.kotlin.javaObjectType) -> "a number"
        type.kotlin == Boolean::class -> "true or false"
        type == String::class.java -> "text"
        type.isArray || Collection::class.java.isAssignableFrom(type) -> "a list"
        else -> "an object"
    }

    private fun shown(found: JsonNode): String = when {
        found.isTextual -> "text"
        found.isArray -> "a list"
        found.isObject -> "an object"
        else -> found.toString().take(MAX_NUMBER).ifEmpty { "nothing" }
    }
}
