package dev.lazyz.spark

import java.nio.file.Files
import java.nio.file.Path
import org.apache.spark.sql.SparkSession

/** A Spark with two threads, which all tests share, as it takes seconds to start. */
object TestSpark {
    /** A folder for what Spark writes. */
    val folder: Path = Files.createTempDirectory("lazyz-spark").also { it.toFile().deleteOnExit() }

    @JvmStatic
    val session: SparkSession by lazy {
        SparkSession.builder().master("local[2]").appName("tests")
            .config("spark.ui.enabled", false)
            .config("spark.driver.host", "127.0.0.1")
            .config("spark.driver.bindAddress", "127.0.0.1")
            .config("spark.sql.shuffle.partitions", 2)
            .config("spark.sql.warehouse.dir", "${folder.resolve("warehouse")}")
            .config("spark.local.dir", "$folder")
            .getOrCreate()
    }

    init {
        Runtime.getRuntime().addShutdownHook(Thread { folder.toFile().deleteRecursively() })
    }
}
