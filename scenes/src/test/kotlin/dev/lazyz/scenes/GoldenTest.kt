package dev.lazyz.scenes

import dev.lazyz.zbuffer.ZBuffer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.TestFactory

/**
 * The identity of every built-in scene's picture, committed: the machine, the JVM and its compiler have no say in a pixel
 * (contract rules 6.3 and 7.2). The build runs this class interpreted, too.
 *
 * After a change that is meant to change pictures, look at them, then take the new hashes from the failures.
 */
class GoldenTest {
    private val goldens: Map<String, String> =
        checkNotNull(javaClass.getResource("goldens.txt")).readText().lines()
            .filter { it.isNotBlank() && !it.startsWith("#") }
            .associate { it.substringBeforeLast(' ') to it.substringAfterLast(' ') }

    @TestFactory
    fun rule_7_2_builtinScenesHaveTheirCommittedPixelHash(): List<DynamicTest> = SIZES.flatMap { (width, height) ->
        Scenes.builtins.map { builtin ->
            val name = "${builtin.id} ${width}x$height"
            DynamicTest.dynamicTest(name) {
                val image = ZBuffer().render(builtin.scene().frame(width, height))
                assertEquals(goldens[name], image.pixelHash(), name)
            }
        }
    }

    @TestFactory
    fun everyGoldenHasItsScene(): List<DynamicTest> = goldens.keys.map { name ->
        DynamicTest.dynamicTest(name) {
            assertEquals(1, Scenes.builtins.count { it.id == name.substringBefore(' ') }, "no built-in scene for $name")
        }
    }

    private companion object {
        val SIZES = listOf(64 to 64, 160 to 120)
    }
}
