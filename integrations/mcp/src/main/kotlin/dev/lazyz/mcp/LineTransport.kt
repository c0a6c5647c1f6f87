package dev.lazyz.mcp

import io.modelcontextprotocol.json.McpJsonMapper
import io.modelcontextprotocol.json.TypeRef
import io.modelcontextprotocol.spec.McpSchema
import io.modelcontextprotocol.spec.McpSchema.ErrorCodes
import io.modelcontextprotocol.spec.McpServerSession
import io.modelcontextprotocol.spec.McpServerTransport
import io.modelcontextprotocol.spec.McpServerTransportProvider
import java.io.BufferedInputStream
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.InputStream
import java.io.OutputStream
import java.util.concurrent.ConcurrentHashMap
import reactor.core.Disposable
import reactor.core.publisher.Mono

/**
 * One session of the protocol, a message a line. Other than the transport of the SDK, it goes on after a line that is
 * no message, and ends the work for requests that the client cancels.
 */
internal class LineTransport(private val mapper: McpJsonMapper, input: InputStream, private val output: OutputStream) :
    McpServerTransportProvider,
    McpServerTransport {
    private val input = BufferedInputStream(input)
    private lateinit var session: McpServerSession

    /** The requests that have no answer yet, by their ids. */
    private val open = ConcurrentHashMap<Any, Disposable>()

    override fun setSessionFactory(factory: McpServerSession.Factory) {
        session = factory.create(this)
    }

    /** Handles all messages up to the end of the input. */
    fun read() {
        while (true) {
            val line = line() ?: return
            if (line.size > MOST_BYTES) {
                fail(ErrorCodes.INVALID_REQUEST, "a message has at most $MOST_BYTES bytes")
            } else if (line.isNotEmpty()) {
                handle(String(line, Charsets.UTF_8))
            }
        }
    }

    private fun handle(line: String) {
        val isObject = try {
            mapper.readValue(line, Any::class.java) is Map<*, *>
        } catch (_: Exception) {
            return fail(ErrorCodes.PARSE_ERROR, "the line is no JSON")
        }
        val message = try {
            check(isObject)
            McpSchema.deserializeJsonRpcMessage(mapper, line)
        } catch (_: Exception) {
            return fail(ErrorCodes.INVALID_REQUEST, "the line is no request with a text or a whole number as id")
        }
        when {
            message is McpSchema.JSONRPCRequest -> start(message)
            message !is McpSchema.JSONRPCNotification || message.method() != CANCELLED -> session.handle(message).run()
            else -> (message.params() as? Map<*, *>)?.get("requestId")?.let { open.remove(number(it))?.dispose() }
        }
    }

    private fun start(request: McpSchema.JSONRPCRequest) {
        val id = number(request.id())
        val work = Work()
        if (open.putIfAbsent(id, work) != null) {
            return fail(ErrorCodes.INVALID_REQUEST, "a request with this id has no answer yet")
        }
        work.begin(session.handle(request).doFinally { open.remove(id, work) })
    }

    /** A request in progress: it can end, and be cancelled, before it is known what would cancel it. */
    private class Work : Disposable.Composite by reactor.core.Disposables.composite() {
        fun begin(answer: Mono<Void>) {
            add(answer.run())
        }
    }

    private fun number(id: Any): Any = if (id is Int) id.toLong() else id

    override fun sendMessage(message: McpSchema.JSONRPCMessage): Mono<Void> = Mono.fromRunnable {
        val failure = (message as? McpSchema.JSONRPCResponse)?.error()
        if (failure?.code() == ErrorCodes.INTERNAL_ERROR) {
            // Its text is that of an exception
            val plain = McpSchema.JSONRPCResponse.JSONRPCError(ErrorCodes.INVALID_PARAMS, "the parameters are invalid")
            write(McpSchema.JSONRPCResponse.error(message.id(), plain))
        } else {
            write(message)
        }
    }

    private fun fail(code: Int, text: String) {
        val error = mapOf("code" to code, "message" to text)
        write(mapOf("jsonrpc" to "2.0", "id" to null, "error" to error))
    }

    private fun write(message: Any) {
        val bytes = mapper.writeValueAsBytes(message)
        try {
            synchronized(output) {
                output.write(bytes)
                output.write('\n'.code)
                output.flush()
            }
        } catch (_: IOException) {
            // The client is gone; the input ends, too
        }
    }

    /** Returns the next line, of which only the beginning if it is too long, or null at the end. */
    private fun line(): ByteArray? {
        val line = ByteArrayOutputStream()
        while (true) {
            val byte = input.read()
            when {
                byte < 0 -> return null
                byte == '\n'.code -> return line.toByteArray()
                byte != '\r'.code && line.size() <= MOST_BYTES -> line.write(byte)
            }
        }
    }

    override fun <T> unmarshalFrom(data: Any?, type: TypeRef<T>): T = mapper.convertValue(data, type)

    override fun notifyClients(method: String, params: Any?): Mono<Void> = session.sendNotification(method, params)

    override fun protocolVersions(): List<String> = super<McpServerTransport>.protocolVersions()

    override fun close() = Unit

    override fun closeGracefully(): Mono<Void> = Mono.empty()

    private companion object {
        /** Bytes of a message; requests have some hundred. */
        const val MOST_BYTES = 1 shl 20
        const val CANCELLED = "notifications/cancelled"

        fun Mono<Void>.run(): Disposable = onErrorComplete().subscribe()
    }
}
