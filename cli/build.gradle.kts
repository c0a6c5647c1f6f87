description = "zcli: renders meshes and scene files to pictures from the command line."

// Mordant looks at the terminal through native code; zcli starts sooner without.
configurations.all {
    exclude(group = "com.github.ajalt.mordant", module = "mordant-jvm-ffm-jvm")
    exclude(group = "com.github.ajalt.mordant", module = "mordant-jvm-graal-ffi-jvm")
    exclude(group = "com.github.ajalt.mordant", module = "mordant-jvm-jna-jvm")
}

dependencies {
    implementation(project(":core"))
    implementation(project(":scenes"))
    implementation(project(":conformance"))
    implementation(project(":swing"))
    implementation(libs.serialization.json)
    implementation(libs.jqwik)
    implementation(libs.clikt)
    implementation(libs.mordant)
}

tasks.named<Jar>("fatJar") {
    // For VectorModule
    manifest.attributes("Add-Exports" to "java.base/jdk.internal.module")
}

// The launcher lies beside the jar that it starts
val launcher = tasks.register<Copy>("launcher") {
    from("src/main/sh")
    into(layout.buildDirectory.dir("libs"))
}

tasks.assemble {
    dependsOn(launcher)
}

tasks.test {
    inputs.dir("src/main/sh")
    // BuildsAgreeTest and PackageTextsTest read them
    inputs.files(
        rootProject.fileTree(rootDir) {
            include("*.kts", "*.properties", "pom.xml", "gradle/*.toml", "*/build.gradle.kts", "*/pom.xml", "*/api/*")
            include("integrations/*/build.gradle.kts", "integrations/*/pom.xml", "integrations/*/api/*")
            include("*/src/main/module/*", "docs/architecture.md")
        },
    )
}
