package dev.lazyz.server

import java.time.Duration
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class ServerOptionsTest {
    @Test
    fun valuesFollowTheirOptions() {
        val config = ServerOptions.config(
            listOf("--port=0", "--host", "::1", "--memory", "64m", "--upload-time=0.5", "--max-triangles", "7"),
        )
        assertEquals(0, config.port)
        assertEquals("::1", config.host)
        assertEquals(64L shl 20, config.memory)
        assertEquals(Duration.ofMillis(500), config.uploadTime)
        assertEquals(7, config.limits.triangles)
        assertEquals(64, config.queue)
    }

    @Test
    fun everyOptionAcceptsAValue() {
        for (option in ServerOptions.options) {
            val value = if (option.form == "SIZE") "2m" else "9"
            ServerOptions.config(listOf(option.name, value))
            assertTrue("  ${option.name} ${option.form}\n" in ServerOptions.help(), option.name)
            if (option.form != "HOST") {
                val words = listOf(option.name, "none")
                val mistake = assertThrows(OptionMistake::class.java) { ServerOptions.config(words) }
                assertTrue(mistake.message!!.startsWith("${option.name} none: not "), mistake.message)
            }
        }
    }

    @Test
    fun mistakesNameTheOption() {
        for ((words, message) in mapOf(
            listOf("--prot", "1") to "there is no option '--prot'",
            listOf("--port") to "--port needs a value, N",
            listOf("--port", "70000") to "--port 70000: port must be in 0..65535: 70000",
            listOf("--memory", "9999999m") to "--memory 9999999m: memory must be at most the heap, " +
                "${Runtime.getRuntime().maxMemory()} bytes: 10485758951424; start Java with a larger -Xmx",
            listOf("--memory", "1k") to "--memory 1k: memory must be at least 1048576 bytes: 1024",
        )) {
            assertEquals(message, assertThrows(OptionMistake::class.java) { ServerOptions.config(words) }.message)
        }
    }
}
