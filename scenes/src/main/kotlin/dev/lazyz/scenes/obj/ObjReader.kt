package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.images.SrgbDecoding
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.Decimal
import dev.lazyz.scenes.text.TextNumbers
import org.joml.Vector3d

/**
 * Reads the statements of an OBJ file for polygons, points and lines into [model].
 *
 * Free-form geometry and unknown statements are ignored, with a warning for each kind.
 */
internal class ObjReader(
    private val source: Source,
    val model: ObjModel,
    private val statements: Statements = Statements(source.bytes),
) {
    private val faces = ObjFaceReader(source, statements, model)
    private val points = ObjPointReader(source, statements, model, faces)
    private val decimal = Decimal()
    private val isFar = model.origin != Vector3d()
    private val freeForm = KindCounts()
    private val unknown = KindCounts()

    // State for the following faces: number of `o` statements so far, last `usemtl`, and false after `s off`
    private var objectNumber = 0
    private var material: String? = null
    private var isSmooth = true

    /**
     * Reads all statements. If there is a function [take], it is called after some thousand of them, and after the last,
     * to take what the model has so far.
     */
    fun read(take: (() -> Unit)? = null) {
        beginPart()
        while (statements.next()) {
            when {
                statements.hasKeyword("v") -> vertex()
                statements.hasKeyword("f") || statements.hasKeyword("fo") -> faces.read()
                statements.hasKeyword("vt") -> textureCoordinates()
                statements.hasKeyword("vn") -> normal()
                else -> readOther()
            }
            if (take != null && model.pending >= TAKEN) take()
        }
        take?.invoke()
    }

    /** Reports the statements that were ignored. */
    fun warn() {
        if (freeForm.total > 0) {
            source.warn("free-form curves and surfaces are not drawn; their statements are passed over: $freeForm")
        }
        if (unknown.total > 0) source.warn("unknown statements are passed over: $unknown")
    }

    private fun readOther() {
        when {
            statements.hasKeyword("usemtl") -> {
                material = name("usemtl")
                beginPart()
            }
            statements.hasKeyword("mtllib") -> model.libraries.add(name("mtllib"))
            statements.hasKeyword("o") -> {
                objectNumber++
                beginPart()
            }
            statements.hasKeyword("s") -> {
                isSmooth = statements.withoutComment().substring(1).trim().lowercase() !in listOf("off", "0")
                beginPart()
            }
            statements.hasKeyword("p") -> points.readPoints(material)
            statements.hasKeyword("l") -> points.readLine(material)
            !statements.hasKeyword("g") -> ignore(statements.keyword())
        }
    }

    private fun ignore(keyword: String) {
        when (keyword) {
            in FREE_FORM -> freeForm.add(keyword)
            !in IRRELEVANT -> unknown.add(keyword)
        }
    }

    private fun beginPart() {
        faces.part = model.faces.partNumber(Part(objectNumber, material, isSmooth))
    }

    private fun name(keyword: String): String = statements.statement().substring(keyword.length).trim()

    private fun vertex() {
        statements.nextWord()
        for (axis in 0 until 3) {
            if (!statements.nextWord()) fail("\"v\" needs 3 numbers, not $axis")
            model.positions.add(if (isFar) (double() - model.origin.get(axis)).toFloat() else number())
        }
        if (!statements.nextWord()) return
        val red = double()
        if (!statements.nextWord()) return
        val green = double()
        if (!statements.nextWord()) return
        val blue = double()
        checkRest()

        // Vertices before the first coloured one are white
        while (model.colors.size < model.positions.size - 3) model.colors.add(1f)
        model.colors.add(SrgbDecoding.decode(red))
        model.colors.add(SrgbDecoding.decode(green))
        model.colors.add(SrgbDecoding.decode(blue))
    }

    private fun textureCoordinates() {
        statements.nextWord()
        if (!statements.nextWord()) fail("\"vt\" needs 1 numbers, not 0")
        model.textures.add(number())
        model.textures.add(if (statements.nextWord()) number() else 0f)
        checkRest()
    }

    private fun normal() {
        statements.nextWord()
        for (axis in 0 until 3) {
            if (!statements.nextWord()) fail("\"vn\" needs 3 numbers, not $axis")
            model.normals.add(number())
        }
        checkRest()
    }

    /** Checks that all remaining words are numbers. */
    private fun checkRest() {
        while (statements.nextWord()) number()
    }

    private fun number(): Float {
        val number = decimal.float(statements.bytes, statements.wordStart, statements.wordEnd)
        if (!number.isNaN()) return number
        return TextNumbers.parseFloat(statements.word()) ?: failAtNumber()
    }

    private fun double(): Double {
        val number = decimal.double(statements.bytes, statements.wordStart, statements.wordEnd)
        if (!number.isNaN()) return number
        return TextNumbers.parse(statements.word()) ?: failAtNumber()
    }

    private fun failAtNumber(): Nothing {
        val word = statements.word()
        if (word.all { it in NUMBER_CHARACTERS }) fail("the line cannot be understood, for \"$word\" is not a number")
        fail("\"$word\" is not a number", TextNumbers.remedy(word))
    }

    private fun fail(problem: String, remedy: String? = null): Nothing =
        source.fail("line ${statements.number}", problem, remedy ?: "correct the line or export the model again")

    private companion object {
        /** Numbers of the model that are taken at a time. */
        const val TAKEN = 1 shl 14

        /** The characters that numbers consist of. */
        const val NUMBER_CHARACTERS = "0123456789+-.eE"
        val FREE_FORM = setOf(
            "bmat", "bsp", "bzp", "cdc", "cdp", "con", "cstype", "ctech", "curv", "curv2", "deg", "end", "hole", "parm",
            "res", "scrv", "sp", "stech", "step", "surf", "trim", "vp",
        )

        /** Statements that do not affect the rendering of polygons: grouping, and display settings of some programs. */
        val IRRELEVANT = setOf("bevel", "c_interp", "d_interp", "lod", "mg")
    }
}
