description = "Benchmarks of the strategies, and against peers. Not published."

dependencies {
    implementation(project(":core"))
    implementation(project(":scenes"))
    implementation(libs.serialization.json)
    implementation(libs.joml)
    implementation(libs.xchart)
    implementation(libs.jmh.core)
    annotationProcessor(libs.jmh.generator.annprocess)
}

// For example: gradle jmh --args="-f 1 Tiled"
tasks.register<JavaExec>("jmh") {
    group = "verification"
    description = "Runs the benchmarks."
    classpath = sourceSets["main"].runtimeClasspath
    mainClass = "org.openjdk.jmh.Main"
}

// For example: gradle growth --args="--limit 8"
tasks.register<JavaExec>("growth") {
    group = "verification"
    description = "Measures how cost grows, and writes docs/growth.md and the model's coefficients."
    classpath = sourceSets["main"].runtimeClasspath
    mainClass = "dev.lazyz.jmh.growth.Growth"
    workingDir = rootDir
    maxHeapSize = "6g"
    jvmArgs("--add-modules=jdk.incubator.vector", "-Djava.awt.headless=true")
}
