package dev.lazyz.cli

import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.output.Streams
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Files
import kotlin.system.exitProcess

/**
 * Runs a small example of each feature of zcli, so that Java can archive the loaded classes. The launcher script calls
 * it.
 *
 * @throws IllegalStateException if a command fails
 */
internal fun main() {
    val folder = Files.createTempDirectory("zcli")
    val picture = folder.resolve("picture.png")
    try {
        train(Streams.ofProcess(), "render", "teapot", "--size", "64x64", "-o", "$picture")
        train(silent(), "render", "teapot", "--size", "64x64", "--stats", "-o", "$picture")
        for ((format, text) in models) {
            train(silent(text), "render", "-", "--format", format, "--size", "8x8", "-o", "$picture")
        }
        train(silent(), "compare", "teapot", "--size", "8x8", "--json")
        train(silent(), "strategies", "--long")
        train(silent(), "scenes")
        train(silent(), "render", "--help")
    } finally {
        Files.deleteIfExists(picture)
        Files.delete(folder)
    }

    // The exit loads classes, too
    exitProcess(ExitCode.DONE)
}

private fun train(streams: Streams, vararg args: String) {
    val code = run(arrayOf(*args), streams)
    check(code == ExitCode.DONE) { "exit code $code of ${args.joinToString(" ")}" }
}

/** Returns streams that read [input] and discard all output. */
private fun silent(input: String = ""): Streams {
    val nowhere = OutputStream.nullOutputStream()
    return Streams(input.byteInputStream(), nowhere, PrintStream(nowhere))
}

/** A triangle in each text format. */
private val models = mapOf(
    "obj" to "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "stl" to "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n" +
        "endsolid a\n",
    "ply" to "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
    "off" to "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
    "gltf" to """{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
            "min": [0, 0, 0], "max": [1, 1, 0]}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36, "uri":
            "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}""",
    "scene" to """{"lazyz": 1, "surfaces": [{"builtin": {"name": "teapot", "segments": 1}}]}""",
)
