package dev.lazyz.scenes.obj

import dev.lazyz.scenes.Source
import dev.lazyz.scenes.images.SrgbDecoding
import dev.lazyz.scenes.triangulation.Decimal
import dev.lazyz.scenes.triangulation.Floats
import dev.lazyz.scenes.triangulation.KindCounts
import dev.lazyz.scenes.triangulation.TextNumbers

/**
 * Reads the statements of an OBJ file that carry polygons into [model].
 *
 * Points, lines, free-form geometry and statements that it does not know are passed over, with a warning for each kind.
 */
internal class ObjReader(private val source: Source, private val model: ObjModel) {
    private val statements = Statements(source.bytes)
    private val faces = ObjFaceReader(source, statements, model)
    private val decimal = Decimal()
    private val dropped = LinkedHashMap<String, Int>()
    private val freeForm = KindCounts()
    private val unknown = KindCounts()

    // What holds for the faces that follow: how many `o` statements stand before, the last `usemtl`, no `s off`
    private var objectNumber = 0
    private var material: String? = null
    private var isSmooth = true

    /** Reads all statements. */
    fun read() {
        beginPart()
        while (statements.next()) {
            when {
                statements.hasKeyword("v") -> vertex()
                statements.hasKeyword("f") || statements.hasKeyword("fo") -> faces.read()
                statements.hasKeyword("vt") -> textureCoordinates()
                statements.hasKeyword("vn") -> triple("vn", model.normals)
                else -> readOther()
            }
        }
        for ((keyword, count) in dropped) {
            source.warn("${DRAWN.getValue(keyword)} are not drawn; $count statements \"$keyword\" are passed over")
        }
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
            !statements.hasKeyword("g") -> passOver(statements.keyword())
        }
    }

    private fun passOver(keyword: String) {
        when (keyword) {
            in DRAWN -> dropped.merge(keyword, 1, Int::plus)
            in FREE_FORM -> freeForm.add(keyword)
            !in UNSEEN -> unknown.add(keyword)
        }
    }

    private fun beginPart() {
        faces.part = model.faces.partNumber(Part(objectNumber, material, isSmooth))
    }

    private fun name(keyword: String): String = statements.statement().substring(keyword.length).trim()

    private fun vertex() {
        triple("v", model.positions)
        if (!statements.nextWord()) return
        val red = color()
        if (!statements.nextWord()) return
        val green = color()
        if (!statements.nextWord()) return
        val blue = color()
        passRest()

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
        passRest()
    }

    private fun triple(keyword: String, to: Floats) {
        statements.nextWord()
        for (count in 0 until 3) {
            if (!statements.nextWord()) fail("\"$keyword\" needs 3 numbers, not $count")
            to.add(number())
        }
        if (keyword != "v") passRest()
    }

    /** Whatever else stands there must be numbers, too. */
    private fun passRest() {
        while (statements.nextWord()) number()
    }

    private fun number(): Float {
        val number = decimal.float(statements.bytes, statements.wordStart, statements.wordEnd)
        if (!number.isNaN()) return number
        return TextNumbers.parseFloat(statements.word()) ?: failAtNumber()
    }

    private fun color(): Double {
        val number = decimal.double(statements.bytes, statements.wordStart, statements.wordEnd)
        if (!number.isNaN()) return number
        return TextNumbers.parse(statements.word()) ?: failAtNumber()
    }

    private fun failAtNumber(): Nothing {
        val word = statements.word()
        if (word.all { it in PLAIN }) fail("the line cannot be understood, for \"$word\" is not a number")
        fail("\"$word\" is not a number", TextNumbers.remedy(word))
    }

    private fun fail(problem: String, remedy: String? = null): Nothing =
        source.fail("line ${statements.number}", problem, remedy ?: "correct the line or export the model again")

    private companion object {
        /** What numbers are made of. */
        const val PLAIN = "0123456789+-.eE"
        val DRAWN = mapOf(
            "p" to "points",
            "l" to "lines",
        )
        val FREE_FORM = setOf(
            "bmat", "bsp", "bzp", "cdc", "cdp", "con", "cstype", "ctech", "curv", "curv2", "deg", "end", "hole", "parm",
            "res", "scrv", "sp", "stech", "step", "surf", "trim", "vp",
        )

        /** What is not seen in the picture of polygons: how they belong together, and how some programs show them. */
        val UNSEEN = setOf("bevel", "c_interp", "d_interp", "lod", "mg")
    }
}
