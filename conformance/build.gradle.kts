description = "The suite that a strategy must pass: generators, rules and a report, for JUnit 5 or by hand."

kotlin {
    explicitApi()
}

dependencies {
    api(project(":core"))
    api(project(":scenes"))
    api(platform(libs.junit.bom))
    api(libs.jqwik)
    implementation(libs.serialization.json)
    api(libs.junit.jupiter.api)
    api(libs.junit.platform.launcher)
    testImplementation(libs.jacoco.agent)
}
