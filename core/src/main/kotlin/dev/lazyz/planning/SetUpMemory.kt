package dev.lazyz.planning

import dev.lazyz.world.Scene
import dev.lazyz.world.material.AlphaMode
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.Surface

/** The memory for setting up a scene, `scene.frame(...)`, before it is known in detail. */
public object SetUpMemory {
    /** The snapped vertices, and copies for another up axis or another colour. */
    private const val VERTEX_BYTES = 60L

    /** The object of a triangle that is drawn alone. */
    private const val TRIANGLE_BYTES = 400L
    private const val SHAPE_BYTES = 512L
    private const val CORNER_BYTES = 100L

    /**
     * Returns how many bytes the set-up of [scene] takes about, in addition to the scene, including the frame. Custom
     * surfaces count as a single primitive.
     */
    @JvmStatic
    public fun bytes(scene: Scene): Long = scene.surfaces.sumOf { bytes(it) }

    private fun bytes(surface: Surface): Long = when (surface) {
        is Mesh -> {
            val isBatch = surface.material.alphaMode == AlphaMode.OPAQUE
            VERTEX_BYTES * surface.vertexCount + if (isBatch) 0 else TRIANGLE_BYTES * surface.triangleCount
        }

        is StreamedMesh -> 0

        is Polygon -> SHAPE_BYTES + CORNER_BYTES * surface.contours.sumOf { it.size }

        is Points -> SHAPE_BYTES * surface.pointCount

        is Lines -> SHAPE_BYTES * surface.segmentCount

        else -> SHAPE_BYTES
    }
}
