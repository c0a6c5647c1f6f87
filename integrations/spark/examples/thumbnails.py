"""Pictures of all models in a folder, from Python: thumbnails.py MODELS PICTURES"""

import json
import sys

from pyspark.sql import SparkSession
from pyspark.sql.types import StructType

spark = SparkSession.builder.master("local[2]").appName("thumbnails").getOrCreate()
schema = StructType.fromJson(json.loads(spark._jvm.dev.lazyz.spark.ModelPictures.getSchema().json()))
spark.udf.registerJavaFunction("lazyz_render", "dev.lazyz.spark.RenderModel", schema)

models = spark.read.format("binaryFile").load(sys.argv[1])
pictures = models.selectExpr("lazyz_render(content, path, 'size=64 view=iso') AS picture").select("picture.*")
pictures.write.parquet(sys.argv[2])
for row in spark.read.parquet(sys.argv[2]).sort("name").collect():
    print(row.name.split("/")[-1], row.hash or row.error)
spark.stop()
