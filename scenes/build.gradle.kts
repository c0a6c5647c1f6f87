description = "Scene files, mesh loaders (OBJ, STL, PLY, glTF), image writers and the built-in scenes."

kotlin {
    explicitApi()
}

dependencies {
    api(project(":core"))
    implementation(libs.jackson.core)
    implementation(libs.drako)
    implementation(libs.imageio.webp)
    implementation(libs.obj)
    implementation(libs.earcut4j)
    compileOnly(libs.kotlin.jupyter.api)
    testImplementation(libs.jackson.databind)
    testImplementation(libs.jacoco.core)
}
