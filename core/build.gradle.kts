description = "The contract, the set-up of frames, the hidden-surface strategies, shaders and counters."

kotlin {
    explicitApi()
}

dependencies {
    api(libs.kotlin.stdlib)
    api(libs.coroutines)
    api(libs.joml)
}

// Most machines have vectors of 256 bits: the loops that tests see where there are wider ones
val narrowVectorsTest = tasks.register<Test>("narrowVectorsTest") {
    testClassesDirs = sourceSets.test.get().output.classesDirs
    classpath = sourceSets.test.get().runtimeClasspath
    jvmArgs("-XX:MaxVectorSize=32")
    filter { includeTestsMatching("*TiledMeshProperties") }
}

tasks.named("check") {
    dependsOn(narrowVectorsTest)
}
