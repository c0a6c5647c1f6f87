rootProject.name = "guides"

// A project of your own leaves this out and takes the published artifacts; here they come from the sources beside it
includeBuild("../..")
