package dev.lazyz.scenes.obj

import dev.lazyz.Rgba
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.Decimal
import dev.lazyz.scenes.text.Statements
import dev.lazyz.scenes.text.TextNumbers
import org.joml.Vector3d
import org.joml.Vector3dc

/** Takes the vertices of an OBJ file. */
internal interface ObjVertexSink {
    /** Adds a position, relative to the reader's origin. */
    fun vertex(x: Float, y: Float, z: Float)

    /** Sets the colour of the vertex that was added last, in linear light. Vertices without one are white. */
    fun color(red: Float, green: Float, blue: Float)

    /** Adds texture coordinates, v upward. */
    fun texture(u: Float, v: Float)

    /** Adds a normal. */
    fun normal(x: Float, y: Float, z: Float)
}

/**
 * Reads the statements `v`, `vt` and `vn`.
 *
 * @param origin the point to subtract from all positions
 */
internal class ObjVertexReader(
    private val source: Source,
    private val statements: Statements,
    private val origin: Vector3dc,
    private val sink: ObjVertexSink,
) {
    private val decimal = Decimal()
    private val isFar = origin != Vector3d()
    private val numbers = FloatArray(3)

    /** Reads the current statement, a `v`. */
    fun readVertex() {
        statements.nextWord()
        for (axis in 0 until 3) {
            if (!statements.nextWord()) fail("\"v\" needs 3 numbers, not $axis")
            numbers[axis] = if (isFar) (double() - origin.get(axis)).toFloat() else number()
        }
        sink.vertex(numbers[0], numbers[1], numbers[2])
        if (!statements.nextWord()) return
        val red = double()
        if (!statements.nextWord()) return
        val green = double()
        if (!statements.nextWord()) return
        val blue = double()
        checkRest()
        sink.color(Rgba.linearOf(red), Rgba.linearOf(green), Rgba.linearOf(blue))
    }

    /** Reads the current statement, a `vt`. */
    fun readTexture() {
        statements.nextWord()
        if (!statements.nextWord()) fail("\"vt\" needs 1 numbers, not 0")
        sink.texture(number(), if (statements.nextWord()) number() else 0f)
        checkRest()
    }

    /** Reads the current statement, a `vn`. */
    fun readNormal() {
        statements.nextWord()
        for (axis in 0 until 3) {
            if (!statements.nextWord()) fail("\"vn\" needs 3 numbers, not $axis")
            numbers[axis] = number()
        }
        sink.normal(numbers[0], numbers[1], numbers[2])
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
        /** The characters that numbers consist of. */
        const val NUMBER_CHARACTERS = "0123456789+-.eE"
    }
}
