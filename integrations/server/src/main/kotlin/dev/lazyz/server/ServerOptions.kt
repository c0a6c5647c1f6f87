package dev.lazyz.server

import java.time.Duration

/** A mistake of the user. */
internal class OptionMistake(message: String) : RuntimeException(message)

/** The options of the program `lazyz-server`. */
internal object ServerOptions {
    /**
     * An option with a value.
     *
     * @property name the name, with dashes
     * @property form the form of the value
     * @property help what it does
     * @property apply returns the settings with the value, or throws [IllegalArgumentException]
     */
    class Option(
        val name: String,
        val form: String,
        val help: String,
        val apply: (ServerConfig, String) -> ServerConfig,
    )

    /** All options, in the order of the help. */
    val options: List<Option> = listOf(
        Option("--host", "HOST", "address to listen at; 0.0.0.0 for all; default: 127.0.0.1") { c, v -> c.withHost(v) },
        Option("--port", "N", "port to listen at, 0 for a free one; default: 8080") { c, v -> c.withPort(int(v)) },
        Option("--admin-host", "HOST", "address for health and metrics; default: 127.0.0.1") { c, v ->
            c.withAdminHost(v)
        },
        Option("--admin-port", "N", "port for health and metrics, 0 for a free one; default: 8081") { c, v ->
            c.withAdminPort(int(v))
        },
        Option("--renders", "N", "pictures that are rendered at the same time; default: processors") { c, v ->
            c.withRenders(int(v))
        },
        Option("--queue", "N", "requests that wait for their rendering; default: 64") { c, v -> c.withQueue(int(v)) },
        Option("--connections", "N", "open connections; default: 1024") { c, v -> c.withConnections(int(v)) },
        Option("--memory", "SIZE", "heap for uploads and renderings: bytes, or with k, m, g; default: half of it") {
                c,
                v
            ->
            c.withMemory(bytes(v))
        },
        Option("--max-body", "SIZE", "bytes of a model; default: 64m") { c, v -> c.withBody(bytes(v)) },
        Option("--max-pixels", "N", "pixels of a picture; default: 16777216") { c, v -> c.withPixels(long(v)) },
        Option("--max-decoded", "SIZE", "decoded data of a model; default: a part of --memory") { c, v ->
            c.withLimits(c.limits.withDecodedBytes(bytes(v)))
        },
        Option("--max-triangles", "N", "triangles of a model; default: no limit") { c, v ->
            c.withLimits(c.limits.withTriangles(long(v)))
        },
        Option("--max-vertices", "N", "vertices of a model; default: no limit") { c, v ->
            c.withLimits(c.limits.withVertices(long(v)))
        },
        Option("--max-texels", "N", "pixels of all textures of a model; default: no limit") { c, v ->
            c.withLimits(c.limits.withTexels(long(v)))
        },
        Option("--max-items", "N", "objects, nodes, materials and so on of a model; default: 1000000") { c, v ->
            c.withLimits(c.limits.withItems(long(v)))
        },
        Option("--max-nesting", "N", "depth of nested objects in a model, 1..1000; default: 64") { c, v ->
            c.withLimits(c.limits.withNesting(int(v)))
        },
        Option("--max-seconds", "SECONDS", "time on the wall for reading a model; default: --render-time") { c, v ->
            c.withLimits(c.limits.withTime(seconds(v)))
        },
        Option("--idle-time", "SECONDS", "time for a client to send a request's headers; default: 30") { c, v ->
            c.withIdleTime(seconds(v))
        },
        Option("--upload-time", "SECONDS", "time for a client to send a model; default: 60") { c, v ->
            c.withUploadTime(seconds(v))
        },
        Option("--upload-rate", "SIZE", "bytes a second that a client must send, after 5 s; default: 1k") { c, v ->
            c.withUploadRate(bytes(v))
        },
        Option("--queue-time", "SECONDS", "time in the queue; default: 30") { c, v -> c.withQueueTime(seconds(v)) },
        Option("--render-time", "SECONDS", "time (on the wall) for reading and rendering; default: 30") { c, v ->
            c.withRenderTime(seconds(v))
        },
        Option("--download-time", "SECONDS", "time for a client to receive a picture; default: 60") { c, v ->
            c.withDownloadTime(seconds(v))
        },
        Option("--drain-time", "SECONDS", "time for open requests after SIGTERM; default: 30") { c, v ->
            c.withDrainTime(seconds(v))
        },
    )

    private const val ADMIN_PORT = 8081

    /**
     * Returns the settings that [args] describe; values follow their names after a space or `=`.
     *
     * @throws OptionMistake if an option or a value is wrong
     */
    fun config(args: List<String>): ServerConfig {
        var config = ServerConfig(adminPort = ADMIN_PORT, log = { println(it) })
        val words = ArrayDeque(args)
        while (words.isNotEmpty()) {
            val word = words.removeFirst()
            val name = word.substringBefore('=')
            val option = options.firstOrNull { it.name == name } ?: throw OptionMistake("there is no option '$name'")
            val value = if ('=' in word) word.substringAfter('=') else words.removeFirstOrNull()
            if (value == null) throw OptionMistake("$name needs a value, ${option.form}")
            config = try {
                option.apply(config, value)
            } catch (wrong: IllegalArgumentException) {
                throw OptionMistake("$name $value: ${wrong.message}")
            }
        }
        return config
    }

    /** The text of `--help`. */
    fun help(): String = buildString {
        appendLine("Usage: java -jar lazyz-server.jar [OPTIONS]")
        appendLine()
        appendLine("Renders models over HTTP: POST /render with a model as the body is answered")
        appendLine("with a picture of it, or data of its pixels. GET / lists the parameters.")
        appendLine()
        appendLine("Options:")
        for (option in options) appendLine("  ${option.name} ${option.form}\n      ${option.help}")
        appendLine("  --version\n      print the version and exit")
        appendLine("  -h, --help\n      print this text and exit")
        appendLine()
        appendLine("Examples:")
        appendLine("  java -Xmx1g -jar lazyz-server.jar --port 8080")
        append("  curl --data-binary @part.stl 'http://localhost:8080/render?size=512' -o part.png")
    }

    private fun int(text: String): Int = text.toIntOrNull() ?: throw IllegalArgumentException("not a whole number")

    private fun long(text: String): Long = text.toLongOrNull() ?: throw IllegalArgumentException("not a whole number")

    private fun bytes(text: String): Long {
        val digits = text.takeWhile { it in '0'..'9' }
        val power = listOf("", "k", "m", "g").indexOf(text.drop(digits.length).lowercase())
        if (digits.length !in 1..12 || power < 0) {
            throw IllegalArgumentException("not an amount, such as 65536, 64k or 16m")
        }
        return digits.toLong() shl 10 * power
    }

    private fun seconds(text: String): Duration {
        val seconds = text.toDoubleOrNull()?.takeIf { it in 0.001..86_400.0 }
            ?: throw IllegalArgumentException("not a number of seconds, 0.001..86400")
        return Duration.ofMillis((seconds * 1000).toLong())
    }
}
