package dev.lazyz.server

import java.io.IOException
import java.util.concurrent.CountDownLatch
import kotlin.system.exitProcess

/**
 * Entry point of the program `lazyz-server`: runs a [RenderServer] with the settings of the command line, and closes it
 * when the process is asked to end. Exit code 2 after a mistake in the options, or if the address is in use.
 */
public fun main(args: Array<String>) {
    // Newer Java versions warn about fast access to memory, and the server does not need it
    System.setProperty("joml.nounsafe", "true")
    System.setProperty("io.netty.noUnsafe", "true")
    when {
        args.any { it == "--help" || it == "-h" } -> println(ServerOptions.help())
        "--version" in args -> println("lazyz-server ${version()}")
        else -> serve(args.asList())
    }
}

private fun serve(args: List<String>) {
    val server = try {
        RenderServer(ServerOptions.config(args)).start()
    } catch (mistake: OptionMistake) {
        exit("${mistake.message}\nSee --help.")
    } catch (unavailable: IOException) {
        exit(unavailable.message.orEmpty())
    }
    Runtime.getRuntime().addShutdownHook(Thread { server.close() })
    println("listening at http://${server.config.host}:${server.port}/")
    println("health and metrics at http://${server.config.adminHost}:${server.adminPort}/")
    CountDownLatch(1).await()
}

private fun exit(message: String): Nothing {
    System.err.println("lazyz-server: $message")
    exitProcess(2)
}

private fun version(): String = RenderServer::class.java.`package`?.implementationVersion ?: "(development)"
