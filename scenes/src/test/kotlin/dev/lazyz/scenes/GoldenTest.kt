package dev.lazyz.scenes

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory

/**
 * The identity of every picture of [Goldens], committed: the machine, the JVM, its compiler and the renderer have no
 * say in a pixel (contract rules 6.3, 7.1 and 7.2). By default each picture is rendered by one renderer, by all in
 * turn, which the continuous build runs interpreted, too; with `-Dlazyz.effort=rest` or `full` by all.
 * `.ci/other-processors` renders the same pictures on processors of other kinds.
 *
 * After a change that is meant to change pictures, look at them, then take the new hashes from the failures.
 */
class GoldenTest {
    @TestFactory
    fun rule_7_2_scenesHaveTheirCommittedPixelHash(): List<DynamicTest> = Goldens.pictures.mapIndexed { i, picture ->
        dynamicTest(picture.name) {
            assertTrue(picture.renderers.isNotEmpty())
            for (renderer in if (isDefault) listOf(picture.renderers.inTurn(i)) else picture.renderers) {
                assertEquals(picture.expected, picture.hash(renderer)) { "${picture.name} by ${renderer.id}" }
            }
        }
    }

    private val isDefault = System.getProperty("lazyz.effort") == null

    private fun <T> List<T>.inTurn(i: Int): T = this[i % size]

    @Test
    fun everyGoldenHasItsScene() = assertEquals(Goldens.pictures.map { it.name }.toSet(), Goldens.hashes.keys)
}
