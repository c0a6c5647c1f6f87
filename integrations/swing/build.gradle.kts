description = "A Swing component that shows 3D models: turned by mouse and keys, picked, cut, without graphics drivers."

kotlin {
    explicitApi()
}

dependencies {
    api(project(":core"))
    api(project(":scenes"))
}
