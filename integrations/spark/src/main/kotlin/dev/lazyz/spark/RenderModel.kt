package dev.lazyz.spark

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.spark.models.ModelPicture
import org.apache.spark.sql.Row
import org.apache.spark.sql.api.java.UDF3

/**
 * A function of Spark SQL: the bytes of a model, its name, and options become a picture, a struct of the columns of
 * [ModelPictures.schema]. Name and options can be null. A model that cannot be shown has its error in the struct.
 *
 * [ModelPictures.register] registers it. From Python, register it by the name of this class:
 *
 * ```python
 * schema = spark._jvm.dev.lazyz.spark.ModelPictures.getSchema().json()
 * spark.udf.registerJavaFunction("lazyz_render", "dev.lazyz.spark.RenderModel", StructType.fromJson(json.loads(schema)))
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

    private companion object {
        const val serialVersionUID = 1L
    }
}
