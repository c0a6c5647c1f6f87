package dev.lazyz.setup

import dev.lazyz.Primitive
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Contract rule 9.1: a cut keeps its precision, however long the edge is. */
class DistantVertexTest {
    @Test
    fun rule_9_1_anEdgeToAVeryDistantVertexIsCutAtTheSamePlace() {
        val distant = triangleTo(1e12f)
        for (y in listOf(1e15f, 1e20f, 1e30f)) {
            val further = triangleTo(y)
            assertEquals(distant.depthForm, further.depthForm, "$y")
            assertEquals(distant.leastDepth to distant.greatestDepth, further.leastDepth to further.greatestDepth, "$y")
            assertEquals(distant.columnStart until distant.columnEnd, further.columnStart until further.columnEnd, "$y")
        }
    }

    private fun triangleTo(y: Float): Primitive {
        val positions = floatArrayOf(0f, 0f, 0.125f, 0f, y, 0f, -0.125f, -12f, 0f)
        val mesh = Mesh(positions, intArrayOf(1, 2, 0), Material(shading = Shading.CONSTANT))
        val camera = Camera.perspective(Vector3d(-3.0, -1.0, 2.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 40.0, 0.5, 10.0)
        return Scene(listOf(mesh), viewpoint = camera).frame(5, 5).primitives.single()
    }
}
