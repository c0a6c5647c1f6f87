package dev.lazyz.spark

import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.formats.ModelArchive
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.spark.models.ContactSheets
import dev.lazyz.spark.models.ModelPicture
import dev.lazyz.spark.models.PictureColumns
import dev.lazyz.spark.models.PictureOptions
import dev.lazyz.spark.models.SerializableLimits
import org.apache.spark.api.java.function.MapPartitionsFunction
import org.apache.spark.sql.Dataset
import org.apache.spark.sql.Encoders
import org.apache.spark.sql.Row
import org.apache.spark.sql.SparkSession
import org.apache.spark.sql.api.java.UDF3
import org.apache.spark.sql.types.StructType

/**
 * Pictures of many models: each row of a model becomes a row with its picture. A model that cannot be read or shown is
 * a row with its error, and never fails the job.
 *
 * ```
 * val models = spark.read().format("binaryFile").load("models")
 * ModelPictures.render(models, "size=256 view=iso").write().parquet("pictures")
 * ```
 *
 * The columns of the result, see [schema]:
 *
 * | column | content |
 * |---|---|
 * | `name`, `options` | as given |
 * | `width`, `height` | of the picture, in pixels |
 * | `png`, `pixels`, `depth` | as `output` says: a PNG file; alpha, red, green, blue, 8-bit sRGB; 32-bit depths |
 * | `npz` | a file with data of pixels in place of the picture, as `aov` says |
 * | `hash` | the pixel hash of contract rule 7.2 |
 * | `counters` | primitives, fragments, depth evaluations, depth passes and shading calls |
 * | `blank` | why there is nothing to see, `background` or `one_color`, or null |
 * | `cropped` | whether a part of the model is outside the picture |
 * | `warnings` | what the reader ignored, and what options do not do to this model |
 * | `error` | why there is no picture, or null |
 *
 * With `turntable`, `png` is an animated PNG; with `views`, it shows all of them. `width` and `height` are then those
 * of each picture, and `hash` is that of all.
 *
 * A picture has the bits of `zcli render` with the same options. Each task renders one model at a time on one thread.
 * Memory of an executor: for each of its tasks a model in memory. A model whose decoded data need more than a task's
 * share of the heap is refused as an error; set [LoadLimits.decodedBytes] to choose another limit. A model that refers
 * to other files, such as OBJ with textures, comes as a ZIP archive with them, see [ModelArchive]; an executor unpacks
 * it into its folder of temporary files. Of a model without an archive, such files are reported as missing. Thread
 * safe.
 */
public object ModelPictures {
    /** The columns of pictures. */
    @JvmStatic
    public val schema: StructType get() = PictureColumns.schema

    /**
     * Returns a row with a picture for each row of [models].
     *
     * The input has the columns of Spark's source `binaryFile`, `path` and `content`, or `name` and `content`. With a
     * column `options`, each model is shown as it says; where it is null or missing, as [options] say.
     *
     * @param options see [PictureOptions]
     * @param limits limits on what a model can request
     * @throws IllegalArgumentException if a column is missing, or [options] are not understood
     */
    @JvmStatic
    @JvmOverloads
    public fun render(models: Dataset<Row>, options: String = "", limits: LoadLimits = LoadLimits()): Dataset<Row> {
        val columns = models.columns().toList()
        val name = requireNotNull(listOf("name", "path").firstOrNull { it in columns }) {
            "the models have no column 'name' or 'path': ${columns.joinToString()}"
        }
        require("content" in columns) { "the models have no column 'content': ${columns.joinToString()}" }
        val words = PictureOptions(options).words
        val chosen = if ("options" in
            columns
        ) {
            models.select(name, "content", "options")
        } else {
            models.select(name, "content")
        }
        return chosen.mapPartitions(RenderRows(words, SerializableLimits(limits)), Encoders.row(schema))
    }

    /**
     * Returns contact sheets of pictures: rows with the columns `sheet`, its number from 0; `png`, the picture;
     * `names`,
     * what it shows, in rows from the top. Models without a picture have a cell that says so. The order is that of the
     * names.
     *
     * @param models as for [render]
     * @param options as for [render]; all cells have the same size
     * @param columns cells in a row of a sheet
     * @param rows rows of a sheet
     * @throws IllegalArgumentException as [render], or if a number is not in 1..100
     */
    @JvmStatic
    @JvmOverloads
    public fun sheets(
        models: Dataset<Row>,
        options: String = "",
        columns: Int = 8,
        rows: Int = 8,
        limits: LoadLimits = LoadLimits(),
    ): Dataset<Row> {
        require(columns in 1..100 && rows in 1..100) { "columns and rows must be in 1..100: $columns, $rows" }
        val wish = PictureOptions("$options output=pixels")
        val settings = wish.settings()
        val size = settings[PictureParameters.REGION]?.let { ImageSize(it.width, it.height) } ?: settings.size
        return ContactSheets(size.width, size.height, columns, rows).of(render(models, wish.words, limits))
    }

    /**
     * Registers the function [RenderModel] of Spark SQL under [name]: `SELECT lazyz_render(content, path, 'size=256')`
     * returns a struct of the columns of [schema].
     */
    @JvmStatic
    @JvmOverloads
    public fun register(spark: SparkSession, name: String = "lazyz_render") {
        spark.udf().register(name, RenderModel(), schema)
    }

    /** Renders the rows of a partition: name, content, and perhaps options. */
    private class RenderRows(private val words: String, private val limits: SerializableLimits) :
        MapPartitionsFunction<Row, Row> {
        override fun call(rows: Iterator<Row>): Iterator<Row> {
            val models = ModelPicture(limits.limits())
            return rows.asSequence().map { row ->
                val own = if (row.size() > 2 && !row.isNullAt(2)) row.getString(2) else words
                models.row(row.getString(0) ?: "(no name)", row.getAs<ByteArray?>(1), own)
            }.iterator()
        }
    }
}

/**
 * A function of Spark SQL: the bytes of a model, its name, and options become a picture, a struct of the columns of
 * [ModelPictures.schema]. Name and options can be null. A model that cannot be shown has its error in the struct.
 *
 * [ModelPictures.register] registers it. From Python, register it by the name of this class:
 *
 * ```python
 * schema = spark._jvm.dev.lazyz.spark.ModelPictures.getSchema().json()
 * spark.udf.registerJavaFunction("lazyz_render", "dev.lazyz.spark.RenderModel",
 * StructType.fromJson(json.loads(schema)))
 * ```
 *
 * Limits are those of [LoadLimits], with the share of a task as the limit of decoded data. Thread safe.
 */
public class RenderModel : UDF3<ByteArray?, String?, String?, Row> {
    @Transient
    private var models: ModelPicture? = null

    override fun call(content: ByteArray?, name: String?, options: String?): Row {
        val renderer = models ?: ModelPicture(LoadLimits()).also { models = it }
        return renderer.row(name ?: "(no name)", content, options.orEmpty())
    }
}
