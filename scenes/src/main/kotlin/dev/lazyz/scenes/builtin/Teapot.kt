package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh
import kotlin.math.sqrt
import org.joml.Vector3d

/**
 * Triangles of the teapot, y up, right-handed, counter-clockwise seen from outside.
 *
 * The arrays belong to the mesh and are not copied: callers must not change them.
 *
 * @property positions x, y, z per vertex. No coordinate is -0.
 * @property normals x, y, z per vertex, of unit length, pointing outward.
 * @property uvs u, v per vertex in 0..1. Each patch covers the whole square. Seen from outside, u runs to the right
 *   and v up the chain of patches, so that a texture is never mirrored.
 * @property triangles three vertex numbers per triangle.
 */
internal class TeapotMesh(
    val positions: FloatArray,
    val normals: FloatArray,
    val uvs: FloatArray,
    val triangles: IntArray,
) {
    val vertexCount: Int get() = positions.size / 3

    val triangleCount: Int get() = triangles.size / 3

    override fun toString(): String = "TeapotMesh($vertexCount vertices, $triangleCount triangles)"
}

/** The Utah teapot as triangles. For the control points and their source see [TeapotControlPoints]. */
internal object Teapot {
    /** The finest tessellation: about two million vertices. */
    const val MAX_SEGMENTS: Int = 256

    /**
     * Divides each side of each of the 32 patches into [segments].
     *
     * With n [segments] there are `32 (n + 1)^2` vertices, patch after patch in the order of [TeapotPatches.all], and
     * `64 n^2 - 8 n` triangles; the missing `8 n` are degenerate, at the knob and at the centre of the bottom, and
     * are omitted. Neighbouring patches have separate vertices along their common border, at positions that are bit
     * for bit the same.
     *
     * The published axes (x, y, z), z up, become (x, z, -y), y up: the pot stands on y = 0, with the spout towards
     * +x. Heights are as published. The surface is open between rim and lid, at both ends of the handle, where the
     * spout enters the body, and inside the lip of the spout. The inside is visible through the gap at the rim and
     * through the mouth of the spout.
     *
     * Cost: linear in the number of vertices. Thread-safe; every call returns a new mesh.
     *
     * @throws IllegalArgumentException if [segments] is not in 1..[MAX_SEGMENTS].
     */
    fun tessellate(segments: Int): TeapotMesh {
        require(segments in 1..MAX_SEGMENTS) { "segments must be in 1..$MAX_SEGMENTS: $segments" }
        return TeapotTessellation(segments, TeapotPatches.all).mesh
    }
}

/**
 * Tessellates patches into [segments] by [segments] cells each, as one mesh with y up.
 *
 * Every patch has u to the right and v down, seen from outside.
 */
internal class TeapotTessellation(private val segments: Int, patches: List<BezierPatch>) {
    private val side = segments + 1
    private val basis = CubicBasis(segments)
    private val positions = FloatArray(3 * patches.size * side * side)
    private val normals = FloatArray(positions.size)
    private val uvs = FloatArray(2 * patches.size * side * side)
    private val triangles = IntArray(6 * patches.size * segments * segments)
    private var vertexCount = 0
    private var indexCount = 0

    // The points of the four rows at one u, and their derivatives with respect to u
    private val rowPoints = DoubleArray(BezierPatch.SIDE * BezierPatch.AXES)
    private val rowTangents = DoubleArray(BezierPatch.SIDE * BezierPatch.AXES)

    /** The mesh of all patches, in order. */
    val mesh: TeapotMesh

    init {
        for (patch in patches) add(patch)
        mesh = TeapotMesh(positions, normals, uvs, triangles.copyOf(indexCount))
    }

    private fun add(patch: BezierPatch) {
        val first = vertexCount
        for (column in 0..segments) {
            cutRows(patch, column)
            for (row in 0..segments) addVertex(first + row * side + column, column, row)
        }
        vertexCount += side * side
        addTriangles(first)
    }

    /** Reduces [patch] to the cubic curve along v at [column]. */
    private fun cutRows(patch: BezierPatch, column: Int) {
        for (row in 0 until BezierPatch.SIDE) {
            for (axis in 0 until BezierPatch.AXES) {
                val at = row * BezierPatch.AXES + axis
                val first = row * BezierPatch.SIDE * BezierPatch.AXES + axis
                rowPoints[at] = basis.value(patch.controlPoints, first, BezierPatch.AXES, column)
                rowTangents[at] = basis.slope(patch.controlPoints, first, BezierPatch.AXES, column)
            }
        }
    }

    private fun addVertex(vertex: Int, column: Int, row: Int) {
        // Position
        storeYUp(positions, vertex, along(rowPoints, 0, row), along(rowPoints, 1, row), along(rowPoints, 2, row))
        uvs[2 * vertex] = (column.toDouble() / segments).toFloat()
        uvs[2 * vertex + 1] = ((segments - row).toDouble() / segments).toFloat()
        // Derivative with respect to u
        var ux = along(rowTangents, 0, row)
        var uy = along(rowTangents, 1, row)
        var uz = along(rowTangents, 2, row)
        if (ux == 0.0 && uy == 0.0 && uz == 0.0) {
            // The border row is a single point: use the next control row, which has the direction of the limit
            val next = BezierPatch.AXES * if (row == 0) 1 else BezierPatch.SIDE - 2
            ux = rowTangents[next]
            uy = rowTangents[next + 1]
            uz = rowTangents[next + 2]
        }
        // Derivative with respect to v, which runs down
        val vx = basis.slope(rowPoints, 0, BezierPatch.AXES, row)
        val vy = basis.slope(rowPoints, 1, BezierPatch.AXES, row)
        val vz = basis.slope(rowPoints, 2, BezierPatch.AXES, row)
        // The cross product of down and right points outward
        val nx = vy * uz - vz * uy
        val ny = vz * ux - vx * uz
        val nz = vx * uy - vy * ux
        val length = sqrt(nx * nx + ny * ny + nz * nz)
        check(length > 0.0) { "no normal at column $column, row $row of $segments" }
        storeYUp(normals, vertex, nx / length, ny / length, nz / length)
    }

