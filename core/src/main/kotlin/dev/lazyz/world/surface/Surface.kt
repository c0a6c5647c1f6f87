package dev.lazyz.world.surface

import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.geometry.Extent
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.world.material.Material
import java.util.function.UnaryOperator
import org.joml.Vector3dc

/**
 * A visible object in world space: a [Mesh], a [Polygon], a [Sphere], [Points], [Lines], or a custom surface.
 *
 * A custom surface converts its shape to primitives with the functions of [SetUp], or returns custom [Primitive]s. In
 * Java, [primitives] can return `list::iterator` for a list of them. What a scene, anti-aliasing and plans of memory
 * need to know of a surface, they ask it: [material], [origin], [pixelSize], [setUpBytes].
 * Implementations must be immutable and thread safe.
 */
public interface Surface : Extent {
    /**
     * The name of the part that this surface shows, or an empty text. Loaders give the path of names in the file, with
     * `/` between them, from the outermost to the innermost: `car/front axle/wheel`. Several surfaces can have the same
     * name. Functions that return a changed surface keep it.
     */
    public val name: String get() = ""

    /** The appearance; null if the surface has no [Material], or several. */
    public val material: Material? get() = null

    /**
     * The origin of the positions, world space: (0, 0, 0), unless the surface is so far from the world's origin that
     * single precision is too coarse. It can become the origin of shading, see `Scene.origin`.
     */
    public val origin: Vector3dc get() = Vectors.ZERO

    /**
     * The largest size that is given in samples of the raster and not in the world, as that of points, or the width of
     * lines; 0 if there is none. What has such a size casts no shadow.
     */
    public val pixelSize: Double get() = 0.0

    /** About how many bytes [primitives] take; by default those of a single primitive. */
    public val setUpBytes: Long get() = HeapLayout.SHAPE

    /**
     * Returns the primitives of the surface in submission order, set up for one raster and camera.
     *
     * A degenerate or invisible part must yield a primitive that covers nothing rather than no primitive, so that
     * submission indices do not depend on the camera. The sequence can be iterated more than once. In Java,
     * `list::iterator` is the sequence of a list.
     */
    public fun primitives(setUp: SetUp): Sequence<Primitive>

    /**
     * Returns this surface for a raster with [factor] times as many samples in each direction: what has a size in
     * samples of the raster, and not in the world, becomes larger by this factor. Anti-aliasing calls it, so that
     * points and lines keep their size in pixels. A surface that does not override this function has only sizes in the
     * world.
     */
    public fun magnified(factor: Int): Surface = this

    /**
     * Returns this surface with its materials replaced by the results of [change]; this surface itself if it has no
     * materials.
     */
    public fun withMaterials(change: UnaryOperator<Material>): Surface = this

    /** Whether there are texture coordinates of the [set] 0 or 1: whether maps of a material have an effect. */
    public fun hasUvs(set: Int): Boolean = true

    /** Returns this surface without the colours of vertices; this surface itself if it has none. */
    public fun withoutColors(): Surface = this

    /**
     * Returns this surface with another [name]; a custom surface that does not override this function keeps its own.
     */
    public fun withName(name: String): Surface = this

    /**
     * Returns this surface rotated so that the axis [up] becomes y, see `Scene.withUpAxis`.
     *
     * @throws UnsupportedOperationException if this kind of surface cannot be rotated: a custom surface that does not
     *   override this function
     */
    public fun withUpAxis(up: UpAxis): Surface = if (up == UpAxis.Y) {
        this
    } else {
        throw UnsupportedOperationException("a surface of class ${javaClass.name} cannot be rotated")
    }
}
