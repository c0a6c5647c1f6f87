package dev.lazyz.scenes.scenefile

import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d
import org.joml.Vector3dc
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class TransformReaderTest {
    @Test
    fun movementsAreAppliedInOrder() {
        assertEquals(Vector3d(12.0, 2.0, 3.0), moved("""{"scale": 2}, {"translate": [10, -2, -3]}""", 1.0, 2.0, 3.0))
        assertEquals(Vector3d(22.0, 0.0, 0.0), moved("""{"translate": [10, -2, -3]}, {"scale": 2}""", 1.0, 2.0, 3.0))
    }

    @Test
    fun quarterTurnsAreExactAndCounterClockwise() {
        assertEquals(Vector3d(-2.0, 1.0, 3.0), moved(rotate("0, 0, 1", "90"), 1.0, 2.0, 3.0))
        assertEquals(Vector3d(1.0, 3.0, -2.0), moved(rotate("5, 0, 0", "-90"), 1.0, 2.0, 3.0))
        assertEquals(Vector3d(-1.0, 2.0, -3.0), moved(rotate("0, 1, 0", "540"), 1.0, 2.0, 3.0))
        assertEquals(Vector3d(-3.0, 2.0, 1.0), moved(rotate("0, 1, 0", "270"), 1.0, 2.0, 3.0))
    }

    @Test
    fun otherTurnsKeepLengthAndAngle() {
        val point = moved(rotate("1, 1, 1", "120"), 1.0, 2.0, 3.0)
        assertEquals(0.0, Vector3d(point).distance(3.0, 1.0, 2.0), 1e-14)
        val small = moved(rotate("0, 0, 1", "30"), 1.0, 0.0, 0.0)
        assertEquals(0.0, Vector3d(small).distance(StrictMath.sqrt(0.75), 0.5, 0.0), 1e-15)
    }

    @Test
    fun aMatrixIsGivenByRows() {
        val matrix = """{"matrix": [[0, -1, 0, 10], [1, 0, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]]}"""
        assertEquals(Vector3d(8.0, 21.0, 33.0), moved(matrix, 1.0, 2.0, 3.0))
    }

    private fun rotate(axis: String, degrees: String): String = """{"rotate": {"axis": [$axis], "degrees": $degrees}}"""

    private fun moved(steps: String, x: Double, y: Double, z: Double): Vector3dc {
        val sphere = """{"sphere": {"center": [$x, $y, $z], "radius": 1}, "transform": [$steps]}"""
        val scene = parsed("""{"lazyz": 1, "surfaces": [$sphere]}""").scene
        val center = (scene.surfaces.single() as Sphere).center

        // The two zeros are equal here
        return Vector3d(center.x() + 0.0, center.y() + 0.0, center.z() + 0.0)
    }
}
