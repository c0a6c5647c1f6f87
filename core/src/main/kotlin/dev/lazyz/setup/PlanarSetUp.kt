package dev.lazyz.setup

import dev.lazyz.AlphaMode
import dev.lazyz.Camera
import dev.lazyz.FillRule
import dev.lazyz.Material
import dev.lazyz.Mesh
import dev.lazyz.Polygon
import dev.lazyz.Primitive
import dev.lazyz.Projection
import dev.lazyz.Shading
import dev.lazyz.Sides
import dev.lazyz.Transforms
import kotlin.math.sqrt

/** Makes primitives of triangles and polygons. */
internal class PlanarSetUp(private val camera: Camera, private val viewport: Viewport, private val lighting: Lighting) {
    private val raster = viewport.raster
    private val clipper = Clipper(viewport.guardX, viewport.guardY)

    private val worldToClip =
        Transforms.product(camera.projectionMatrix(raster.width.toDouble() / raster.height), camera.viewMatrix())

    fun mesh(mesh: Mesh): Sequence<Primitive> = sequence {
        val vertices = meshVertices(mesh)
        val face = face(
            mesh.material, hasNormals = mesh.normals != null, hasUvs = mesh.uvs != null,
            hasColors =
            mesh.colors != null
        )
        val ends = intArrayOf(3)
        for (i in mesh.triangles.indices step 3) {
            val corners = intArrayOf(mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2])
            yield(face.primitive(vertices, corners, ends, FillRule.NON_ZERO))
        }
    }

    fun polygon(polygon: Polygon): Primitive {
        val contours = polygon.contours.filter { it.isNotEmpty() }
        val corners = contours.flatten()
        if (corners.size < 3) return EmptyPrimitive
        val vertices = Vertices(corners.size)
        for ((i, corner) in corners.withIndex()) {
            place(vertices, i, corner.x, corner.y, corner.z)
            vertices.set(i, Vertices.UV, corner.u.toDouble())
            vertices.set(i, Vertices.UV + 1, corner.v.toDouble())
            vertices.set(i, Vertices.COLOR, corner.color.red.toDouble())
            vertices.set(i, Vertices.COLOR + 1, corner.color.green.toDouble())
            vertices.set(i, Vertices.COLOR + 2, corner.color.blue.toDouble())
            vertices.set(i, Vertices.COLOR + 3, corner.color.alpha.toDouble())
        }
        val ends = IntArray(contours.size)
        var end = 0
        for ((i, contour) in contours.withIndex()) {
            end += contour.size
            ends[i] = end
        }
        val face = face(polygon.material, hasNormals = false, hasUvs = true, hasColors = true)
        return face.primitive(vertices, IntArray(corners.size) { it }, ends, polygon.fillRule)
    }

    /** Transforms all vertices of [mesh]. */
    private fun meshVertices(mesh: Mesh): Vertices {
        val vertices = Vertices(mesh.vertexCount)
        for (i in 0 until mesh.vertexCount) {
            val p = mesh.positions
            place(vertices, i, p[3 * i].toDouble(), p[3 * i + 1].toDouble(), p[3 * i + 2].toDouble())
            mesh.normals?.let { for (k in 0 until 3) vertices.set(i, Vertices.NORMAL + k, it[3 * i + k].toDouble()) }
            mesh.uvs?.let { for (k in 0 until 2) vertices.set(i, Vertices.UV + k, it[2 * i + k].toDouble()) }
            for (k in 0 until 4) vertices.set(i, Vertices.COLOR + k, mesh.colors?.get(4 * i + k)?.toDouble() ?: 1.0)
        }
        return vertices
    }

    /** Sets the clip-space and the world position of a vertex. */
    private fun place(vertices: Vertices, vertex: Int, x: Double, y: Double, z: Double) {
        val m = worldToClip
        vertices.set(vertex, Vertices.X, m.m00() * x + m.m10() * y + m.m20() * z + m.m30())
        vertices.set(vertex, Vertices.Y, m.m01() * x + m.m11() * y + m.m21() * z + m.m31())
        vertices.set(vertex, Vertices.Z, m.m02() * x + m.m12() * y + m.m22() * z + m.m32())
        vertices.set(vertex, Vertices.W, m.m03() * x + m.m13() * y + m.m23() * z + m.m33())
        vertices.set(vertex, Vertices.WORLD, x)
        vertices.set(vertex, Vertices.WORLD + 1, y)
        vertices.set(vertex, Vertices.WORLD + 2, z)
    }

    private fun face(material: Material, hasNormals: Boolean, hasUvs: Boolean, hasColors: Boolean): FaceSetUp {
        val isPrelit = material.shader == null &&
            (material.shading == Shading.FLAT || material.shading == Shading.GOURAUD)
        val isLit =
            material.shader != null || material.shading == Shading.PHONG || material.shading == Shading.BLINN_PHONG
        var fields = 0
        if (isLit) fields = fields or PlanarPrimitive.WORLD or PlanarPrimitive.NORMAL
        if (hasUvs && (material.texture != null || material.shader != null)) fields = fields or PlanarPrimitive.UV
        if (hasColors || isPrelit) fields = fields or PlanarPrimitive.COLOR
        val usesFaceNormal = !hasNormals || (material.shader == null && material.shading == Shading.FLAT)
        return FaceSetUp(material, MaterialShader(material, lighting, isPrelit), fields, isPrelit, usesFaceNormal)
    }

    /** Sets up the faces of one surface. */
    private inner class FaceSetUp(
        private val material: Material,
        private val materialShader: MaterialShader,
        private val fields: Int,
        private val isPrelit: Boolean,
        private val usesFaceNormal: Boolean,
    ) {
        private val normal = DoubleArray(3)

        /** Returns the face with the given contours, ready for a renderer. */
        fun primitive(shared: Vertices, corners: IntArray, contourEnds: IntArray, fillRule: FillRule): Primitive {
            if (corners.any { !shared.isFinite(it) }) return EmptyPrimitive

            // Drop what is outside one plane or shows the wrong side
            var outside = -1
            var planes = 0
            for (corner in corners) {
                val code = clipper.outcode(shared, corner)
                outside = outside and code
                planes = planes or code
            }
            if (outside != 0) return EmptyPrimitive
            newellNormal(shared, corners, contourEnds)
            val isFront = towardEye(shared, corners[0]) >= 0.0
            if (!isFront && material.sides == Sides.FRONT) return EmptyPrimitive

            // Give the face vertices of its own where they differ from its neighbours'
            var vertices = shared
            var selection = corners
            var normalSign = 1.0
            if (usesFaceNormal || isPrelit) {
                vertices = shared.copyOf(corners)
                selection = IntArray(corners.size) { it }
                ownNormals(vertices, isFront)
                if (isPrelit) light(vertices)
            } else {
                normalSign = if (pointsToEye(shared, corners, isFront)) 1.0 else -1.0
            }

            // Cut, project and snap
            var ends = contourEnds
            if (planes != 0) {
                if (vertices === shared) {
                    vertices = shared.copyOf(corners)
                    selection = IntArray(corners.size) { it }
                }
                val contours = clipper.clip(vertices, split(selection, ends), planes)
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

        private fun assemble(
            vertices: Vertices,
            selection: IntArray,
            ends: IntArray,
            fillRule: FillRule,
            normalSign: Double,
        ): Primitive? {
            val xs = IntArray(selection.size) { viewport.gridX(vertices, selection[it]) }
            val ys = IntArray(selection.size) { viewport.gridY(vertices, selection[it]) }
            val depths = IntArray(selection.size) { viewport.depth(vertices, selection[it]) }
            val assembly = PlanarAssembly(vertices, selection, ends, xs, ys, depths)
            val isMasked = material.alphaMode == AlphaMode.MASK
            val all = if (isMasked) fields or PlanarPrimitive.UV or PlanarPrimitive.COLOR else fields
            val shader = material.shader ?: materialShader
            val isTranslucent = isTranslucent(vertices, selection)
            val whole = assembly.primitive(raster, fillRule, shader, all, normalSign, isTranslucent)
            if (!isMasked) return whole
            return whole?.let { MaskedPrimitive(it, materialShader, material.alphaCutoff) }
        }

        /** Whether some sample may be translucent: the material's doing or a vertex colour's. */
        private fun isTranslucent(vertices: Vertices, corners: IntArray): Boolean {
            if (material.isTranslucent) return true
            return material.alphaMode == AlphaMode.BLEND && corners.any { vertices.get(it, Vertices.COLOR + 3) != 1.0 }
        }

        /** The contours' common normal in world space (Newell's method), to scale; into [normal]. */
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

        /** Positive if the viewer is on the side of [normal] of a face with this vertex. */
        private fun towardEye(vertices: Vertices, vertex: Int): Double {
            val back = camera.toWorldDirection(0.0, 0.0, 1.0)
            if (camera.projection is Projection.Perspective) {
                back.x = camera.eye.x() - vertices.get(vertex, Vertices.WORLD)
                back.y = camera.eye.y() - vertices.get(vertex, Vertices.WORLD + 1)
                back.z = camera.eye.z() - vertices.get(vertex, Vertices.WORLD + 2)
            }
            return normal[0] * back.x + normal[1] * back.y + normal[2] * back.z
        }

        /** Whether the vertices' own normals, on the whole, point to the side that the viewer sees. */
        private fun pointsToEye(vertices: Vertices, corners: IntArray, isFront: Boolean): Boolean {
            var along = 0.0
            for (corner in corners) {
                for (k in 0 until 3) along += vertices.get(corner, Vertices.NORMAL + k) * normal[k]
            }
            return (along >= 0.0) == isFront
        }

        /** Gives all vertices normals that face the viewer: the face's, or their own turned round where necessary. */
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
            }
        }

        /** Lights each vertex; under flat shading all of them as the middle of the face. */
        private fun light(vertices: Vertices) {
            if (material.shading == Shading.FLAT) {
                for (k in 0 until 3) {
                    var sum = 0.0
                    for (vertex in 0 until vertices.count) sum += vertices.get(vertex, Vertices.WORLD + k)
                    val mean = sum / vertices.count
                    for (vertex in 0 until vertices.count) vertices.set(vertex, Vertices.WORLD + k, mean)
                }
            }
            val scratch = FloatArray(6)
            for (vertex in 0 until vertices.count) materialShader.litColor(vertices, vertex, scratch)
        }

        private fun split(selection: IntArray, ends: IntArray): List<IntArray> =
            ends.indices.map { selection.copyOfRange(if (it == 0) 0 else ends[it - 1], ends[it]) }
    }
}
