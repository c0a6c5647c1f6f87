plugins {
    java
}

repositories {
    mavenCentral()
}

dependencies {
    implementation("dev.lazyz:lazyz-core:0.2.0")
    testImplementation("dev.lazyz:lazyz-conformance:0.2.0")
}

tasks.withType<JavaCompile>().configureEach {
    options.release = 17
}

tasks.test {
    useJUnitPlatform()
}
