plugins {
    java
}

repositories {
    mavenCentral()
}

dependencies {
    implementation("dev.lazyz:lazyz-scenes:0.2.0")
    implementation("dev.lazyz:lazyz-swing:0.2.0")
    compileOnly("jakarta.servlet:jakarta.servlet-api:6.0.0")
    testImplementation("dev.lazyz:lazyz-conformance:0.2.0")
    testImplementation("org.eclipse.jetty.ee10:jetty-ee10-servlet:12.0.25")
    testImplementation("org.junit.jupiter:junit-jupiter:5.14.4")
    testRuntimeOnly("org.junit.platform:junit-platform-launcher:1.14.4")
}

tasks.withType<JavaCompile>().configureEach {
    options.release = 17
}

tasks.test {
    useJUnitPlatform()
}
