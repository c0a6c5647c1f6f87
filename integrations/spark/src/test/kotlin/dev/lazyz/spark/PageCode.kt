package dev.lazyz.spark

import dev.lazyz.Raster
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.spark.pictures.DistributedPicture
import dev.lazyz.world.Scene
import java.nio.file.Path
import org.apache.spark.sql.SparkSession

/** Code that `docs/spark.md` shows: it compiles. */
internal object PageCode {
    fun models(spark: SparkSession) {
        ModelPictures.register(spark)
        spark.sql("SELECT path, lazyz_render(content, path, 'size=256').hash FROM models")
    }

    fun largePicture(spark: SparkSession) {
        val picture = DistributedPicture(spark) {
            SuperSampling(4).frame(Scenes.load(Path.of("/shared/city.glb")).scene, Raster(30000, 20000))
        }
        picture.writePng(Path.of("city.png"))
        picture.writeDeepZoom(Path.of("/shared/city.dzi"))
    }

    fun largeModel(spark: SparkSession) {
        val triangles = TriangleTable.readStl(spark, "hdfs:///scan.stl")
        val picture = TrianglePicture(triangles, 4000, 3000, { Scene(listOf(it)).withUpAxis(UpAxis.Z) })
        println(picture.explain())
        picture.writePng(Path.of("scan.png"))
    }

    fun checkpoints(spark: SparkSession) {
        val city = DistributedPicture(spark) { SuperSampling.NONE.of(Scenes.city().frame(20000, 10000)) }
        city.checkpointed(Path.of("/shared/city.parts"), mapOf("scene" to "city"))
            .writeDeepZoom(Path.of("/shared/city.dzi"))
    }
}
