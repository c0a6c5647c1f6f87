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

/**
 * Reads the triangles of an object, and the looks of their corners. Not thread safe.
 *
 * @param to the object
 * @param unused counts the features that are not shown
 */
internal class ThreeMfMeshReader(
    private val part: PackagePart,
    private val to: ThreeMfObject,
    private val unused: KindCounts,
) {
    private val numbers = DoubleArray(3)
    private val nearest = FloatArray(3)
    private val corners = IntArray(3)
    private val looks = IntArray(3)

    /** Reads the current element. */
    fun read() {
        part.forEachChild { name ->
            when (name) {
                "vertices" -> part.forEachChild { if (it == "vertex") readVertex() }
                "triangles" -> part.forEachChild { if (it == "triangle") readTriangle() }
                "beamlattice" -> countBeams()
                "trianglesets" -> Unit
                else -> unused.add(name)
            }
        }
    }

    private fun readVertex() {
        var found = 0
        for (i in 0 until part.attributeCount) {
            val axis = when (part.attributeName(i)) {
                "x" -> 0
                "y" -> 1
                "z" -> 2
                else -> continue
            }
            nearest[axis] = part.float(part.attribute(i))
            numbers[axis] = part.attribute(i).toDouble()
            found = found or (1 shl axis)
        }
        if (found != ALL) part.fail("the vertex lacks x, y or z")
        for (axis in 0 until 3) to.add(numbers[axis], nearest[axis])
    }

    private fun readTriangle() {
        var found = 0
        var group = -1
        looks.fill(-1)
        for (i in 0 until part.attributeCount) {
            when (part.attributeName(i)) {
                "v1" -> found = found or corner(0, i)
                "v2" -> found = found or corner(1, i)
                "v3" -> found = found or corner(2, i)
                "pid" -> group = part.whole(part.attribute(i))
                "p1" -> looks[0] = part.whole(part.attribute(i))
                "p2" -> looks[1] = part.whole(part.attribute(i))
                "p3" -> looks[2] = part.whole(part.attribute(i))

                // Filaments that slicers use for painting
                "paint_color", "mmu_segmentation" -> unused.add("painted triangles")
            }
        }
        if (found != ALL) part.fail("the triangle lacks v1, v2 or v3")
        if (looks[0] >= 0) addLooks(if (group >= 0) group else to.defaultGroup)
        for (corner in corners) to.triangles.add(corner)
    }

    private fun corner(number: Int, attribute: Int): Int {
        corners[number] = part.whole(part.attribute(attribute))
        val count = to.positions.size / 3
        if (corners[number] >= count) part.fail("vertex number ${corners[number]} is not one of the $count vertices")
        return 1 shl number
    }

    private fun addLooks(group: Int) {
        while (to.looks.size < to.triangles.size / 3 * 4) to.looks.add(-1)
        to.looks.add(group)
        for (look in looks) to.looks.add(if (look >= 0) look else looks[0])
    }

    private fun countBeams() {
        part.forEachChild { if (it == "beams") part.forEachChild { unused.add("beams") } }
    }

    private companion object {
        /** One bit for each of three corners or coordinates, all set. */
        const val ALL = 7
    }
}
