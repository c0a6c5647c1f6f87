package dev.lazyz.spark.models

import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.outputs.ContactSheet
import java.io.ByteArrayOutputStream
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
        val names = (0..byPlace.keys.max()).map { byPlace.getValue(it).getString(2) }
        val sheet = ContactSheet(ImageSize(width, height), names.map { it.substringAfterLast('/') }, columns, WHITE)
        for ((place, cell) in byPlace) {
            val pixels = cell.getAs<ByteArray?>(3) ?: continue
            sheet.put(place, IntArray(width * height).also { ByteBuffer.wrap(pixels).asIntBuffer().get(it) })
        }
        val png = ByteArrayOutputStream().also { sheet.write(it) }.toByteArray()
        return RowFactory.create(number, png, names.toTypedArray())
    }

    private companion object {
        const val WHITE = -1

        val CELLS: StructType = StructType().add("sheet", DataTypes.LongType).add("place", DataTypes.IntegerType)
            .add("name", DataTypes.StringType).add("pixels", DataTypes.BinaryType)
        val SHEETS: StructType = StructType().add("sheet", DataTypes.LongType).add("png", DataTypes.BinaryType)
            .add("names", DataTypes.createArrayType(DataTypes.StringType))
    }
}
