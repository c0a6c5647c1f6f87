description = "The versions of the libraries of Lazy Z that belong together."

dependencies {
    constraints {
        api(project(":core"))
        api(project(":scenes"))
        api(project(":conformance"))
        api(project(":testing"))
        api(project(":server"))
        api(project(":spark"))
        api(project(":swing"))
    }
}
