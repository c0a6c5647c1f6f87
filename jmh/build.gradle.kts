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
