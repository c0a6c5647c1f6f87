package dev.lazyz.setup

import dev.lazyz.EmptyPrimitive
import dev.lazyz.Primitive
import dev.lazyz.geometry.FillRule
import dev.lazyz.shading.MaskedPrimitive
import dev.lazyz.shading.MaterialShader
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.Shader
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Mesh
import kotlin.math.sqrt

/** Sets up the faces of one surface. Used by one thread. */
internal class FaceStage(
    private val stage: VertexStage,
    private val material: Material,
    private val materialShader: MaterialShader,
    val fields: Int,
    private val isPrelit: Boolean,
    private val usesFaceNormal: Boolean,
    private val mesh: Mesh?,
) {
    private val normal = DoubleArray(3)

    /** The shader of all faces. */
    val shader: Shader get() = material.shader ?: materialShader

    /** Whether the attributes depend on the visible side of a face, or on its position. */
    private val isPlaced = isPrelit || fields and (Attributes.WORLD or Attributes.NORMAL) != 0

    /**
     * Whether faces only have attributes of the mesh, shared with neighbours: no light evaluated at vertices, no face
     * normals.
     */
    val isShared: Boolean = mesh != null && !isPrelit && (!usesFaceNormal || fields and Attributes.NORMAL == 0)

    /** Whether a face has a single colour if its vertices have the same colour. */
    private val mayBeConstant = mesh != null && material.shader == null && !isPrelit &&
        fields and Attributes.COLOR.inv() == 0

    /**
     * Whether triangle [triangle] of the mesh certainly has a single colour. False for triangles that are lit at their
     * vertices, even if the colours happen to be equal.
     */
    fun isConstant(triangle: Int): Boolean {
        val mesh = mesh!!
        val colors = mesh.colors
        if (!mayBeConstant || fields == 0 || colors == null) return mayBeConstant
        val a = 4 * mesh.triangles[3 * triangle]
        val b = 4 * mesh.triangles[3 * triangle + 1]
        val c = 4 * mesh.triangles[3 * triangle + 2]
        for (k in 0 until 4) {
            val bits = colors[a + k].toRawBits()
            if (colors[b + k].toRawBits() != bits || colors[c + k].toRawBits() != bits) return false
        }
        return true
    }

    /**
     * Returns the sign that makes the normals of [triangle] face the viewer, if the faces are [isShared]. [vertices] is
     * scratch memory.
     */
    fun normalSign(batch: TriangleBatch, triangle: Int, vertices: Vertices): Double {
        for (i in 0 until 3) {
            val corner = batch.corners[3 * triangle + i]
            vertices.setWorld(i, batch.mesh, corner)
            vertices.setNormal(i, batch.mesh, corner)
        }
        return turn(vertices)
    }

    /** Sets the attributes of vertex [to] that are needed to those of vertex [from] of the mesh. */
    fun load(vertices: Vertices, to: Int, from: Int) {
        val mesh = mesh!!
        if (isPlaced) {
            vertices.setWorld(to, mesh, from)
            vertices.setNormal(to, mesh, from)
        }
        if (fields and Attributes.UV != 0) vertices.setUv(to, mesh, from)
        if (fields and Attributes.COLOR != 0) vertices.setColor(to, mesh, from)
        if (fields and Attributes.UV2 != 0) vertices.setUv2(to, mesh, from)
        if (fields and Attributes.TANGENT != 0) vertices.setTangent(to, mesh, from)
    }

    /**
     * Sets normals and light of a triangle whose vertices are not shared, as far as needed. Returns the sign that makes
     * the normals face the viewer.
     */
    fun turn(vertices: Vertices): Double {
        if (!isPlaced) return 1.0
        newellNormal(vertices, TRIANGLE, TRIANGLE_END)
        return turn(vertices, TRIANGLE, stage.towardEye(vertices, 0, normal) >= 0.0)
    }

    /** Whether the back of triangle [triangle] of the mesh is visible. [vertices] is scratch memory. */
    fun isBack(triangle: Int, vertices: Vertices): Boolean {
        val mesh = mesh!!
        for (i in 0 until 3) vertices.setWorld(i, mesh, mesh.triangles[3 * triangle + i])
        newellNormal(vertices, TRIANGLE, TRIANGLE_END)
        return !(stage.towardEye(vertices, 0, normal) >= 0.0)
    }

    /** Returns triangle [triangle] of the mesh as a primitive with its own vertices. */
    fun primitive(triangle: Int): Primitive {
        val mesh = mesh!!
        val vertices = Vertices(3, Vertices.strideOf(mesh))
        for (i in 0 until 3) stage.place(vertices, i, mesh, mesh.triangles[3 * triangle + i])
        return primitive(vertices, TRIANGLE, TRIANGLE_END, FillRule.NON_ZERO)
    }

    /** Returns the face with the given contours as a primitive. */
    fun primitive(shared: Vertices, corners: IntArray, contourEnds: IntArray, fillRule: FillRule): Primitive {
        if (corners.any { !shared.isFinite(it) }) return EmptyPrimitive

        // Discard faces that are outside one plane, or whose visible side is not drawn
        var outside = -1
        var planes = 0
        for (corner in corners) {
            val code = stage.clipper.outcode(shared, corner)
            outside = outside and code
            planes = planes or code
        }
        if (outside != 0) return EmptyPrimitive
        newellNormal(shared, corners, contourEnds)
        val isFront = stage.towardEye(shared, corners[0], normal) >= 0.0
        if (!isFront && material.sides == Sides.FRONT) return EmptyPrimitive

        // Copy the vertices if their attributes differ from those of neighbouring faces
        var vertices = shared
        var selection = corners
        if (usesFaceNormal || isPrelit) {
            vertices = shared.copyOf(corners)
            selection = IntArray(corners.size) { it }
        }
        val normalSign = turn(vertices, selection, isFront)

        // Clip, project and snap
        var ends = contourEnds
        if (planes != 0) {
            if (vertices === shared) {
                vertices = shared.copyOf(corners)
                selection = IntArray(corners.size) { it }
            }
            val contours = stage.clipper.clip(vertices, split(selection, ends), planes)
            selection = contours.flatMap { it.asIterable() }.toIntArray()
            if (selection.size < 3 || selection.any { !vertices.isFinite(it) }) return EmptyPrimitive
            ends = IntArray(contours.size)
            var end = 0
            for (i in contours.indices) {
                end += contours[i].size
                ends[i] = end
            }
        }
        return assemble(vertices, selection, ends, fillRule, normalSign).orEmpty()
    }

    /** Sets the face's normals and light if it has its own vertices for them. Returns the sign for shared normals. */
    private fun turn(vertices: Vertices, corners: IntArray, isFront: Boolean): Double {
        if (!usesFaceNormal && !isPrelit) return if (pointsToEye(vertices, corners, isFront)) 1.0 else -1.0
        ownNormals(vertices, isFront)
        if (isPrelit) light(vertices)
        return 1.0
    }

    private fun assemble(
        vertices: Vertices,
        selection: IntArray,
        ends: IntArray,
        fillRule: FillRule,
        normalSign: Double,
    ): Primitive? {
        val xs = IntArray(selection.size) { stage.viewport.gridX(vertices, selection[it]) }
        val ys = IntArray(selection.size) { stage.viewport.gridY(vertices, selection[it]) }
        val depths = IntArray(selection.size) { stage.viewport.depth(vertices, selection[it]) }
        val assembly = PrimitiveAssembly(vertices, selection, ends, xs, ys, depths)
        val isMasked = material.alphaMode == AlphaMode.MASK
        val all = if (isMasked) fields or Attributes.UV or Attributes.COLOR else fields
        val isTranslucent = isTranslucent(vertices, selection)
        val whole = assembly.primitive(stage.viewport.raster, fillRule, shader, all, normalSign, isTranslucent)
        if (!isMasked) return whole
        return whole?.let { MaskedPrimitive(it, materialShader, material.alphaCutoff) }
    }

    /** Whether any sample can be translucent, because of the material or a vertex colour. */
    private fun isTranslucent(vertices: Vertices, corners: IntArray): Boolean {
        if (material.isTranslucent) return true
        return material.alphaMode == AlphaMode.BLEND && corners.any { vertices.get(it, Vertices.COLOR + 3) != 1.0 }
    }

    /**
     * Computes the common normal of the contours in world space (Newell's method) into [normal]; its length is
     * arbitrary.
     */
    private fun newellNormal(vertices: Vertices, corners: IntArray, contourEnds: IntArray) {
        normal.fill(0.0)
        var start = 0
        for (end in contourEnds) {
            var previous = corners[end - 1]
            for (i in start until end) {
                val current = corners[i]
                val px = vertices.get(previous, Vertices.WORLD)
                val py = vertices.get(previous, Vertices.WORLD + 1)
                val pz = vertices.get(previous, Vertices.WORLD + 2)
                val cx = vertices.get(current, Vertices.WORLD)
                val cy = vertices.get(current, Vertices.WORLD + 1)
                val cz = vertices.get(current, Vertices.WORLD + 2)
                normal[0] += (py - cy) * (pz + cz)
                normal[1] += (pz - cz) * (px + cx)
                normal[2] += (px - cx) * (py + cy)
                previous = current
            }
            start = end
        }
    }

    /**
     * Whether most of the vertex normals point to the visible side: the sign of the sum of their products with the face
     * normal.
     */
    private fun pointsToEye(vertices: Vertices, corners: IntArray, isFront: Boolean): Boolean {
        var along = 0.0
        for (corner in corners) {
            for (k in 0 until 3) along += vertices.get(corner, Vertices.NORMAL + k) * normal[k]
        }
        return (along >= 0.0) == isFront
    }

    /** Makes all normals face the viewer: the face normal, or the vertex normals, all reversed if necessary. */
    private fun ownNormals(vertices: Vertices, isFront: Boolean) {
        val all = IntArray(vertices.count) { it }
        val sign = when {
            usesFaceNormal -> if (isFront) 1.0 else -1.0
            else -> if (pointsToEye(vertices, all, isFront)) 1.0 else -1.0
        }
        val length = sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2])
        for (vertex in all) {
            for (k in 0 until 3) {
                val component = if (usesFaceNormal) {
                    if (length > 0.0) normal[k] / length else 0.0
                } else {
                    vertices.get(vertex, Vertices.NORMAL + k)
                }
                vertices.set(vertex, Vertices.NORMAL + k, sign * component)
            }
            if (fields and Attributes.TANGENT == 0) continue
            for (k in Vertices.TANGENT until Vertices.TANGENT + 4) {
                vertices.set(vertex, k, sign * vertices.get(vertex, k))
            }
        }
    }

    /** Lights each vertex. With flat shading, all vertices are lit at the mean of their positions. */
    private fun light(vertices: Vertices) {
        val scratch = FloatArray(6)
        val mean = DoubleArray(3)
        for (k in 0 until 3) {
            for (vertex in 0 until vertices.count) mean[k] += vertices.get(vertex, Vertices.WORLD + k)
            mean[k] /= vertices.count
        }
        val at = DoubleArray(3)
        for (vertex in 0 until vertices.count) {
            for (k in 0 until 3) {
                at[k] = if (material.shading == Shading.FLAT) mean[k] else vertices.get(vertex, Vertices.WORLD + k)
            }
            materialShader.litColor(vertices, vertex, at, scratch)
        }
    }

    private fun split(selection: IntArray, ends: IntArray): List<IntArray> =
        ends.indices.map { selection.copyOfRange(if (it == 0) 0 else ends[it - 1], ends[it]) }

    private companion object {
        val TRIANGLE = intArrayOf(0, 1, 2)
        val TRIANGLE_END = intArrayOf(3)
    }
}
