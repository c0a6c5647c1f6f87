description = "A render service: HTTP requests with models, answered with pictures, within limits of time and memory."

kotlin {
    explicitApi()
}

// The licences of libraries whose jars do not contain them, as in zcli.jar
sourceSets["main"].resources.srcDir(rootProject.file("cli/src/main/resources")).include("META-INF/licenses/*")

dependencies {
    api(project(":core"))
    api(project(":scenes"))
    api(libs.serialization.json)
    api(libs.netty.codec.http)
}
