package dev.lazyz.cli.batch

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class InputLabelsTest {
    private fun labels(vararg inputs: String) =
        InputLabels(inputs.asList()).let { labels -> inputs.indices.map { labels[it] } }

    @Test
    fun namesAloneAreEnoughIfTheyDiffer() {
        assertEquals(listOf("a", "b.c", "teapot", "standard input"), labels("x/a.obj", "y/b.c.stl", "teapot", "-"))
    }

    @Test
    fun foldersAndExtensionsTellTheSameNamesApart() {
        assertEquals(listOf("x/a", "y/a", "b"), labels("m/x/a.obj", "m/y/a.obj", "m/x/b.obj"))
        assertEquals(listOf("a.obj", "a.stl"), labels("x/a.obj", "x/a.stl"))
        assertEquals(listOf("x/n/a", "y/n/a"), labels("m/x/n/a.obj", "m/y/n/a.obj"))
        assertEquals(listOf("x/a.obj", "x/a.stl", "y/a.obj"), labels("x/a.obj", "x/a.stl", "y/a.obj"))
        assertEquals(listOf("teapot", "teapot.obj"), labels("teapot", "x/teapot.obj"))
        assertEquals(listOf("a", "x/a"), labels("a.obj", "x/a.obj"))
    }

    @Test
    fun anInputThatIsNamedTwiceHasOneName() {
        assertEquals(listOf("a", "a"), labels("x/a.obj", "x/a.obj"))
        assertEquals(listOf("x/a", "x/a", "y/a"), labels("x/a.obj", "x/a.obj", "y/a.obj"))
    }
}
