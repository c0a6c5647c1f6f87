package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.scenes.ChildJava
import dev.lazyz.scenes.writers.AlphaChannel
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.exists
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

class DeepZoomMemoryTest {
    @TempDir
    lateinit var folder: Path

    /** A row of tiles alone has 39 MiB, and the sink promises 22 MiB. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aWidePyramidNeedsLessMemoryThanARowOfTiles() {
        val path = folder.resolve("wide.dzi")
        val main = DeepZoomInChild::class.java
        for (step in 1..2) assertEquals("step $step", ChildJava.run(main, listOf("-Xmx34m"), "$path", "$step"))
        assertTrue(path.exists())
    }
}

/** Writes a pyramid in a Java of its own, in two steps. */
internal object DeepZoomInChild {
    private const val WIDTH = 40_000
    private const val HEIGHT = 520

    @JvmStatic
    fun main(args: Array<String>) {
        val stop = if (args[1] == "1") 260 else HEIGHT
        try {
            DeepZoomFiles.resume(Path.of(args[0]), WIDTH, HEIGHT, AlphaChannel.DROP, mapOf()) { sink, first ->
                val argb = IntArray(WIDTH)
                for (y in first until stop) {
                    for (x in 0 until WIDTH) argb[x] = (x / 3 xor y / 5) * 0x10305
                    sink.row(y, argb, argb, argb)
                }
            }
        } catch (incomplete: IOException) {
            if (stop == HEIGHT) throw incomplete
        }
        println("step ${args[1]}")
    }
}
