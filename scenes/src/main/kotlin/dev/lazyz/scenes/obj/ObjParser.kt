package dev.lazyz.scenes.obj

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.PartNames
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.obj.materials.MtlLibrary
import dev.lazyz.scenes.text.Statements
import dev.lazyz.world.Scene

/**
 * Reads Wavefront OBJ files with their material libraries (Wavefront Technologies, "Advanced Visualizer" manual,
 * appendix B1, "Object Files", version 3.0).
 *
 * It reads polygons with any number of corners, normals, texture coordinates (v upward, converted to `1 - v`),
 * materials, and vertex colours `v x y z red green blue`, which are sRGB-encoded numbers in 0..1. Groups are ignored.
 * Objects and materials divide the file into meshes, see [ObjMeshes]. Faces without normals are smooth up to creases of
 * [CREASE_ANGLE] degrees, or flat after `s off`; other numbers of smoothing groups are ignored. Points and lines follow
 * the meshes, by material; if there is none of these, all vertices are points. Free-form geometry and unknown
 * statements are ignored with a warning.
 */
internal object ObjParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. */
    const val CREASE_ANGLE = 45.0

    override fun parse(source: Source): Scene {
        source.decodeText()
        val model = model(source)
        if (model.positions.size == 0) {
            source.fail(null, "there is no vertex in the file", "check what kind of file it is")
        }
        source.release()
        model.checkReferences()
        val faces = model.faces
        source.loading.vertices(source, model.positions.size / 3L)
        source.loading.triangles(source, faces.positions.size - 2L * faces.size)
        if (faces.size == 0 && model.points.isEmpty) return Scene(model.vertices().points())

        val library = MtlLibrary(source)
        for (reference in model.libraries.distinct()) library.add(reference)
        val meshes = ObjMeshes(source, model, library::material).build()
        return Scene(meshes + model.points.surfaces(model, library::material))
    }

    private fun model(source: Source): ObjModel {
        val reader = FarOrigin.reading(
            source.loading,
            read = { origin -> ObjReader(source, ObjModel(source, origin)).also { it.read() } },
            bounds = { Box.around(it.model.positions.toArray()) },
        )
        reader.warn()
        return reader.model
    }
}

/**
 * Reads the statements of an OBJ file for polygons, points and lines into [model].
 *
 * Free-form geometry and unknown statements are ignored, with a warning for each kind.
 */
internal class ObjReader(private val source: Source, val model: ObjModel) {
    private val statements = Statements(source)
    private val faces = ObjFaceReader(source, statements, model, model.faces)
    private val points = ObjPointReader(source, statements, model, faces)
    private val vertices = ObjVertexReader(source, statements, model.origin, model)
    private val ignored = ObjIgnored()

    // State for what follows: number of `o` statements so far, name of the last one, path of the last `o` and the last
    // `g` after it, last `usemtl`, and false after `s off`
    private var objectNumber = 0
    private var objectName = ""
    private var path = ""
    private var material: String? = null
    private var isSmooth = true
    private var label = Label("", null)

    /** Reads all statements. */
    fun read() {
        beginPart()
        while (statements.next()) {
            when {
                statements.hasKeyword("v") -> vertices.readVertex()
                statements.hasKeyword("f") || statements.hasKeyword("fo") -> faces.read()
                statements.hasKeyword("vt") -> vertices.readTexture()
                statements.hasKeyword("vn") -> vertices.readNormal()
                else -> readOther()
            }
        }
    }

    /** Reports the statements that were ignored. */
    fun warn() = ignored.warn(source)

    private fun readOther() {
        when {
            statements.hasKeyword("usemtl") -> {
                material = name("usemtl")
                beginPart()
            }
            statements.hasKeyword("mtllib") -> {
                source.loading.items(source, 1)
                model.libraries.add(name("mtllib"))
            }
            statements.hasKeyword("o") -> {
                objectNumber++
                objectName = PartNames.path("", name("o"))
                path = objectName
                beginPart()
            }
            statements.hasKeyword("g") -> {
                path = PartNames.path(objectName, name("g"))
                beginPart()
            }
            statements.hasKeyword("s") -> {
                isSmooth = statements.withoutComment().substring(1).trim().lowercase() !in listOf("off", "0")
                beginPart()
            }
            statements.hasKeyword("p") -> points.readPoints(label)
            statements.hasKeyword("l") -> points.readLine(label)
            else -> ignored.add(statements.keyword())
        }
    }

    private fun beginPart() {
        label = Label(path, material)
        val before = model.faces.parts.size
        faces.part = model.faces.partNumber(Part(objectNumber, label, isSmooth))
        if (model.faces.parts.size == before) return
        source.loading.items(source, 1)
        source.loading.decode(source, PartNames.bytes(path))
    }

    private fun name(keyword: String): String = statements.statement().substring(keyword.length).trim()
}

/** Counts the statements that have no effect, for one warning about each kind. */
internal class ObjIgnored {
    private val freeForm = KindCounts()
    private val unknown = KindCounts()

    fun add(keyword: String) {
        when (keyword) {
            in FREE_FORM -> freeForm.add(keyword)
            !in IRRELEVANT -> unknown.add(keyword)
        }
    }

    /** Reports the statements. */
    fun warn(source: Source) {
        if (freeForm.total > 0) {
            source.warn("free-form curves and surfaces are not drawn; their statements are passed over: $freeForm")
        }
        if (unknown.total > 0) source.warn("unknown statements are passed over: $unknown")
    }

    private companion object {
        val FREE_FORM = setOf(
            "bmat", "bsp", "bzp", "cdc", "cdp", "con", "cstype", "ctech", "curv", "curv2", "deg", "end", "hole", "parm",
            "res", "scrv", "sp", "stech", "step", "surf", "trim", "vp",
        )

        /** Statements that do not affect the rendering of polygons: grouping, and display settings of some programs. */
        val IRRELEVANT = setOf("bevel", "c_interp", "d_interp", "lod", "mg")
    }
}
