package dev.lazyz.world.surface

import dev.lazyz.Checkpoint
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Workers
import dev.lazyz.geometry.Extent
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.spi.Shader
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import java.util.function.UnaryOperator
import org.joml.Vector3d
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

/**
 * Converts surfaces to primitives: transforms, clips, projects and snaps them, and computes their linear forms.
 *
 * All rounding happens here, once, before rendering. A custom [Surface] calls these functions from
 * [Surface.primitives]. Immutable and thread safe.
 */
public abstract class SetUp internal constructor() {
    /** The samples to cover. */
    public abstract val raster: Raster

    /** The camera. */
    public abstract val camera: Camera

    /** The origin of shading, see `Scene.origin`; 0 for [Projection.Screen]. */
    public abstract val origin: Vector3dc

    /** Light sources, in the order in which they are added up. */
    public abstract val lights: List<Light>

    internal abstract val workers: Workers
    internal abstract val checkpoint: Checkpoint

    /**
     * Returns the triangles of [mesh] in order, each set up when the sequence reaches it. All vertices are transformed
     * when the iteration starts; this takes 128 bytes a vertex.
     */
    public abstract fun mesh(mesh: Mesh): Sequence<Primitive>

    /** Returns [polygon] as a single primitive. */
    public abstract fun polygon(polygon: Polygon): Primitive

    /** Returns [sphere] as a single primitive. */
    public abstract fun sphere(sphere: Sphere): Primitive

    /** Returns the points of [points] in order, each set up when the sequence reaches it; 32 bytes a point. */
    public abstract fun points(points: Points): Sequence<Primitive>

    /** Returns the segments of [lines] in order, each set up when the sequence reaches it; 96 bytes a segment. */
    public abstract fun lines(lines: Lines): Sequence<Primitive>

    /**
     * Returns where [point] of world space is on the raster, or null if it is not between the near and the far plane,
     * or more than 2^19 pixels from the raster's origin. It may be outside the raster.
     */
    public abstract fun project(point: Vector3dc): ScreenPoint?

    /**
     * Returns the ray from the camera through the sample at column [x] and row [y], in world space. A point at distance
     * t, see [Ray.at], has the depth [depth] (t).
     */
    public abstract fun ray(x: Int, y: Int): Ray

    /**
     * Returns the depth of a point whose distance from the camera along the line of sight is [distance], world units;
     * it must be from the near to the far plane.
     */
    public abstract fun depth(distance: Double): Int

    /**
     * Returns the shader for [material] and the [lights]; the material's own shader if it has one. A custom primitive
     * sets the attributes of a fragment and then calls it; a custom shader may call it and change the colour. Light is
     * evaluated at each sample: FLAT and GOURAUD count as PHONG.
     */
    public abstract fun shader(material: Material): Shader

    override fun toString(): String = "SetUp($raster, $camera, ${lights.size} lights)"

    /**
     * A ray through a sample, in world space. Immutable.
     *
     * @property origin where it starts: the camera's eye for perspective, otherwise a point in the plane of the eye
     * @property direction its direction, of such a length that its component along the line of sight is 1
     */
    public class Ray internal constructor(public val origin: Vector3dc, public val direction: Vector3dc) {
        /** Returns the point at [distance] from the camera along the line of sight, world units. A new vector. */
        public fun at(distance: Double): Vector3d = Vector3d(
            origin.x() + direction.x() * distance,
            origin.y() + direction.y() * distance,
            origin.z() + direction.z() * distance,
        )

        override fun toString(): String = "Ray($origin, $direction)"
    }

    /**
     * A point on the raster. Immutable.
     *
     * @property x column position, pixels, a multiple of 1/256; the sample of column 0 is at 0.5
     * @property y row position, pixels, a multiple of 1/256; the sample of row 0 is at 0.5
     * @property depth depth, 0..2^31-1
     */
    public class ScreenPoint internal constructor(public val x: Double, public val y: Double, public val depth: Int) {
        override fun toString(): String = "ScreenPoint($x, $y, depth $depth)"
    }
}
