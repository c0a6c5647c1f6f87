description = "The contract, the set-up of frames, the hidden-surface strategies, shaders and counters."

kotlin {
    explicitApi()
}

dependencies {
    api(libs.coroutines)
    api(libs.joml)
}
