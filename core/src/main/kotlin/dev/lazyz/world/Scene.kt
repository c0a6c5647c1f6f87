package dev.lazyz.world

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Vectors
import org.joml.Vector3dc

/**
 * Surfaces, lights and a point of view, in world space: right-handed, y up, any unit of length.
 *
 * Immutable and thread safe if its surfaces are (the built-in ones are). The order of [surfaces] is the order of
 * submission, which decides ties of depth (contract rule 5.2).
 *
 * @property surfaces what there is to see, in submission order
 * @property lights sources of light; none at all means [Light.studio] lights, fixed to the camera
 * @property viewpoint the camera, or a rule that finds one
 * @property background colour of samples that no surface covers
 */
public class Scene @JvmOverloads constructor(
    public val surfaces: List<Surface>,
    public val lights: List<Light> = emptyList(),
    public val viewpoint: Viewpoint = Camera.fit(),
    public val background: Rgba = Rgba.WHITE,
) {
    /** The least box around all surfaces, or null if there is nothing in it. Computed once. */
    public val bounds: Box? by lazy { surfaces.mapNotNull { it.bounds }.reduceOrNull(Box::union) }

    /**
     * Where shading has its origin: [Fragment.worldX] and its like are relative to it. That of the first surface that has one
     * of its own, in scenes far away from the world's origin; else the world's.
     */
    public val origin: Vector3dc by lazy {
        surfaces.firstNotNullOfOrNull { surface -> originOf(surface)?.takeIf { !Vectors.isZero(it) } } ?: Vectors.ZERO
    }

    /** Returns the camera that a raster of this size sees the scene through. */
    public fun camera(width: Int, height: Int): Camera = viewpoint.camera(bounds, width.toDouble() / height)

    /**
     * Returns the scene's primitives on a raster, in submission order, each set up when it is asked for.
     *
     * The sequence may be walked more than once. Cost: linear in the size of the scene, memory for one surface's
     * vertices at a time.
     */
    public fun primitives(raster: Raster): Sequence<Primitive> {
        val setUp = setUp(raster)
        return surfaces.asSequence().flatMap { it.primitives(setUp) }
    }

    private fun setUp(raster: Raster): SetUp {
        val camera = camera(raster.width, raster.height)
        val isOnScreen = camera.projection == Projection.Screen
        return SetUp(raster, camera, lights.ifEmpty { Light.studio(camera) }, if (isOnScreen) Vectors.ZERO else origin)
    }

    /** Sets the scene up for a raster of [width] x [height] samples, the usual way to a picture. */
    public fun frame(width: Int, height: Int): Frame = frame(Raster(width, height, background))

    /**
     * Sets the scene up for [raster], whose background replaces the scene's own. Cost: linear in the size of the scene.
     * Opaque meshes are kept as arrays, with 20 bytes a vertex and nothing for each triangle, and large ones are set up by
     * several threads.
     */
    public fun frame(raster: Raster): Frame {
        val setUp = setUp(raster)
        val content = FrameContent.Builder()
        for (surface in surfaces) {
            val batch = if (surface is Mesh) setUp.batch(surface, content.next) else null
            if (batch != null) content.add(batch) else surface.primitives(setUp).forEach(content::add)
        }
        return Frame(raster, content.build(), raster.region)
    }

    /** Returns this scene with each material replaced by what [change] makes of it. */
    public fun withMaterials(change: (Material) -> Material): Scene =
        Scene(surfaces.map { it.withMaterials(change) }, lights, viewpoint, background)

    /** Returns this scene seen from elsewhere. */
    public fun withViewpoint(viewpoint: Viewpoint): Scene = Scene(surfaces, lights, viewpoint, background)

    /** Returns this scene in other light. */
    public fun withLights(lights: List<Light>): Scene = Scene(surfaces, lights, viewpoint, background)

    /** Returns this scene before another background. */
    public fun withBackground(background: Rgba): Scene = Scene(surfaces, lights, viewpoint, background)

    override fun toString(): String = "Scene(${surfaces.size} surfaces, ${lights.size} lights, $viewpoint)"

    /** Collects a scene step by step; made for Java, where [scene] has no lambda with receiver. Not thread safe. */
    public class Builder {
        private val surfaces = ArrayList<Surface>()
        private val lights = ArrayList<Light>()
        private var viewpoint: Viewpoint = Camera.fit()
        private var background: Rgba = Rgba.WHITE

        /** Adds a surface behind those already added in submission order. */
        public fun add(surface: Surface): Builder = apply { surfaces.add(surface) }

        /** Adds a light. Without any, the scene gets [Light.studio] lights. */
        public fun light(light: Light): Builder = apply { lights.add(light) }

        /** Sets the camera, or the rule that finds one; [Camera.fit] unless it is called. */
        public fun viewpoint(viewpoint: Viewpoint): Builder = apply { this.viewpoint = viewpoint }

        /** Sets the background; white unless it is called. */
        public fun background(background: Rgba): Builder = apply { this.background = background }

        /** Returns the scene so far; the builder may go on. */
        public fun build(): Scene = Scene(surfaces.toList(), lights.toList(), viewpoint, background)
    }

    public companion object {
        /** Returns an empty builder. */
        @JvmStatic
        public fun builder(): Builder = Builder()

        private fun originOf(surface: Surface): Vector3dc? = when (surface) {
            is Mesh -> surface.origin
            is Points -> surface.origin
            is Lines -> surface.origin
            else -> null
        }
    }
}

/**
 * Builds a scene in a block: `scene { add(mesh); background(Rgba.BLACK) }`.
 */
public fun scene(block: Scene.Builder.() -> Unit): Scene = Scene.builder().apply(block).build()
