package dev.lazyz.scenes.gltf.document


/** Access to the values of extensions, which are nested maps. */
internal object ExtensionValues {
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
