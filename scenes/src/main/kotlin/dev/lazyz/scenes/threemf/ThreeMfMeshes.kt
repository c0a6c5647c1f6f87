package dev.lazyz.scenes.threemf

import dev.lazyz.Rgba
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.CornerMesh
import dev.lazyz.scenes.meshes.MeshParts
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Mesh

/** The look of triangles without their own: a group and an index in it. The group is -1 if there is no such look. */
internal data class DefaultLook(val group: Int, val index: Int)

/**
 * What covers triangles: the number of a texture, or -1, the colour on which the texture lies, or null, and how it
 * reflects light, or null.
 */
private data class Coat(val texture: Int, val ground: Rgba?, val finish: ThreeMfFinish?)

private val BARE = Coat(-1, null, null)

/** Builds meshes from the triangles of objects. Not thread safe. */
internal class ThreeMfMeshes(private val source: Source, private val textures: ThreeMfTextures) {
    /** Number of triangles that refer to looks that do not exist. */
    var withoutLooks = 0
        private set

    /**
     * Returns the triangles of [found], which [model] defines, with smooth normals: one mesh for each texture and
     * finish.
     */
    fun build(model: ThreeMfModel, found: ThreeMfObject, default: DefaultLook): List<Mesh> {
        if (found.triangles.size == 0) return emptyList()
        val mesh = CornerMesh(found.vertices(), model.looks.palette, model.looks.places)
        val coats = LinkedHashMap<Coat, Int>()
        val groupOf = Ints()
        for (triangle in 0 until found.triangles.size / 3) {
            source.step(3)
            val coat = addTriangle(model.looks, found, triangle, default, mesh)
            groupOf.add(coats.getOrPut(coat) { coats.size })
        }
        val whole = source.loading.smoothed(source, mesh.mesh(source), ThreeMfParser.CREASE_ANGLE)
        val parts = MeshParts(source, whole, groupOf, coats.size)
        val own = color(model.looks, default)
        return coats.map { (coat, group) ->
            val base = model.looks.textures[coat.texture]
            val map = base?.let { textures.find(it, coat.ground, coat.ground ?: own) }
            val isTranslucent = map?.texture?.hasAlpha ?: model.looks.palette.isTranslucent
            val isTextured = coat.finish?.textures != null
            val material = Material(
                baseColor = coat.ground.takeIf { map == null } ?: coat.finish?.factor ?: Rgba.WHITE,
                alphaMode = if (isTranslucent && !isTextured) AlphaMode.BLEND else AlphaMode.OPAQUE,
                name = found.name,
            ).withTextureMap(map).withMetallicRoughness(coat.finish?.model(model.looks, base, textures))
            parts.part(group).withMaterials { material }
        }
    }

    /** Returns the colour that [look] refers to, or white if it is none. */
    private fun color(looks: ThreeMfLooks, look: DefaultLook): Rgba {
        val group = looks.groups[look.group]
        if (group == null || group.texture >= 0 || look.index >= group.numbers.size) return group?.ground ?: Rgba.WHITE
        val color = FloatArray(4).also { looks.palette.copy(group.numbers[look.index], it, 0) }
        return Rgba(color[0], color[1], color[2], color[3])
    }

    /** Adds a triangle to [mesh], and returns what covers it. */
    private fun addTriangle(
        looks: ThreeMfLooks,
        found: ThreeMfObject,
        triangle: Int,
        default: DefaultLook,
        mesh: CornerMesh,
    ): Coat {
        val at = 4 * triangle
        val hasOwn = at < found.looks.size && found.looks[at] >= 0
        val number = if (hasOwn) found.looks[at] else default.group
        val group = looks.groups[number]
        var isThere = group != null
        for (corner in 0 until 3) {
            val index = if (hasOwn) found.looks[at + 1 + corner] else default.index
            if (group == null || index >= group.numbers.size) isThere = false
        }
        if (!isThere && number >= 0) withoutLooks++
        for (corner in 0 until 3) {
            val index = if (hasOwn) found.looks[at + 1 + corner] else default.index
            val look = if (group != null && isThere) group.numbers[index] else -1
            val isColor = group == null || group.texture < 0
            mesh.add(found.triangles[3 * triangle + corner], if (isColor) look else -1, if (isColor) -1 else look)
        }
        if (group == null || !isThere) return BARE

        // There are no gradients between ways to reflect light: that of the first corner counts
        return Coat(
            group.texture, group.ground, looks.finish(group, if (hasOwn) found.looks[at + 1] else default.index),
        )
    }
}
