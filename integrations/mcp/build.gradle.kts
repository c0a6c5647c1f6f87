description = "lazyz-mcp: shows models to clients of the Model Context Protocol."

// Arguments are read as the table of parameters says
configurations.all {
    exclude(group = "com.networknt", module = "json-schema-validator")
}

// The licences of libraries whose jars do not contain them, as in zcli.jar
sourceSets["main"].resources.srcDir(rootProject.file("cli/src/main/resources")).include("META-INF/licenses/*")

dependencies {
    implementation(project(":core"))
    implementation(project(":scenes"))
    implementation(libs.mcp)
}
