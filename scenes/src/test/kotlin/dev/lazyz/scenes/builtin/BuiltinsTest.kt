package dev.lazyz.scenes.builtin

import dev.lazyz.scenes.Builtin
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.scenefile.SceneFile
import dev.lazyz.scenes.scenefile.parsed
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.MethodSource

class BuiltinsTest {
    @ParameterizedTest
    @MethodSource("builtins")
    fun fillsASensiblePartOfThePictureAtAnySize(builtin: Builtin) {
        for ((width, height) in listOf(64 to 64, 64 to 48, 48 to 96)) {
            val image = ZBufferRenderer().render(builtin.scene().frame(width, height))
            val part = image.visible / (width.toDouble() * height)
            assertTrue(part in 0.05..0.98, "$part of ${width}x$height")
            assertTrue(image.argb.toSet().size >= 3, "only ${image.argb.toSet().size} colours")
        }
    }

    @ParameterizedTest
    @MethodSource("builtins")
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun rendersToTheSameBitsFromASceneFile(builtin: Builtin) {
        val scene = builtin.scene()
        val back = parsed(SceneFile.format(scene)).scene
        assertEquals(ZBufferRenderer().render(scene.frame(80, 60)), ZBufferRenderer().render(back.frame(80, 60)))
    }

    @Test
    fun idsAreUniqueWords() {
        val ids = Scenes.builtins.map { it.id }
        assertEquals(listOf("teapot", "cycle", "crossing", "molecule", "city", "layers", "plane", "star"), ids)
        assertEquals(null, Scenes.builtin("nothing"))
    }

    @Test
    fun moleculeHasTheBondsOfCaffeine() {
        val atoms = MoleculeScene.scene().surfaces.map { it as Sphere }
        val count = atoms.groupingBy { it.material.name }.eachCount()
        assertEquals(mapOf("oxygen" to 2, "nitrogen" to 4, "carbon" to 8, "hydrogen" to 10), count)

        // Two atoms are bonded, 1.0 to 1.5 angstrom apart, or well separated; 25 bonds of 24 atoms make two rings
        var bonds = 0
        for (i in atoms.indices) {
            for (j in 0 until i) {
                val distance = Vector3d(atoms[i].center).distance(atoms[j].center)
                assertFalse(distance < 1.0 || distance in 1.55..1.7, "atoms $i and $j are $distance apart")
                if (distance < 1.55) bonds++
            }
        }
        assertEquals(25, bonds)
    }

    @Test
    fun citiesDifferBySeedAndGrowWithBlocks() {
        assertNotEquals(SceneFile.format(Scenes.city(2, 1)), SceneFile.format(Scenes.city(2, 2)))
        assertEquals(SceneFile.format(Scenes.city(2, 7)), SceneFile.format(Scenes.city(2, 7)))
        fun houses(blocks: Int) = Scenes.city(blocks).surfaces.drop(1).take(4).sumOf { (it as Mesh).triangleCount } / 8
        assertEquals(4, houses(1))
        assertEquals(4 * 25, houses(5))
    }

    @Test
    fun parametersAreChecked() {
        assertThrows(IllegalArgumentException::class.java) { Scenes.teapot(0) }
        assertThrows(IllegalArgumentException::class.java) { Scenes.city(0) }
        assertThrows(IllegalArgumentException::class.java) { Scenes.city(101) }
        assertThrows(IllegalArgumentException::class.java) { Scenes.layers(0) }
        assertEquals(64 * 9 - 24, (Scenes.teapot(3).surfaces.single() as Mesh).triangleCount)
    }

    private companion object {
        @JvmStatic
        fun builtins(): List<Builtin> = Scenes.builtins
    }
}
