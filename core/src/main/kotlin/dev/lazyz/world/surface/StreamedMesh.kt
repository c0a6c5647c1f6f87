package dev.lazyz.world.surface

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.UpAxis
import dev.lazyz.world.material.AlphaMode
import dev.lazyz.world.material.Material
import java.util.function.UnaryOperator
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A mesh that is not in memory: its triangles are read from [source] part by part, once for each rendering. A frame of
 * a scene with such a mesh is streamed, see [Frame.isStreamed].
 *
 * The picture is the one of a [Mesh] with the same triangles, material, normals, colours and texture coordinates, bit
 * for bit. Functions that look at the triangles of a [Mesh], such as sections, line drawings and shadows, ignore this
 * surface. Thread safe if the source is.
 *
 * @property source the triangles
 * @property material the appearance; renderers accept it only if it is opaque
 */
public class StreamedMesh private constructor(
    public val source: MeshSource,
    public val material: Material,
    private val up: UpAxis,
) : Surface {
    /** Creates a mesh in which y points up. */
    @JvmOverloads
    public constructor(source: MeshSource, material: Material = Material()) : this(source, material, UpAxis.Y)

    /** Number of triangles. */
    public val triangleCount: Int get() = source.triangleCount

    /** The origin of all positions, world space, see [Mesh.origin]. */
    public val origin: Vector3dc = up.toWorld(source.origin)

    internal val isTranslucent: Boolean get() = material.alphaMode == AlphaMode.BLEND

    override val bounds: Box? by lazy {
        source.bounds?.let { box ->
            val corners = listOf(Vector3d(box.minX, box.minY, box.minZ), Vector3d(box.maxX, box.maxY, box.maxZ))
                .map { up.toWorld(it) }
            corners.map { Box(it.x, it.y, it.z, it.x, it.y, it.z) }.reduce(Box::union)
        }
    }

    override fun farthest(direction: Vector3dc): Vector3d? =
        source.farthest(up.toModel(direction))?.let { up.toWorld(it) }

    /** Returns the triangles as meshes, in order, for one pass over them. */
    public fun parts(): Iterator<Mesh> = source.parts().asSequence().map { part ->
        val dyed = if (part.material == material) part else part.withMaterials { material }
        if (up == UpAxis.Y) dyed else dyed.withUpAxis(up)
    }.iterator()

    override fun primitives(setUp: SetUp): Sequence<Primitive> =
        Sequence { parts() }.flatMap { setUp.mesh(it) }

    override fun withMaterials(change: UnaryOperator<Material>): StreamedMesh =
        StreamedMesh(source, change.apply(material), up)

    /**
     * Returns this mesh rotated so that the axis [up] becomes y.
     *
     * @throws UnsupportedOperationException if it is rotated already
     */
    override fun withUpAxis(up: UpAxis): StreamedMesh = when {
        up == UpAxis.Y -> this
        this.up == UpAxis.Y -> StreamedMesh(source, material, up)
        else -> throw UnsupportedOperationException("a streamed mesh can be rotated only once")
    }

    override fun toString(): String = "StreamedMesh($triangleCount triangles, $material)"
}
