package dev.lazyz.setup

import dev.lazyz.AlphaMode
import dev.lazyz.Camera
import dev.lazyz.FillRule
import dev.lazyz.Material
import dev.lazyz.Mesh
import dev.lazyz.Polygon
import dev.lazyz.Primitive
import dev.lazyz.Projection
import dev.lazyz.Shader
import dev.lazyz.Shading
import dev.lazyz.Sides
import kotlin.math.sqrt

/** Makes primitives of triangles and polygons. */
internal class PlanarSetUp(private val camera: Camera, private val viewport: Viewport, private val lighting: Lighting) {
    private val raster = viewport.raster
    private val back = camera.toWorldDirection(0.0, 0.0, 1.0)
    private val clipper = Clipper(viewport.guardX, viewport.guardY, viewport.near)
    private val worldToClip = camera.setUpMatrix(raster.width.toDouble() / raster.height)

    fun mesh(mesh: Mesh): Sequence<Primitive> = sequence {
        val vertices = meshVertices(mesh)
        val face = face(mesh)
        val ends = intArrayOf(3)
        for (i in mesh.triangles.indices step 3) {
            val corners = intArrayOf(mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2])
            yield(face.primitive(vertices, corners, ends, FillRule.NON_ZERO))
        }
    }

    /** Returns [mesh] as a batch whose first triangle has the submission index [first], if it is opaque; or null. */
    fun batch(mesh: Mesh, first: Int): TriangleBatch? {
        if (mesh.material.alphaMode != AlphaMode.OPAQUE) return null
        val snapped = SnappedVertices(mesh)
        val chunks = (mesh.vertexCount - 1) / CHUNK + 1
        inParallel(chunks) {
            snapped.snap(it * CHUNK, minOf((it + 1) * CHUNK, mesh.vertexCount))
        }

        // Triangles that have to be cut are set up one by one; those that show the wrong side are left out
        var hidden: LongArray? = null
        val exceptions = ArrayList<IndexedValue<Primitive>>()
        val isOneSided = mesh.material.sides == Sides.FRONT
        if (snapped.isOutside != null || isOneSided) {
            val bits = LongArray((mesh.triangleCount - 1 ushr TriangleBatch.WORD_SHIFT) + 1)
            val face = face(mesh)
            val vertices = Vertices(3)
            for (triangle in 0 until mesh.triangleCount) {
                val isOutside = snapped.isOutside(triangle)
                if (!isOutside && !(isOneSided && face.isBack(triangle, vertices))) continue
                bits[triangle ushr TriangleBatch.WORD_SHIFT] =
                    bits[triangle ushr TriangleBatch.WORD_SHIFT] or (1L shl triangle)
                if (!isOutside) continue
                val primitive = face.primitive(triangle)
                if (primitive !== EmptyPrimitive) exceptions.add(IndexedValue(triangle, primitive))
            }
            hidden = bits
        }
        return TriangleBatch(
            mesh, first, this, snapped.grid, snapped.inverseW, hidden, exceptions,
        )
    }

    /** The vertices of [mesh] on the grid. */
    private inner class SnappedVertices(private val mesh: Mesh) {
        val grid = IntArray(TriangleBatch.STRIDE * mesh.vertexCount)
        val inverseW = if (camera.projection is Projection.Perspective) DoubleArray(mesh.vertexCount) else null

        /** Which vertices are outside some plane, or nowhere; null if none is. */
        @Volatile
        var isOutside: BooleanArray? = null
            private set

        fun isOutside(triangle: Int): Boolean {
            val outside = isOutside ?: return false
            return outside[mesh.triangles[3 * triangle]] || outside[mesh.triangles[3 * triangle + 1]] ||
                outside[mesh.triangles[3 * triangle + 2]]
        }

        /** Transforms, projects and snaps the vertices [from] until [until], as [place] and [Viewport] do. */
        fun snap(from: Int, until: Int) {
            val m = worldToClip
            val p = mesh.positions
            for (i in from until until) {
                val px = p[3 * i].toDouble()
                val py = p[3 * i + 1].toDouble()
                val pz = p[3 * i + 2].toDouble()
                val x = m.m00() * px + m.m10() * py + m.m20() * pz + m.m30()
                val y = m.m01() * px + m.m11() * py + m.m21() * pz + m.m31()
                val z = m.m02() * px + m.m12() * py + m.m22() * pz + m.m32()
                val w = m.m03() * px + m.m13() * py + m.m23() * pz + m.m33()
                if (!clipper.isInside(x, y, z, w)) {
                    outside()[i] = true
                    continue
                }
                grid[TriangleBatch.STRIDE * i] = viewport.gridX(x, w)
                grid[TriangleBatch.STRIDE * i + 1] = viewport.gridY(y, w)
                grid[TriangleBatch.STRIDE * i + 2] = viewport.depth(z, w)
                if (inverseW != null) inverseW[i] = 1.0 / w
            }
        }

        @Synchronized
        private fun outside(): BooleanArray =
            isOutside ?: BooleanArray(mesh.vertexCount).also { isOutside = it }
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
            place(mesh, i, vertices, i)
            vertices.setAttributes(i, mesh, i)
        }
        return vertices
    }

    /** Sets the position of vertex [to] to that of the mesh's vertex [from]. */
    private fun place(mesh: Mesh, from: Int, vertices: Vertices, to: Int) {
        val p = mesh.positions
        place(vertices, to, p[3 * from].toDouble(), p[3 * from + 1].toDouble(), p[3 * from + 2].toDouble())
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

    /** Returns what sets up and shades the triangles of [mesh]; for one thread. */
    fun face(mesh: Mesh): FaceSetUp =
        face(mesh.material, mesh.normals != null, mesh.uvs != null, mesh.colors != null, mesh)

    private fun face(
        material: Material,
        hasNormals: Boolean,
        hasUvs: Boolean,
        hasColors: Boolean,
        mesh: Mesh? = null,
    ): FaceSetUp {
        val isPrelit = material.shader == null &&
            (material.shading == Shading.FLAT || material.shading == Shading.GOURAUD)
        val isLit =
            material.shader != null || material.shading == Shading.PHONG || material.shading == Shading.BLINN_PHONG
        var fields = 0
        if (isLit) fields = fields or PlanarPrimitive.WORLD or PlanarPrimitive.NORMAL
        if (hasUvs && (material.texture != null || material.shader != null)) fields = fields or PlanarPrimitive.UV
        if (hasColors || isPrelit) fields = fields or PlanarPrimitive.COLOR
        val usesFaceNormal = !hasNormals || (material.shader == null && material.shading == Shading.FLAT)
        return FaceSetUp(material, MaterialShader(material, lighting, isPrelit), fields, isPrelit, usesFaceNormal, mesh)
    }

    /** Sets up the faces of one surface. Belongs to one thread. */
    inner class FaceSetUp(
        private val material: Material,
        private val materialShader: MaterialShader,
        val fields: Int,
        private val isPrelit: Boolean,
        private val usesFaceNormal: Boolean,
        private val mesh: Mesh?,
    ) {
        private val normal = DoubleArray(3)

        /** What colours the faces. */
        val shader: Shader get() = material.shader ?: materialShader

        /** Whether attributes depend on which side of a face is seen, or on where it is. */
        private val isPlaced = isPrelit || fields and (PlanarPrimitive.WORLD or PlanarPrimitive.NORMAL) != 0

        /** Sets vertex [to] to the attributes of the mesh's vertex [from], as far as they matter. */
        fun load(vertices: Vertices, to: Int, from: Int) {
            val mesh = mesh!!
            if (isPlaced) {
                for (k in 0 until 3) vertices.set(to, Vertices.WORLD + k, mesh.positions[3 * from + k].toDouble())
            }
            vertices.setAttributes(to, mesh, from)
        }

        /** Gives a triangle of its own vertices normals and light; returns the sign that turns normals to the viewer. */
        fun turn(vertices: Vertices): Double {
            if (!isPlaced) return 1.0
            newellNormal(vertices, TRIANGLE, TRIANGLE_END)
            return turn(vertices, TRIANGLE, towardEye(vertices, 0) >= 0.0)
        }

        /** Whether triangle [triangle] of the mesh shows its back; [vertices] is scratch. */
        fun isBack(triangle: Int, vertices: Vertices): Boolean {
            val mesh = mesh!!
            for (i in 0 until 3) {
                val from = 3 * mesh.triangles[3 * triangle + i]
                for (k in 0 until 3) vertices.set(i, Vertices.WORLD + k, mesh.positions[from + k].toDouble())
            }
            newellNormal(vertices, TRIANGLE, TRIANGLE_END)
            return !(towardEye(vertices, 0) >= 0.0)
        }

        /** Returns triangle [triangle] of the mesh with vertices of its own. */
        fun primitive(triangle: Int): Primitive {
            val mesh = mesh!!
            val vertices = Vertices(3)
            for (i in 0 until 3) {
                place(mesh, mesh.triangles[3 * triangle + i], vertices, i)
                vertices.setAttributes(i, mesh, mesh.triangles[3 * triangle + i])
            }
            return primitive(vertices, intArrayOf(0, 1, 2), intArrayOf(3), FillRule.NON_ZERO)
        }

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
            if (usesFaceNormal || isPrelit) {
                vertices = shared.copyOf(corners)
                selection = IntArray(corners.size) { it }
            }
            val normalSign = turn(vertices, selection, isFront)

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

        /** Gives vertices of a face's own normals and light, where it needs them; returns the sign for shared ones. */
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
            val xs = IntArray(selection.size) { viewport.gridX(vertices, selection[it]) }
            val ys = IntArray(selection.size) { viewport.gridY(vertices, selection[it]) }
            val depths = IntArray(selection.size) { viewport.depth(vertices, selection[it]) }
            val assembly = PlanarAssembly(vertices, selection, ends, xs, ys, depths)
            val isMasked = material.alphaMode == AlphaMode.MASK
            val all = if (isMasked) fields or PlanarPrimitive.UV or PlanarPrimitive.COLOR else fields
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
            var x = back.x
            var y = back.y
            var z = back.z
            if (camera.projection is Projection.Perspective) {
                x = camera.eye.x() - vertices.get(vertex, Vertices.WORLD)
                y = camera.eye.y() - vertices.get(vertex, Vertices.WORLD + 1)
                z = camera.eye.z() - vertices.get(vertex, Vertices.WORLD + 2)
            }
            return normal[0] * x + normal[1] * y + normal[2] * z
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

    private companion object {
        /** Vertices that a thread snaps at a time. */
        const val CHUNK = 16_384

        val TRIANGLE = intArrayOf(0, 1, 2)
        val TRIANGLE_END = intArrayOf(3)
    }
}
