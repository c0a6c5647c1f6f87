import dev.lazyz.scenes.LoadLimits
import dev.lazyz.spark.ModelPictures
import org.apache.spark.sql.SparkSession

/** Pictures of all models in a folder, from Scala: Thumbnails MODELS PICTURES */
object Thumbnails {
  def main(arguments: Array[String]): Unit = {
    val spark = SparkSession.builder().master("local[2]").appName("thumbnails").getOrCreate()
    val models = spark.read.format("binaryFile").load(arguments(0))
    ModelPictures.render(models, "size=64 view=iso", new LoadLimits()).write.parquet(arguments(1))
    for (row <- spark.read.parquet(arguments(1)).sort("name").collect()) {
      val outcome = Option(row.getAs[String]("hash")).getOrElse(row.getAs[String]("error"))
      println(row.getAs[String]("name").split("/").last + " " + outcome)
    }
    spark.stop()
  }
}
