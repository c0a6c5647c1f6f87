package dev.lazyz.scenes.threemf

import dev.lazyz.Rgba
import dev.lazyz.geometry.Transforms
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.PartNames
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.CornerMesh
import dev.lazyz.scenes.meshes.MeshParts
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Mesh
import org.joml.Matrix4d
import org.joml.Matrix4dc

/**
 * Reads the 3D Manufacturing Format: a ZIP archive of XML (3MF Consortium, "3MF Core Specification", version 1.3.0).
 *
 * All items of the build are shown, each object as a mesh (one for each texture), with the transforms of components and
 * items, also from other parts of the package (Production Extension). Colours come from base materials, colour groups
 * and mixes of base materials, sRGB-encoded, and from textures of texture groups (Materials Extension). An object
 * without looks inherits those of the object that contains it as a component. Base materials with an alpha of 0 are
 * treated as opaque. If colours or textures are translucent, so is the material. Of several layers of properties, the
 * last texture is shown, on the mean colour of the layer below it. Materials with metallic or specular display
 * properties are physically based, see [ThreeMfFinish]. Supports, beams, slices and everything else that is not a
 * triangle are ignored with a warning. Lengths stay in the unit of the package's main part. Normals are smoothed up to
 * creases of [CREASE_ANGLE] degrees.
 *
 * The file's z axis points upward. It is not converted.
 */
internal object ThreeMfParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. Printed parts have chamfers of 45 degrees. */
    const val CREASE_ANGLE = 30.0

    override fun parse(source: Source): Scene {
        val build = ThreeMfBuild(source)
        val meshes = build.meshes()
        if (meshes.isEmpty()) source.warn("${build.reasonForNothing}, so there is nothing to see")
        return Scene(meshes)
    }
}

/** Assembles the items of the build: objects of any part, each as many times as it is placed. Not thread safe. */
internal class ThreeMfBuild(private val source: Source) {
    private val archive = ThreeMfPackage(source)
    private val unused = KindCounts()
    private val models = HashMap<String, ThreeMfModel>()
    private val meshes = ThreeMfMeshes(source, ThreeMfTextures(source, archive))
    private val built = HashMap<Triple<String, Int, DefaultLook>, List<Mesh>>()
    private val placed = ArrayList<Mesh>()
    private val open = LinkedHashSet<Pair<String, Int>>()
    private var supports = 0

    /** Returns the meshes of all items, in order. */
    fun meshes(): List<Mesh> {
        val root = model(archive.modelPath) ?: source.fail(archive.modelPath, "is missing", "export the model again")
        source.unit = root.unit
        for (item in root.items) place(item, Matrix4d(), NO_LOOK, "")
        if (models.values.any { it.requiresSlices }) {
            if (placed.isEmpty()) {
                val problem = "the file requires slices, and has no triangles"
                source.fail(archive.modelPath, problem, "export it with triangles")
            }
            source.warn("the file requires slices, which are not shown; its triangles are")
        }
        if (supports > 0) source.warn("$supports support structures are not shown")
        if (meshes.withoutLooks > 0) {
            val what = "triangles refer to colours or textures that are not there, and are drawn without"
            source.warn("${meshes.withoutLooks} $what")
        }
        if (unused.total > 0) source.warn("what is not shown: $unused")
        return placed
    }

    /** Why [meshes] is empty. */
    val reasonForNothing: String
        get() {
            val root = models.getValue(key(archive.modelPath))
            return when {
                root.items.isEmpty() && root.objects.isEmpty() -> "there are no objects"
                root.items.isEmpty() -> "no object is an item of the build"
                supports > 0 -> "the build has only supports"
                else -> "the objects of the build have no triangles"
            }
        }

    private fun model(path: String): ThreeMfModel? {
        val key = key(path)
        return models[key] ?: archive.part(path)?.let { part ->
            ThreeMfModelReader(part, path, unused).read().also { models[key] = it }
        }
    }

    /**
     * Adds the object that [placement] refers to. [toWorld] is the transform from the space of the placement to world
     * space, [inherited] the default look of the object that contains it, and [above] its path.
     */
    private fun place(placement: ObjectReference, toWorld: Matrix4dc, inherited: DefaultLook, above: String) {
        val model = model(placement.path)
            ?: source.fail(placement.path, "is missing from the package", "export the model again")
        val found = model.objects[placement.number]
            ?: source.fail(model.path, "there is no object ${placement.number} to be placed", "export it again")
        if (found.isSupport) {
            supports++
            return
        }
        val name = Pair(key(model.path), placement.number)
        if (!open.add(name)) source.fail(model.path, "object ${placement.number} holds itself", "remove the component")
        if (open.size > source.loading.limits.nesting) {
            source.fail(model.path, "objects are nested more than ${open.size - 1} deep", Loading.NESTING_REMEDY)
        }
        val path = PartNames.path(above, found.name)
        source.loading.decode(source, PLACEMENT_BYTES + PartNames.bytes(path))

        val transform = Transforms.product(toWorld, placement.transform)
        val look = if (found.defaultGroup >= 0) DefaultLook(found.defaultGroup, found.defaultIndex) else inherited
        val own = built.getOrPut(Triple(name.first, name.second, look)) { meshes.build(model, found, look) }
        for (mesh in own) {
            source.loading.vertices(source, mesh.vertexCount.toLong())
            source.loading.triangles(source, mesh.triangleCount.toLong())
            placed.add(mesh.transformed(transform).withName(path))
        }
        for (component in found.components) {
            // Numbers of groups are local to a part
            val isSamePart = model(component.path) === model
            place(component, transform, if (isSamePart) look else NO_LOOK, path)
        }
        open.remove(name)
    }

    private fun key(path: String): String = path.removePrefix("/").lowercase()

    private companion object {
        const val PLACEMENT_BYTES = 500L
        val NO_LOOK = DefaultLook(-1, 0)
    }
}

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
