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

include("bom", "core", "scenes", "conformance", "testing", "server", "spark", "swing", "mcp", "cli", "jmh")

// Modules that connect Lazy Z with other libraries are in a folder of their own
project(":testing").projectDir = file("integrations/testing")
project(":server").projectDir = file("integrations/server")
project(":spark").projectDir = file("integrations/spark")
project(":swing").projectDir = file("integrations/swing")
project(":mcp").projectDir = file("integrations/mcp")
