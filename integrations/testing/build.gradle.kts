description = "Golden tests of pictures for JUnit 5: a scene or a picture is compared with a PNG file, pixel by pixel."

kotlin {
    explicitApi()
}

dependencies {
    api(project(":core"))
    api(project(":scenes"))
    api(libs.opentest4j)
}
