description = "JMH benchmarks of the strategies. Not published."

dependencies {
    implementation(project(":core"))
    implementation(project(":scenes"))
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
