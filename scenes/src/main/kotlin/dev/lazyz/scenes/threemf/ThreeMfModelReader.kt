package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.LengthUnit
import dev.lazyz.scenes.collections.KindCounts
import org.joml.Matrix4d

/**
 * Reads a model part (3MF Consortium, "3MF Core Specification", version 1.3.0, with "Production Extension", version
 * 1.1.2). Namespaces of names are ignored. Not thread safe.
 *
 * @param unused counts the features that are not shown
 */
internal class ThreeMfModelReader(private val part: PackagePart, path: String, private val unused: KindCounts) {
    private val model = ThreeMfModel(path)
    private val looks = ThreeMfLooksReader(part, model.looks, unused)

    fun read(): ThreeMfModel {
        part.forEachChild { root ->
            if (root != "model") part.fail("the element is $root, not model", "check what kind of file it is")
            requireExtensions()
            part.attribute("unit")?.let { model.unit = UNITS[it.trim().lowercase()] ?: model.unit }
            part.forEachChild { name ->
                when (name) {
                    "resources" -> part.forEachChild { readResource(it) }
                    "build" -> part.forEachChild { if (it == "item") model.items.add(placement()) }
                    !in IRRELEVANT -> unused.add(name)
                }
            }
        }
        part.close()
        return model
    }

    /** Fails if the file requires an extension that is not supported (section 2.3.2 and 3.4). */
    private fun requireExtensions() {
        for (prefix in part.words("requiredextensions")) {
            val namespace = part.namespace(prefix)
                ?: part.fail("the required extension \"$prefix\" is not declared: there is no xmlns:$prefix")
            if (namespace == SLICES) {
                model.requiresSlices = true
            } else if (namespace !in EXTENSIONS) {
                part.fail("the file requires the extension $namespace, which is not supported", "export it without")
            }
        }
    }

    private fun readResource(name: String) {
        part.source.loading.items(part.source, 1)
        if (name == "object") {
            readObject()
        } else if (!looks.read(name) && name !in IRRELEVANT) {
            unused.add(name)
        }
    }

    private fun readObject() {
        val number = part.number("id") ?: part.fail("the object has no id")
        val type = part.attribute("type")
        val found = ThreeMfObject(type == "support" || type == "solidsupport", part.attribute("name") ?: "")
        part.number("pid")?.let { found.defaultGroup = it }
        part.number("pindex")?.let { found.defaultIndex = it }
        if (part.attribute("slicestackid") != null) unused.add("slicestackid")
        if (model.objects.put(number, found) != null) part.fail("two objects have the id $number")
        part.forEachChild { name ->
            when (name) {
                "mesh" -> ThreeMfMeshReader(part, found, unused).read()
                "components" -> part.forEachChild { if (it == "component") found.components.add(placement()) }
                !in IRRELEVANT -> unused.add(name)
            }
        }
    }

    private fun placement(): ObjectReference {
        part.source.loading.items(part.source, 1)
        val number = part.number("objectid") ?: part.fail("there is no objectid")
        return ObjectReference(part.attribute("path") ?: model.path, number, transform())
    }

    /**
     * Returns the transform of the current element, or the identity if it has none. The file multiplies row vectors by
     * matrices and stores matrices by rows. JOML multiplies matrices by column vectors and stores matrices by columns.
     * The numbers are therefore in the same order.
     */
    private fun transform(): Matrix4d {
        val text = part.attribute("transform") ?: return Matrix4d()
        val numbers = part.words("transform").map { part.float(it).toDouble() }
        if (numbers.size != 12 || numbers.any { !it.isFinite() }) {
            part.fail("a transform is 12 numbers, not \"$text\"")
        }
        return Matrix4d().also { matrix ->
            for (row in 0 until 4) for (column in 0 until 3) matrix.set(row, column, numbers[3 * row + column])
        }
    }

    private companion object {
        /** Elements that do not affect the picture. */
        val IRRELEVANT = setOf("metadata", "metadatagroup", "trianglesets")

        /** The names of units (section 3.3). */
        val UNITS = mapOf(
            "micron" to LengthUnit.MICROMETRE,
            "millimeter" to LengthUnit.MILLIMETRE,
            "centimeter" to LengthUnit.CENTIMETRE,
            "meter" to LengthUnit.METRE,
            "inch" to LengthUnit.INCH,
            "foot" to LengthUnit.FOOT,
        )

        /** The slice extension; most files that require it contain triangles, too. */
        const val SLICES = "http://schemas.microsoft.com/3dmanufacturing/slice/2015/07"

        /** Materials, production, and sets of triangles, which do not affect the picture. */
        val EXTENSIONS = setOf(
            "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
            "http://schemas.microsoft.com/3dmanufacturing/production/2015/06",
            "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
        )
    }
}
