package dev.lazyz.scenes.threemf

import dev.lazyz.geometry.Transforms
import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.PartNames
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.Scene
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
