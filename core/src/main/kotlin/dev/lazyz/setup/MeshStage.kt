package dev.lazyz.setup

import dev.lazyz.Checkpoint
import dev.lazyz.EmptyPrimitive
import dev.lazyz.Primitive
import dev.lazyz.Workers
import dev.lazyz.geometry.FillRule
import dev.lazyz.shading.Lighting
import dev.lazyz.shading.MaterialShader
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Attributes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon

/** Converts meshes and polygons to primitives. */
internal class MeshStage(val stage: VertexStage, private val lighting: Lighting, private val workers: Workers) {
    /** Returns the triangles of [mesh] in order. Passes [checkpoint] while it transforms all vertices before that. */
    fun mesh(mesh: Mesh, checkpoint: Checkpoint): Sequence<Primitive> = sequence {
        val vertices = meshVertices(mesh, checkpoint)
        val face = face(mesh)
        val ends = intArrayOf(3)
        for (i in mesh.triangles.indices step 3) {
            val corners = intArrayOf(mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2])
            yield(face.primitive(vertices, corners, ends, FillRule.NON_ZERO))
        }
    }

    /**
     * Returns [mesh] as a batch whose first triangle has the submission index [first]; null if the mesh is not opaque.
     */
    fun batch(mesh: Mesh, first: Int, checkpoint: Checkpoint): TriangleBatch? {
        if (mesh.material.alphaMode != AlphaMode.OPAQUE) return null
        val snapped = SnappedVertices(stage, mesh)
        val chunks = (mesh.vertexCount - 1) / CHUNK + 1
        workers.forEach(chunks, checkpoint) { number, _ ->
            snapped.snap(number * CHUNK, minOf((number + 1) * CHUNK, mesh.vertexCount))
        }

        // Triangles that must be clipped are set up one by one; those whose visible side is not drawn are omitted
        var hidden: LongArray? = null
        val exceptions = ArrayList<IndexedValue<Primitive>>()
        val isOneSided = mesh.material.sides == Sides.FRONT
        if (snapped.isOutside != null || isOneSided) {
            val bits = LongArray(mesh.triangleCount + Long.SIZE_BITS - 1 ushr TriangleBatch.WORD_SHIFT)
            val face = face(mesh)
            val vertices = Vertices(3)
            for (triangle in 0 until mesh.triangleCount) {
                if (Checkpoint.isDue(triangle)) checkpoint.pass()
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
        return TriangleBatch(mesh, first, this, snapped.grid, snapped.inverseW, hidden, exceptions)
    }

    fun polygon(polygon: Polygon): Primitive {
        val contours = polygon.contours.filter { it.isNotEmpty() }
        val corners = contours.flatten()
        if (corners.size < 3) return EmptyPrimitive
        val vertices = Vertices(corners.size)
        for ((i, corner) in corners.withIndex()) {
            stage.place(vertices, i, corner.x, corner.y, corner.z)
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
    private fun meshVertices(mesh: Mesh, checkpoint: Checkpoint): Vertices {
        checkpoint.pass() // the arrays take time, too
        val vertices = Vertices(mesh.vertexCount, Vertices.strideOf(mesh))
        for (i in 0 until mesh.vertexCount) {
            if (Checkpoint.isDue(i)) checkpoint.pass()
            stage.place(vertices, i, mesh, i)
        }
        return vertices
    }

    /** Returns an object that sets up and shades the triangles of [mesh]; for one thread. */
    fun face(mesh: Mesh): FaceStage =
        face(mesh.material, mesh.normals != null, mesh.uvs != null, mesh.colors != null, mesh)

    private fun face(
        material: Material,
        hasNormals: Boolean,
        hasUvs: Boolean,
        hasColors: Boolean,
        mesh: Mesh? = null,
    ): FaceStage {
        val isPrelit = material.isLitEarly
        var fields = 0
        if (material.isLitLate) fields = fields or Attributes.WORLD or Attributes.NORMAL
        val isCustom = material.shader != null
        val maps = material.maps
        if (hasUvs && (isCustom || maps.any { it.uvSet == 0 })) fields = fields or Attributes.UV
        if (mesh?.uvs2 != null && (isCustom || maps.any { it.uvSet == 1 })) fields = fields or Attributes.UV2
        val usesTangents = material.isLitLate && material.usesTangents
        if (mesh?.tangents != null && (isCustom || usesTangents)) fields = fields or Attributes.TANGENT
        val hasPlaces = fields and (Attributes.UV or Attributes.UV2) != 0
        if (hasPlaces && material.usesFootprint) fields = fields or Attributes.FOOTPRINT
        if (hasColors || isPrelit) fields = fields or Attributes.COLOR
        val usesFaceNormal = !hasNormals || (isPrelit && material.shading == Shading.FLAT)
        val shader = MaterialShader(material, lighting, isPrelit)
        return FaceStage(stage, material, shader, fields, isPrelit, usesFaceNormal, mesh)
    }

    private companion object {
        /** Number of vertices in one task of a thread. */
        const val CHUNK = 16_384
    }
}

/** The vertices of [mesh], snapped to the grid. */
internal class SnappedVertices(private val stage: VertexStage, private val mesh: Mesh) {
    val grid = IntArray(TriangleBatch.STRIDE * mesh.vertexCount)
    val inverseW = if (stage.isPerspective) DoubleArray(mesh.vertexCount) else null

    /** By vertex: whether it is outside any plane or not finite; null if there is no such vertex. */
    @Volatile
    var isOutside: BooleanArray? = null
        private set

    fun isOutside(triangle: Int): Boolean {
        val outside = isOutside ?: return false
        return outside[mesh.triangles[3 * triangle]] || outside[mesh.triangles[3 * triangle + 1]] ||
            outside[mesh.triangles[3 * triangle + 2]]
    }

    /** Transforms, projects and snaps the vertices [from] until [until], see [VertexStage]. */
    fun snap(from: Int, until: Int) {
        val p = mesh.positions
        val viewport = stage.viewport
        for (i in from until until) {
            stage.toClip(p[3 * i].toDouble(), p[3 * i + 1].toDouble(), p[3 * i + 2].toDouble()) { x, y, z, w ->
                if (stage.clipper.isInside(x, y, z, w)) {
                    grid[TriangleBatch.STRIDE * i] = viewport.gridX(x, w)
                    grid[TriangleBatch.STRIDE * i + 1] = viewport.gridY(y, w)
                    grid[TriangleBatch.STRIDE * i + 2] = viewport.depth(z, w)
                    if (inverseW != null) inverseW[i] = 1.0 / w
                } else {
                    outside()[i] = true
                }
            }
        }
    }

    @Synchronized
    private fun outside(): BooleanArray =
        isOutside ?: BooleanArray(mesh.vertexCount).also { isOutside = it }
}