    private fun along(rows: DoubleArray, axis: Int, row: Int): Double = basis.value(rows, axis, BezierPatch.AXES, row)

    private fun storeYUp(target: FloatArray, vertex: Int, x: Double, y: Double, z: Double) {
        // Adding 0 to x and z turns -0 into 0, so that equal points have equal bits
        target[3 * vertex] = (x + 0.0).toFloat()
        target[3 * vertex + 1] = (z + 0.0).toFloat()
        target[3 * vertex + 2] = (0.0 - y).toFloat()
    }

    private fun addTriangles(first: Int) {
        for (row in 0 until segments) {
            for (column in 0 until segments) {
                val upperLeft = first + row * side + column
                val lowerLeft = upperLeft + side
                addTriangle(upperLeft, lowerLeft, lowerLeft + 1)
                addTriangle(upperLeft, lowerLeft + 1, upperLeft + 1)
            }
        }
    }

    /** Adds the triangle unless two of its corners coincide. */
    private fun addTriangle(a: Int, b: Int, c: Int) {
        if (coincide(a, b) || coincide(b, c) || coincide(c, a)) return
        triangles[indexCount++] = a
        triangles[indexCount++] = b
        triangles[indexCount++] = c
    }

    private fun coincide(a: Int, b: Int): Boolean = positions[3 * a] == positions[3 * b] &&
        positions[3 * a + 1] == positions[3 * b + 1] && positions[3 * a + 2] == positions[3 * b + 2]
}

/** The Utah teapot in glazed pottery. */
internal object TeapotScene {
    fun scene(segments: Int): Scene {
        val teapot = Teapot.tessellate(segments)
        val material = Material(
            baseColor = Rgba.ofRgb(0xC8643C),
            shading = Shading.BLINN_PHONG,
            specular = Rgba(0.45f, 0.43f, 0.40f),
            shininess = 64,
            name = "pottery",
        )

        // v increases upwards in the patches, downwards in a texture
        val uvs = FloatArray(teapot.uvs.size) { if (it % 2 == 0) teapot.uvs[it] else 1f - teapot.uvs[it] }
        return Scene(
            surfaces = listOf(Mesh(teapot.positions, teapot.triangles, material, teapot.normals, uvs)),
            lights = listOf(
                Light.Ambient(Rgba(0.12f, 0.13f, 0.16f)),
                Light.Directional(Vector3d(0.5, -0.9, -0.7), Rgba(0.85f, 0.82f, 0.76f)),
                Light.Directional(Vector3d(-0.9, 0.2, -0.2), Rgba(0.15f, 0.14f, 0.13f)),
            ),
            viewpoint = Camera.fit(azimuth = 25.0, elevation = 24.0),
            background = Rgba.ofRgb(0xE9EDF0),
        )
    }
}

/**
 * The cubic Bernstein polynomials, and the quadratic ones of their derivative, at the parameters 0, 1/n, ..., 1.
 *
 * Uses only `+ - * /` in double precision, so the values are bit for bit the same on every machine. A curve and its
 * reverse (control points in reverse order) have bit for bit the same points at mirrored parameters, and a curve
 * starts and ends exactly at its outer control points. Therefore patches with a common border meet without a crack.
 *
 * Source: Gerald Farin, "Curves and Surfaces for CAGD", the chapter on the Bernstein form.
 */
internal class CubicBasis(segments: Int) {
    private val weights = DoubleArray(4 * (segments + 1))
    private val slopeWeights = DoubleArray(3 * (segments + 1))

    init {
        for (step in 0..segments) {
            // Two divisions: 1 - t would round differently from the t of the opposite step
            val t = step.toDouble() / segments
            val s = (segments - step).toDouble() / segments
            weights[4 * step] = s * s * s
            weights[4 * step + 1] = 3.0 * (s * s) * t
            weights[4 * step + 2] = 3.0 * (t * t) * s
            weights[4 * step + 3] = t * t * t
            slopeWeights[3 * step] = 3.0 * (s * s)
            slopeWeights[3 * step + 1] = 6.0 * (s * t)
            slopeWeights[3 * step + 2] = 3.0 * (t * t)
        }
    }

    /** Returns the value at [step] of the cubic with the four coefficients at [first], [first] + [stride], ... */
    fun value(coefficients: DoubleArray, first: Int, stride: Int, step: Int): Double {
        val at = 4 * step
        // Add the outer and the inner terms in pairs: the sum is then the same for the reversed curve
        val outer = weights[at] * coefficients[first] + weights[at + 3] * coefficients[first + 3 * stride]
        val inner = weights[at + 1] * coefficients[first + stride] + weights[at + 2] * coefficients[first + 2 * stride]
        return outer + inner
    }

    /**
     * Returns the derivative of [value] with respect to the parameter. Exactly zero where the coefficients are equal.
     */
    fun slope(coefficients: DoubleArray, first: Int, stride: Int, step: Int): Double {
        val at = 3 * step
        val c1 = coefficients[first + stride]
        val c2 = coefficients[first + 2 * stride]
        val outer =
            slopeWeights[at] * (c1 - coefficients[first]) +
                slopeWeights[at + 2] * (coefficients[first + 3 * stride] - c2)
        return outer + slopeWeights[at + 1] * (c2 - c1)
    }
}
