package dev.lazyz.scenes

import kotlin.system.exitProcess

/**
 * Renders the pictures of [Goldens] with every renderer that can, outside of any test, for machines without a build
 * tool;
 * `.ci/other-processors` runs it. Prints what differs, and a line of sums; the exit code is 1 if anything differs.
 *
 * @param args sizes, such as `64x64`: only pictures of these; or nothing: all
 */
internal fun main(args: Array<String>) {
    val pictures = Goldens.pictures.filter { args.isEmpty() || it.name.split(" ")[1] in args }
    check(pictures.isNotEmpty()) { "no picture of ${args.joinToString(" or ")}" }
    var rendered = 0
    var equal = 0
    for (picture in pictures) {
        for (renderer in picture.renderers) {
            rendered++
            val hash = picture.hash(renderer)
            if (hash == picture.expected) equal++ else println("${picture.name} by ${renderer.id} differs: $hash")
        }
    }
    val processor = listOf("os.arch", "java.vm.name", "java.version", "java.vm.info").map { System.getProperty(it) }
    println("${processor.joinToString()}: ${pictures.size} pictures, $equal of $rendered renderings equal")
    exitProcess(if (equal == rendered) 0 else 1)
}
