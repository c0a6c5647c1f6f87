package dev.lazyz.mcp

import dev.lazyz.Renderer
import dev.lazyz.geometry.UpAxis
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.scenes.ClientText
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.diff.ModelDifference
import dev.lazyz.scenes.diff.ModelNumbers
import dev.lazyz.scenes.diff.PartDifference
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.camera.Camera
import io.modelcontextprotocol.json.McpJsonDefaults
import io.modelcontextprotocol.json.schema.JsonSchemaValidator
import io.modelcontextprotocol.server.McpServer
import io.modelcontextprotocol.server.McpServerFeatures.AsyncToolSpecification
import io.modelcontextprotocol.spec.McpSchema
import io.modelcontextprotocol.spec.McpSchema.CallToolResult
import java.io.ByteArrayOutputStream
import java.time.Duration
import java.util.Base64
import org.joml.Vector3d

/** The tools. Each call reads its files, so that it sees what has changed. */
internal class ModelTools(private val folder: ModelFolder, private val limits: Limits) {
    private val memory = Runtime.getRuntime().maxMemory()
    private val mostPixels = minOf(limits.pixels, memory / 2 / BYTES_PER_PIXEL)

    /** Answers the requests that come through [transport], by [jobs]. */
    fun serve(transport: LineTransport, jobs: Jobs) {
        fun tool(name: String, help: String, input: ToolInput, act: (ToolInput.Call) -> CallToolResult) =
            AsyncToolSpecification.builder()
                .tool(
                    McpSchema.Tool.builder(name, input.schema()).description(help)
                        .annotations(McpSchema.ToolAnnotations(null, true, false, true, false, null)).build(),
                )
                .callHandler { _, request -> jobs.run(::failed) { act(input.read(request.arguments())) } }
                .build()
        McpServer.async(transport)
            .serverInfo("lazyz-mcp", javaClass.`package`?.implementationVersion ?: "development")
            .capabilities(McpSchema.ServerCapabilities.builder().tools(false).build())
            .instructions(INSTRUCTIONS)
            // Arguments are read as the table of parameters says, which is more than a schema can
            .validateToolInputs(false)
            .jsonSchemaValidator { _, _ -> JsonSchemaValidator.ValidationResponse.asValid(null) }
            .tools(
                tool("render", RENDER, ToolInput.RENDER, ::render),
                tool("compare", COMPARE, ToolInput.COMPARE, ::compare),
                tool("measure", MEASURE, ToolInput.MEASURE, ::measure),
                tool("pick", PICK, ToolInput.PICK, ::pick),
            )
            .build()
    }

    private fun render(call: ToolInput.Call): CallToolResult {
        val words = call.own.filterKeys { it == PictureOutput.Word.VIEWS.id }
        val output = PictureOutput.read(words, call.settings)
        val model = Model(call["file"], call.settings, output.frames)
        if (call.own["drawing"] == "true") {
            if (words.isNotEmpty()) refuse("a drawing has one view")
            return draw(model)
        }
        val file = ByteArrayOutputStream()
        val writer = output.writer(file, model.settings, model.loaded)
        for (number in 0 until output.frames) {
            val frame = writer.frame(number, observer = model.observer)
            writer.add(frame, model.renderer(frame))
        }
        val views = output.views.map { it.name.lowercase() }
        val shown = if (views.isEmpty()) model.cameras.last() else mapOf("views" to views.zip(model.cameras).toMap())
        val facts = mapOf(
            "blank" to (writer.blank != null), "cropped" to writer.isCropped, "pixelHash" to writer.hash,
        )
        return result(model.facts() + shown + facts, picture(file.toByteArray()))
    }

