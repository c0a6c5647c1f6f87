package dev.lazyz.spark.models

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.VisibleRows
import dev.lazyz.scenes.writers.toPng
import java.nio.ByteBuffer
import org.apache.spark.sql.Row
import org.apache.spark.sql.RowFactory
import org.apache.spark.sql.types.DataTypes
import org.apache.spark.sql.types.StructType

/** The columns of pictures of models. */
internal object PictureColumns {
    private val counters = StructType()
        .add("primitives", DataTypes.LongType).add("fragments", DataTypes.LongType)
        .add("depthEvaluations", DataTypes.LongType).add("depthPasses", DataTypes.LongType)
        .add("shadingCalls", DataTypes.LongType)

    val schema: StructType = StructType()
        .add("name", DataTypes.StringType).add("options", DataTypes.StringType)
        .add("width", DataTypes.IntegerType).add("height", DataTypes.IntegerType)
        .add("png", DataTypes.BinaryType).add("pixels", DataTypes.BinaryType).add("depth", DataTypes.BinaryType)
        .add("npz", DataTypes.BinaryType)
        .add("hash", DataTypes.StringType).add("counters", counters)
        .add("blank", DataTypes.StringType).add("cropped", DataTypes.BooleanType)
        .add("warnings", DataTypes.createArrayType(DataTypes.StringType))
        .add("error", DataTypes.StringType)

    /** Returns the row of a picture. */
    fun row(
        name: String,
        wish: PictureOptions,
        image: Image,
        isCropped: Boolean,
        warnings: List<String>,
    ): Row = RowFactory.create(
        name, wish.words, image.width, image.height,
        if (wish.has("png")) image.toPng() else null,
        if (wish.has("pixels")) bytes(image.argb) else null,
        if (wish.has("depth")) bytes(image.depth) else null, null,
        image.pixelHash(), row(image.counters),
        VisibleRows(image.width).apply { add(image) }.blank?.name?.lowercase(), isCropped,
        warnings.toTypedArray(), null,
    )

    /** Returns the row of what is in place of one picture: [file], which [written] has made. */
    fun row(
        name: String,
        wish: PictureOptions,
        written: PictureOutput.Writer,
        file: ByteArray,
        warnings: List<String>,
    ): Row = RowFactory.create(
        name, wish.words, written.size.width, written.size.height,
        file.takeIf { written.output.aovs.isEmpty() }, null, null, file.takeIf { written.output.aovs.isNotEmpty() },
        written.hash, row(written.counters), written.blank?.name?.lowercase(), written.isCropped,
        warnings.toTypedArray(), null,
    )

    /** Returns the row of a model that cannot be shown. */
    fun failure(name: String, words: String, error: String): Row =
        RowFactory.create(name, words, null, null, null, null, null, null, null, null, null, null, null, error)

    private fun row(counters: Counters): Row = with(counters) {
        RowFactory.create(primitives, fragments, depthEvaluations, depthPasses, shadingCalls)
    }

    /** Returns the numbers as bytes, each from the highest to the lowest byte. */
    private fun bytes(numbers: IntArray): ByteArray =
        ByteBuffer.allocate(Int.SIZE_BYTES * numbers.size).apply { asIntBuffer().put(numbers) }.array()
}
