description = "Rendering on Apache Spark: many models, large pictures and large models, with the bits of one JVM."

kotlin {
    explicitApi()
}

dependencies {
    api(project(":core"))
    api(project(":scenes"))
    compileOnly(libs.spark.sql)
    testImplementation(project(":conformance"))
}

// Maven gives what is provided to tests, too
configurations.testImplementation {
    extendsFrom(configurations.compileOnly.get())
}

tasks.test {
    // Spark starts once, not once for each class
    maxParallelForks = 1
    maxHeapSize = "2g"
    // Spark reads private fields of these packages, see its class JavaModuleOptions
    for (name in listOf("java.io", "java.lang", "java.lang.invoke", "java.nio", "java.util", "sun.nio.ch")) {
        jvmArgs("--add-opens=java.base/$name=ALL-UNNAMED")
    }
}