    private fun draw(model: Model): CallToolResult {
        val drawing = model.settings.drawing(model.loaded, observer = model.observer)
        val svg = ByteArrayOutputStream()
        val blank = drawing.writeSvg(svg, drawing.picture?.let(model::renderer) ?: TiledRenderer())
        val text = McpSchema.TextResourceContents.builder("lazyz:drawing.svg", svg.toString(Charsets.UTF_8))
            .mimeType("image/svg+xml").build()
        val facts = mapOf(
            "blank" to (blank != null), "lines" to drawing.lines.size, "millimetresPerPixel" to drawing.pixelSize,
        )
        return result(model.facts() + model.cameras.last() + facts, McpSchema.EmbeddedResource.builder(text).build())
    }

    private fun compare(call: ToolInput.Call): CallToolResult {
        val (old, new) = listOf("old", "new").map { Model(call[it], call.settings, 1, models = 2) }
        val difference = ModelDifference.between(
            old.loaded, new.loaded, old.settings, oldObserver = old.observer, newObserver = new.observer,
        )
        val data = difference.toData(old.name, new.name)
        val changed = difference.parts.filterNot { it.isEqual }.map { it.name }.toSet()
        val parts = (data["parts"] as List<*>).filter { (it as Map<*, *>)["name"] in changed }
        val facts = data + parts(parts) + old.cameras.last() + ("warnings" to (old.warnings() + new.warnings()))
        val images = listOf(difference.before, difference.after, difference.toImage())
        return result(facts, *images.map { picture(it.toPng()) }.toTypedArray())
    }

    private fun measure(call: ToolInput.Call): CallToolResult {
        val model = Model(call["file"], call.settings, 1)
        val surfaces = model.loaded.scene.surfaces
        val numbers = ModelNumbers(surfaces)
        val parts = PartDifference.of(surfaces, numbers).map {
            mapOf("name" to it.name, "numbers" to it.after?.toData())
        }
        val about = mapOf(
            "file" to model.name, "format" to model.loaded.format?.id, "unit" to model.loaded.unit?.symbol,
            "up" to model.up.id,
            "numbers" to numbers.toData(), "warnings" to model.warnings(),
        )
        return result(about + parts(parts))
    }

    private fun pick(call: ToolInput.Call): CallToolResult {
        val model = Model(call["file"], call.settings, 1)
        val frame = model.settings.frame(model.loaded, observer = model.observer)
        val (x, y) = call.number("x") to call.number("y")
        if (!frame.pixels.contains(x, y)) refuse("x and y: the picture has no pixel $x, $y")
        val seen = frame.samples.at(x, y)
        val facts = if (seen == null) {
            mapOf("hit" to false)
        } else {
            val place = frame.up.toModel(Vector3d(seen.x, seen.y, seen.z))
            mapOf(
                "hit" to true, "part" to seen.part, "surface" to seen.surface, "triangle" to seen.triangle,
                "position" to listOf(place.x, place.y, place.z), "uv" to listOf(seen.u, seen.v),
                "distance" to seen.distance,
            )
        }
        return result(model.facts() + model.cameras.last() + facts)
    }

