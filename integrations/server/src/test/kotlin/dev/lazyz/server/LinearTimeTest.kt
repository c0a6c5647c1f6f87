package dev.lazyz.server

import dev.lazyz.server.render.MediaTypes
import dev.lazyz.server.render.PictureRequest
import dev.lazyz.server.render.Problem
import io.netty.handler.codec.http.DefaultHttpRequest
import io.netty.handler.codec.http.HttpHeaderNames
import io.netty.handler.codec.http.HttpMethod
import io.netty.handler.codec.http.HttpVersion
import java.lang.management.ManagementFactory
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource

/** What an event loop does with the head of a request takes a time that is at most proportional to its length. */
internal class LinearTimeTest {
    enum class Door(val read: (String) -> Unit) {
        SIZE({ picture("size", it) }),
        AZIMUTH({ picture("azimuth", it) }),
        LIGHT({ picture("light", it) }),
        BACKGROUND({ picture("background", it) }),
        NAME({ picture(it, "1") }),
        HOST({ RequestHead.problem(request("/", it)) }),
        NUMBER_OF_HOST({ RequestHead.problem(request("/", "[$it")) }),
        TARGET({ RequestHead.originForm("http://$it") }),
        TYPE({ runCatching { MediaTypes.format(it) } }),
    }

    @ParameterizedTest
    @EnumSource
    fun sixteenTimesTheLengthTakesAboutSixteenTimesAsLong(door: Door) {
        // Characters that a number, a name and a host begin with, and then one that ends none of them
        val short = "1".repeat(SHORT) + "x^"
        val long = "1".repeat(16 * SHORT) + "x^"
        repeat(200) { door.read(short) }
        val once = least { repeat(16) { door.read(short) } }
        val grown = least { door.read(long) }
        assertTrue(grown < 4 * once + 2_000_000) { "$once ns for 16 short values, $grown ns for a long one" }
    }

    @Test
    fun aLongValueIsRefusedByItsLength() {
        val query = mapOf("zoom" to listOf("1".repeat(101)))
        val problem = assertThrows(Problem::class.java) { PictureRequest.of(query, 1) }
        assertEquals("zoom: a value has at most 100 characters", problem.message)
    }

    /** The least processor time of this thread in several tries, in nanoseconds. */
    private fun least(act: () -> Unit): Long = (0 until 7).minOf {
        val start = threads.currentThreadCpuTime
        act()
        threads.currentThreadCpuTime - start
    }

    private companion object {
        const val SHORT = 4_000
        val threads = ManagementFactory.getThreadMXBean()

        fun picture(name: String, value: String) {
            runCatching { PictureRequest.of(mapOf(name to listOf(value)), 1) }
        }

        fun request(target: String, host: String) =
            DefaultHttpRequest(HttpVersion.HTTP_1_1, HttpMethod.POST, target).apply {
                headers().set(HttpHeaderNames.HOST, host)
            }
    }
}
