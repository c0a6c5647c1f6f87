description = "A render service: HTTP requests with models, answered with pictures, within limits of time and memory."

kotlin {
    explicitApi()
}

dependencies {
    api(project(":core"))
    api(project(":scenes"))
    api(libs.serialization.json)
    api(libs.netty.codec.http)
}