    /**
     * A model that is read, with how it is shown.
     *
     * @param frames pictures of it
     * @param models models that are in memory together
     */
    private inner class Model(val name: String, given: PictureSettings, frames: Int, models: Int = 1) {
        private val reading = LoadLimits(
            decodedBytes = memory / BYTES_PER_DECODED / models, time = Duration.ofSeconds(limits.seconds),
        )
        val loaded: LoadedScene
        val settings: PictureSettings
        val cameras = ArrayList<Map<String, Any?>>()

        init {
            val file = folder.file(name)
            val found = folder.files(given)
            requirePixels(given.size, frames)
            val options = found.loadOptions(reading)
            loaded = found[PictureParameters.FORMAT]?.let { Scenes.load(file, it, options) }
                ?: Scenes.load(file, options)
            settings = found.with(PictureParameters.SIZE, found[PictureParameters.SIZE] ?: loaded.size ?: found.size)
            requirePixels(settings.size, frames)
        }

        val up: UpAxis = settings[PictureParameters.UP] ?: loaded.usualUp
        private val size: ImageSize = settings.size

        val observer = object : PictureObserver("the model", reading) {
            override fun camera(camera: Camera, up: UpAxis) {
                cameras += facts(camera, up)
            }
        }

        /** Returns what renders [frame] in the memory that there is. */
        fun renderer(frame: PictureFrame): Renderer {
            val items = listOf(
                RenderPlan.Item("model", loaded.scene.setUpBytes),
                RenderPlan.Item("pictures", size.width.toLong() * size.height * BYTES_PER_PIXEL),
            )
            val plan = frame.plan(RenderPlanner(memory), listOf(TiledRenderer()), items)
            if (!plan.fits) {
                refuse("this needs ${plan.leastMemory} bytes of memory of $memory; choose a smaller size or aa")
            }
            return plan.renderer
        }

        fun facts(): Map<String, Any?> =
            mapOf("file" to name, "width" to size.width, "height" to size.height, "warnings" to warnings())

        fun warnings(): List<String> =
            (loaded.warnings + observer.warnings.distinct()).take(MOST_WARNINGS).map { folder.plain(ClientText.of(it)) }

        /** The camera by the parameters that choose it, and how large a pixel is at its target. */
        private fun facts(camera: Camera, up: UpAxis): Map<String, Any?> {
            val words = PictureSettings().seenBy(camera, up).options.map { it.removePrefix("--") }
            return mapOf(
                "camera" to words.associate { it.substringBefore('=') to it.substringAfter('=') },
                "unitsPerPixel" to camera.heightAt(camera.eye.distance(camera.target)) / size.height,
            )
        }
    }

    private fun requirePixels(size: ImageSize, frames: Int) {
        if (size.width.toLong() * size.height * frames <= mostPixels) return
        refuse(
            "size: at most $mostPixels pixels in all: $size" +
                if (frames == 1) "" else ", $frames times"
        )
    }

    private fun parts(all: List<Any?>) =
        mapOf("parts" to all.take(MOST_PARTS), "partsLeftOut" to maxOf(all.size - MOST_PARTS, 0))

    private fun picture(png: ByteArray) =
        McpSchema.ImageContent.builder(Base64.getEncoder().encodeToString(png), "image/png").build()

    private fun failed(reason: String): CallToolResult =
        CallToolResult.builder().isError(true).addTextContent(folder.plain(reason)).build()

    /** Returns a result with [data], also as text for clients that show no data. */
    private fun result(data: Map<String, Any?>, vararg content: McpSchema.Content): CallToolResult {
        val text = McpSchema.TextContent.builder(McpJsonDefaults.getMapper().writeValueAsString(data)).build()
        return CallToolResult.builder().isError(false).content(content.asList() + text).structuredContent(data).build()
    }

    private companion object {
        const val INSTRUCTIONS =
            "Shows 3D models (OBJ, STL, PLY, OFF, 3MF, glTF, scene files) of one folder. Look at 'blank' and " +
                "'cropped' before you trust a picture. 'camera' of a result has the parameters that show the same " +
                "side again."
        const val RENDER =
            "Renders a model to a PNG picture, or to a drawing of its lines (SVG). By default it shows the whole " +
                "model. 'cut' shows its inside, 'views' several sides on one sheet. The data say whether the " +
                "picture is blank, or shows only a part of the model (cropped)."
        const val COMPARE =
            "Compares two versions of a model: pictures of the old one, of the new one and of the changes by one " +
                "camera, and numbers of both (old, new, difference). Parameters are as for 'render'."
        const val MEASURE =
            "Measures a model and each of its parts, in its own unit: bounds, area, volume (null if it is not " +
                "closed), and counts of parts, triangles, separate shells, open edges and holes through it."
        const val PICK =
            "Says what a pixel of the picture that 'render' makes with the same parameters shows: part, triangle, " +
                "position in the axes of the model."

        /** Bytes of a pixel that a comparison takes; pictures take fewer. */
        const val BYTES_PER_PIXEL = 80L

        /** Bytes of memory for each byte of decoded data, half of which are for the model. */
        const val BYTES_PER_DECODED = 8L
        const val MOST_WARNINGS = 5
        const val MOST_PARTS = 50
    }
}
