package dev.lazyz.scenes.gltf.document

import de.javagl.jgltf.impl.v2.GlTFProperty

/** Access to the values of extensions, which jgltf stores as nested maps. */
internal object ExtensionValues {
    /** Returns the object of the extension [name] on [property], or null. */
    fun of(property: GlTFProperty?, name: String): Map<*, *>? = property?.extensions?.get(name) as? Map<*, *>

    /** Returns a number in an extension's object, or [missing] if there is no finite number. */
    fun number(extension: Map<*, *>, name: String, missing: Double): Double =
        (extension[name] as? Number)?.toDouble()?.takeIf { it.isFinite() } ?: missing

    /** Returns a pair of numbers in an extension's object. [missing] replaces each that is not a finite number. */
    fun pair(extension: Map<*, *>, name: String, missing: Double): List<Double> =
        List(2) {
            ((extension[name] as? List<*>)?.getOrNull(it) as? Number)?.toDouble()?.takeIf { n -> n.isFinite() }
                ?: missing
        }
}
