package dev.lazyz.cli.pages

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.cli.ProjectFiles
import dev.lazyz.cli.rendererJar
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.nio.ByteBuffer
import java.nio.ByteOrder
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** The renderer that pages call `my-id`. */
class MyRenderer : Renderer {
    override val id: String get() = "my-id"

    override val summary: String get() = "is an example"

    override fun render(frame: Frame, sink: RowSink): Counters = ZBufferRenderer().render(frame, sink)
}

/** Writes the files that [commands] name; only models if they take all files. */
internal fun PageShell.fill(commands: String) {
    val models = folder.resolve("models").createDirectories()
    models.wedge()
    for (part in listOf("part.stl", "a.stl", "old.stl", "new.stl", "models/part.stl")) {
        folder.resolve(part).writeText(STL)
    }
    for (name in listOf("model.obj", "a.obj")) folder.wedge(name)
    folder.resolve("model.glb").writeBytes(glb())
    folder.resolve("scene.json").writeText(SCENE)
    if ("compare * " in commands) return
    folder.resolve("failures").createDirectories().resolve("RULE.json").writeText(SCENE)
    ProjectFiles.root.resolve("docs/images/flange.obj")
        .copyTo(folder.resolve("docs/images").createDirectories().resolve("flange.obj"))
    folder.resolve("cli/target").createDirectories().resolve("zcli").createSymbolicLinkPointingTo(program)
    for (name in listOf("my.jar", "mine.jar")) folder.rendererJar(MyRenderer::class.java, name = name)
    for (name in listOf("golden.png", "new.png").filter { it in commands }) {
        zcli("render", "teapot", "--size", "64", "-o", folder.resolve(name)).done()
    }
    val picture = folder.resolve("pictures").createDirectories().resolve("part.png")
    zcli("render", models.resolve("part.stl"), "--size", "512", "-o", picture).done()
    folder.resolve("new").createDirectories()
    if ("report.json" in commands) {
        val options = listOf("--strategy", "my-id", "--tries", "0.05", "--rule", "9.6", "--in-process", "--quiet")
        val jar = folder.resolve("my.jar")
        zcli("conformance", "--classpath", jar, "--report", folder.resolve("report"), *options.toTypedArray()).done()
    }
}

private const val STL = """solid part
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 4 0 0
vertex 0 2 1
endloop
endfacet
endsolid part
"""

private const val SCENE =
    """{"lazyz": 1, "size": [64, 48], "surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]}"""

/** A triangle, and two cameras. */
private fun glb(): ByteArray {
    val json = """{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1}},
        {"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
        "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 3]}, {"camera": 1, "translation": [0, 0, 4]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
        "min": [0, 0, 0], "max": [1, 1, 0]}]}"""
    val text = json.padEnd((json.length + 3) / 4 * 4).toByteArray()
    val buffer = ByteBuffer.allocate(12 + 8 + text.size + 8 + 36).order(ByteOrder.LITTLE_ENDIAN)
    buffer.putInt(0x46546C67).putInt(2).putInt(buffer.capacity())
    buffer.putInt(text.size).putInt(0x4E4F534A).put(text).putInt(36).putInt(0x004E4942)
    for (coordinate in listOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f)) buffer.putFloat(coordinate)
    return buffer.array()
}
