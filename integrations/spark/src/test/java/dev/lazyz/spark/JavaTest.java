package dev.lazyz.spark;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import org.apache.spark.sql.Dataset;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.SparkSession;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

/** The library from Java. */
class JavaTest {
    /** The first lines of docs/spark.md. */
    static void page() {
        SparkSession spark = SparkSession.builder().master("local[2]").getOrCreate();
        Dataset<Row> models = spark.read().format("binaryFile").load("models");
        Dataset<Row> pictures = ModelPictures.render(models, "size=256 view=iso");
        pictures.write().parquet("pictures");
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    void modelsBecomePictures(@TempDir Path folder) {
        SparkSession spark = TestSpark.getSession();
        Models.collection(folder.resolve("models"));

        Dataset<Row> models = spark.read().format("binaryFile").load(folder.resolve("models") + "");
        Dataset<Row> pictures = ModelPictures.render(models, "size=256 view=iso");
        pictures.write().parquet(folder.resolve("pictures") + "");

        Dataset<Row> read = spark.read().parquet(folder.resolve("pictures") + "");
        assertEquals(2, read.filter("error IS NULL").count());
        assertEquals(3, read.filter("png IS NULL").count());
    }
}
