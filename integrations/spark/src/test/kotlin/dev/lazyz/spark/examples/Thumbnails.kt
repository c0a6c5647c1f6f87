package dev.lazyz.spark.examples

import dev.lazyz.spark.ModelPictures
import dev.lazyz.spark.Models
import java.nio.file.Path
import kotlin.io.path.name
import org.apache.spark.sql.SparkSession

/**
 * Writes a small collection with bad models to a folder, the first argument, renders it as `Thumbnails.scala` and
 * `thumbnails.py` do, and prints what they print. The second argument is the place for pictures.
 */
fun main(arguments: Array<String>) {
    val (models, pictures) = arguments
    Models.collection(Path.of(models))
    val spark = SparkSession.builder().master("local[2]").appName("thumbnails").getOrCreate()
    val files = spark.read().format("binaryFile").load(models)
    ModelPictures.render(files, "size=64 view=iso").write().parquet(pictures)
    for (row in spark.read().parquet(pictures).sort("name").collectAsList()) {
        val name = Path.of(row.getAs<String>("name")).name
        println("$name ${row.getAs<String>("hash") ?: row.getAs<String>("error")}")
    }
    spark.stop()
}
