package dev.lazyz.testing

import java.util.concurrent.CompletableFuture
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Nested
import org.junit.jupiter.api.Test

/** The class that a failure belongs to is the test's. */
class CallingTestTest {
    @Nested
    inner class Inner {
        @Test
        fun nestedClassesBelongToTheirOuterClass() = isThis()
    }

    @Test
    fun lambdasAndOtherThreadsBelongToTheirClass() {
        isThis()
        listOf(1).forEach { _ -> isThis() }
        CompletableFuture.supplyAsync { CallingTest.name() }.get().let { assertEquals(javaClass.name, it) }
    }

    @Test
    fun aHelperIsNotTheTest() {
        val stack = listOf(
            "dev.lazyz.testing.Goldens", "example.Helper", "example.PictureTest\$case\$1", "java.lang.reflect.Method",
            "org.junit.platform.Invocation", "com.example.Runner",
        )
        assertEquals("example.PictureTest", CallingTest.name(stack))
        assertEquals("unknown", CallingTest.name(listOf("java.lang.Thread")))
    }

    private fun isThis() = assertEquals(CallingTestTest::class.java.name, CallingTest.name())
}
