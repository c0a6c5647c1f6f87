package dev.lazyz.spark.models

import dev.lazyz.scenes.pictures.Canvas
import dev.lazyz.scenes.pictures.PixelFont
import dev.lazyz.scenes.writers.toPng
import java.io.Serializable
import java.nio.ByteBuffer
import org.apache.spark.api.java.function.MapFunction
import org.apache.spark.api.java.function.MapGroupsFunction
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Encoders
import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType

/**
 * Pictures of models in cells, each with its name below. A task makes a sheet at a time.
 *
 * @param width columns of a cell
 * @param height rows of a cell
 * @param columns cells in a row
 * @param rows rows of cells in a sheet
 */
internal class ContactSheets(
    private val width: Int,
    private val height: Int,
    private val columns: Int,
    private val rows: Int,
) : Serializable {
    /** Returns the sheets of [pictures], which have pixels. */
    fun of(pictures: Dataset<Row>): Dataset<Row> {
        val spark = pictures.sparkSession()
        val cells = columns.toLong() * rows
        val sorted = pictures.select("name", "pixels").sort("name").javaRDD().zipWithIndex().map { numbered ->
            val number = numbered._2()
            RowFactory.create(number / cells, (number % cells).toInt(), numbered._1().get(0), numbered._1().get(1))
        }
        return spark.createDataFrame(sorted, CELLS)
            .groupByKey(MapFunction<Row, Long> { it.getLong(0) }, Encoders.LONG())
            .mapGroups(MapGroupsFunction<Long, Row, Row> { sheet, all -> sheet(sheet, all) }, Encoders.row(SHEETS))
    }

    private fun sheet(number: Long, cells: Iterator<Row>): Row {
        val byPlace = cells.asSequence().associateBy { it.getInt(1) }
        val filled = (byPlace.keys.max() / columns + 1).coerceAtMost(rows)
        val canvas = Canvas(columns * (width + GAP) + GAP, filled * (height + LABEL + GAP) + GAP, WHITE)
        val names = (0..byPlace.keys.max()).map { place ->
            val cell = byPlace.getValue(place)
            val x = GAP + place % columns * (width + GAP)
            val y = GAP + place / columns * (height + LABEL + GAP)
            val pixels = cell.getAs<ByteArray?>(3)
            if (pixels == null) canvas.text(FAILED, x, y + height / 2, 1, BLACK) else canvas.draw(pixels, x, y)
            val name = cell.getString(2)
            canvas.text(name.substringAfterLast('/').take(width / PixelFont.ADVANCE), x, y + height + 2, 1, BLACK)
            name
        }
        return RowFactory.create(number, canvas.toImage().toPng(), names.toTypedArray())
    }

    private fun Canvas.draw(pixels: ByteArray, x: Int, y: Int) {
        val argb = ByteBuffer.wrap(pixels).asIntBuffer()
        for (row in 0 until this@ContactSheets.height) {
            for (column in 0 until this@ContactSheets.width) {
                set(x + column, y + row, argb.get(row * this@ContactSheets.width + column))
            }
        }
    }

    private companion object {
        const val serialVersionUID = 1L
        const val GAP = 6

        /** Rows of a cell's label. */
        const val LABEL = PixelFont.HEIGHT + 4
        const val FAILED = "failed"
        const val BLACK = 0xFF shl 24
        const val WHITE = -1

        val CELLS: StructType = StructType().add("sheet", DataTypes.LongType).add("place", DataTypes.IntegerType)
            .add("name", DataTypes.StringType).add("pixels", DataTypes.BinaryType)
        val SHEETS: StructType = StructType().add("sheet", DataTypes.LongType).add("png", DataTypes.BinaryType)
            .add("names", DataTypes.createArrayType(DataTypes.StringType))
    }
}
