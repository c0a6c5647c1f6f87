package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.collections.KindCounts

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
