pluginManagement {
    repositories {
        mavenCentral()
    }
}

dependencyResolutionManagement {
    repositories {
        mavenCentral()
    }
}

rootProject.name = "lazyz"

include("bom", "core", "scenes", "conformance", "cli", "jmh")
