package dev.lazyz.world

import dev.lazyz.Checkpoint
import dev.lazyz.Frame
import dev.lazyz.OwnCheckpoint
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.Workers
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Extent
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.setup.SceneSetUp
import dev.lazyz.spi.Fragment
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.camera.Viewpoint
import dev.lazyz.world.light.AmbientVisibility
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.SceneLight
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.light.TurnedVisibility
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.Surface
import java.util.function.UnaryOperator
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Surfaces, lights and a viewpoint, in world space: right-handed, y up, any unit of length.
 *
 * Immutable and thread safe if its surfaces are (the built-in ones are). The order of [surfaces] is the submission
 * order, which resolves ties of depth (contract rule 5.2). The lists, also those of `with...` methods, are not copied;
 * do not change them.
 *
 * @property surfaces the surfaces, in submission order
 * @property lights light sources; if empty, [Light.studio] lights for the camera are used for materials without
 *   [MetallicRoughness]
 * @property viewpoint the camera, or a rule that chooses one
 * @property background colour of samples that no surface covers
 * @property environment what materials with [MetallicRoughness] reflect besides the [lights]; null means
 *   [Environment.USUAL], and [Environment.FAINT] for a scene with lights: metals with nothing to reflect would be black
 * @property toneMapping exposure and tone curve; null means [ToneMapping.Curve.NEUTRAL] for a scene with a material
 *   with [MetallicRoughness], and otherwise [ToneMapping.NONE]
 * @property ambientVisibility which part of ambient light and of the [environment] reaches a point; null for all of it
 * @property lightIntensity factor of all [lights], default lights included, and of the [environment]; 0 or more
 */
public class Scene private constructor(
    public val surfaces: List<Surface>,
    public val lights: List<Light>,
    public val viewpoint: Viewpoint,
    public val background: Rgba,
    public val environment: Environment?,
    public val toneMapping: ToneMapping?,
    public val ambientVisibility: AmbientVisibility?,
    public val lightIntensity: Float,
) : Extent {
    /** Creates a scene with the default [environment] and [toneMapping]; see the properties. */
    @JvmOverloads
    public constructor(
        surfaces: List<Surface>,
        lights: List<Light> = emptyList(),
        viewpoint: Viewpoint = Camera.fit(),
        background: Rgba = Rgba.WHITE,
    ) : this(surfaces, lights, viewpoint, background, null, null, null, 1f)

    init {
        require(lightIntensity >= 0f && lightIntensity.isFinite()) {
            "intensity of light must be 0 or more: $lightIntensity"
        }
    }

    /**
     * Whether the scene is given in screen coordinates ([Projection.Screen]): no camera looks at it, so that it cannot
     * be seen from elsewhere, turned or cut, and has no shadows. False if the [viewpoint] is not a [Camera].
     */
    public val isOnScreen: Boolean get() = (viewpoint as? Camera)?.projection == Projection.Screen

    /** The smallest box around all surfaces, or null if there is none. Computed once. */
    override val bounds: Box? by lazy { surfaces.mapNotNull { it.bounds }.reduceOrNull(Box::union) }

    /** Cost: for meshes, points and lines a fraction of their vertices, after all of them were visited once. */
    override fun farthest(direction: Vector3dc): Vector3d? {
        var farthest: Vector3d? = null
        var most = Double.NEGATIVE_INFINITY
        for (surface in surfaces) {
            val point = surface.farthest(direction) ?: continue
            val product = Vectors.dot(direction, point)
            if (product > most) {
                most = product
                farthest = point
            }
        }
        return farthest
    }

    /**
     * The origin of shading: [Fragment.worldX], [Fragment.worldY] and [Fragment.worldZ] are relative to it. It is the
     * origin of the first surface whose own origin is not zero (in scenes far from the world's origin), or else the
     * world's origin.
     */
    public val origin: Vector3dc by lazy {
        surfaces.firstNotNullOfOrNull { surface -> surface.origin.takeIf { !Vectors.isZero(it) } } ?: Vectors.ZERO
    }

    /** About how many bytes [frame] takes, in addition to the scene, see [Surface.setUpBytes]. */
    public val setUpBytes: Long get() = surfaces.sumOf { it.setUpBytes }

    /** The [toneMapping], or the default one for this scene if it is null. */
    public val effectiveToneMapping: ToneMapping
        get() = toneMapping ?: when {
            surfaces.any { it.material?.isPhysical == true } -> ToneMapping(ToneMapping.Curve.NEUTRAL)
            else -> ToneMapping.NONE
        }

    /**
     * Returns the camera for a raster of [width] x [height] samples.
     *
     * @throws IllegalArgumentException if a side is below 1
     */
    public fun camera(width: Int, height: Int): Camera {
        require(width >= 1 && height >= 1) { "sides must be at least 1: $width x $height" }
        return viewpoint.camera(this, width.toDouble() / height)
    }

    /**
     * Returns the primitives of the scene on a raster, in submission order. Each is set up when the sequence reaches
     * it.
     *
     * The sequence can be iterated more than once. Cost: linear in the size of the scene; memory for the vertices of
     * one surface at a time.
     */
    public fun primitives(raster: Raster): Sequence<Primitive> {
        val setUp = setUp(raster)
        return surfaces.asSequence().flatMap { it.primitives(setUp) }
    }

    /** Returns what makes primitives of surfaces on [raster], for the camera and the lights of this scene. */
    public fun setUp(raster: Raster): SetUp = setUp(raster, Workers.ALL, Checkpoint.NONE)

    private fun setUp(raster: Raster, workers: Workers, checkpoint: Checkpoint): SceneSetUp {
        val camera = camera(raster.width, raster.height)
        val light = SceneLight(
            scaled(lights.ifEmpty { Light.studio(camera) }),
            scaled(lights),
            effectiveEnvironment,
            effectiveToneMapping,
            ambientVisibility,
        )

        // A viewpoint can also return a camera of the screen, which has no other origin
        val shadingOrigin = if (camera.projection == Projection.Screen) Vectors.ZERO else origin
        return SceneSetUp(raster, camera, light, shadingOrigin, workers, checkpoint)
    }

    /** The [environment], or the default one for this scene if it is null, times the [lightIntensity]. */
    internal val effectiveEnvironment: Environment
        get() {
            val own = environment ?: if (lights.isEmpty()) Environment.USUAL else Environment.FAINT
            return if (lightIntensity == 1f) own else own.scaled(lightIntensity)
        }

    private fun scaled(lights: List<Light>): List<Light> =
        if (lightIntensity == 1f) lights else lights.map { it.scaled(lightIntensity) }

    /**
     * Sets up the scene for a raster of [width] x [height] samples and the scene's background. This is the usual way to
     * get a frame.
     *
     * @throws IllegalArgumentException if a side is not in 1..[Raster.MAX_SIDE]
     * @throws InterruptedException as the other [frame]
     */
    @Throws(InterruptedException::class)
    public fun frame(width: Int, height: Int): Frame = frame(Raster(width, height, background))

    /**
     * Sets up the scene for [raster], whose background replaces the scene's own. Cost: linear in the size of the scene.
     * Opaque meshes are stored as arrays, with 20 bytes a vertex and no object for each triangle; large ones are set up
     * in parallel. A scene with a [StreamedMesh] gives a streamed frame, see [Frame.isStreamed].
     *
     * @param options [RenderOptions.threads] and [RenderOptions.executor] are used, the others are not
     * @throws InterruptedException if the calling thread is interrupted; after at most 100 ms of processor time, unless
     *   a custom surface takes longer for a primitive
     */
    @JvmOverloads
    @Throws(InterruptedException::class)
    public fun frame(raster: Raster, options: RenderOptions = RenderOptions()): Frame =
        OwnCheckpoint().use { checkpoint ->
            val setUp = setUp(raster, options.workers, checkpoint)
            Frame(raster, SceneContent(surfaces, setUp).content(), raster.region)
        }

    /**
     * Returns this scene with each material replaced by the result of [change]. Where [change] adds a texture or
     * another map, it has no effect on surfaces without the texture coordinates that it needs: these get the material
     * without the map.
     *
     * @throws IllegalArgumentException if no surface has the texture coordinates that the added maps need
     */
    public fun withMaterials(change: UnaryOperator<Material>): Scene {
        var bare = 0
        var mapped = 0
        val changed = surfaces.map { surface ->
            surface.withMaterials { material ->
                val result = change.apply(material)
                val added = result.uvSets - material.uvSets
                val canShow = added.all { surface.hasUvs(it) }
                if (added.isNotEmpty()) if (canShow) mapped++ else bare++
                if (canShow) result else result.withMapsOf { it in material.uvSets || surface.hasUvs(it) }
            }
        }
        require(bare == 0 || mapped > 0) {
            "the materials need texture coordinates, and none of the ${surfaces.size} surfaces has them"
        }
        return copy(surfaces = changed)
    }

    /**
     * Returns this scene, in which the axis [up] points up, rotated so that y points up. Its lights, its camera and its
     * [ambientVisibility] are rotated, too; a rule such as [Camera.fit] is kept. Cost: a copy of all positions and
     * normals.
     *
     * @throws UnsupportedOperationException if the scene is given on the screen, see [isOnScreen], or a surface cannot
     *   be rotated, see [Surface.withUpAxis]
     */
    public fun withUpAxis(up: UpAxis): Scene = if (up == UpAxis.Y) {
        this
    } else {
        val turned = copy(
            surfaces = surfaces.map { it.withUpAxis(up) },
            lights = lights.map { it.withUpAxis(up) },
            viewpoint = if (viewpoint is Camera) viewpoint.withUpAxis(up) else viewpoint,
        )
        turned.withAmbientVisibility(
            ambientVisibility?.let { TurnedVisibility(it, up, Vectors.minus(up.toModel(turned.origin), origin)) },
        )
    }

    /** Returns this scene with other surfaces. */
    public fun withSurfaces(surfaces: List<Surface>): Scene = copy(surfaces = surfaces)

    /** Returns this scene with another viewpoint. */
    public fun withViewpoint(viewpoint: Viewpoint): Scene = copy(viewpoint = viewpoint)

    /** Returns this scene with other lights. */
    public fun withLights(lights: List<Light>): Scene = copy(lights = lights)

    /** Returns this scene with another background. */
    public fun withBackground(background: Rgba): Scene = copy(background = background)

    /** Returns this scene with another environment; null for the default one. */
    public fun withEnvironment(environment: Environment?): Scene = copy(environment = environment)

    /** Returns this scene with another tone mapping; null for the default one. */
    public fun withToneMapping(toneMapping: ToneMapping?): Scene = copy(toneMapping = toneMapping)

    /** Returns this scene with another visibility of ambient light; null for none. */
    public fun withAmbientVisibility(ambientVisibility: AmbientVisibility?): Scene =
        copy(ambientVisibility = ambientVisibility)

    /**
     * Returns this scene with another factor of its light.
     *
     * @throws IllegalArgumentException if [lightIntensity] is negative or not finite
     */
    public fun withLightIntensity(lightIntensity: Float): Scene = copy(lightIntensity = lightIntensity)

    private fun copy(
        surfaces: List<Surface> = this.surfaces,
        lights: List<Light> = this.lights,
        viewpoint: Viewpoint = this.viewpoint,
        background: Rgba = this.background,
        environment: Environment? = this.environment,
        toneMapping: ToneMapping? = this.toneMapping,
        ambientVisibility: AmbientVisibility? = this.ambientVisibility,
        lightIntensity: Float = this.lightIntensity,
    ): Scene = Scene(
        surfaces, lights, viewpoint, background, environment, toneMapping, ambientVisibility, lightIntensity,
    )

    override fun toString(): String = "Scene(${surfaces.size} surfaces, ${lights.size} lights, $viewpoint)"

    /** Builds a scene step by step. Intended for Java; in Kotlin, [scene] is shorter. Not thread safe. */
    public class Builder {
        private val surfaces = ArrayList<Surface>()
        private val lights = ArrayList<Light>()

        /** The scene without surfaces and lights. */
        private var rest = Scene(emptyList())

        /** Adds a surface after those already added, in submission order. */
        public fun add(surface: Surface): Builder = apply { surfaces.add(surface) }

        /** Adds a light. If no light is added, the scene uses [Light.studio] lights. */
        public fun light(light: Light): Builder = apply { lights.add(light) }

        /** Sets the camera, or a rule that chooses one. The default is [Camera.fit]. */
        public fun viewpoint(viewpoint: Viewpoint): Builder = apply { rest = rest.withViewpoint(viewpoint) }

        /** Sets the background. The default is white. */
        public fun background(background: Rgba): Builder = apply { rest = rest.withBackground(background) }

        /** Sets the environment. The default, null, is described at [Scene.environment]. */
        public fun environment(environment: Environment?): Builder = apply { rest = rest.withEnvironment(environment) }

        /** Sets exposure and tone curve. The default, null, is described at [Scene.toneMapping]. */
        public fun toneMapping(toneMapping: ToneMapping?): Builder = apply { rest = rest.withToneMapping(toneMapping) }

        /** Sets the visibility of ambient light. The default is null: nothing hides it. */
        public fun ambientVisibility(ambientVisibility: AmbientVisibility?): Builder =
            apply { rest = rest.withAmbientVisibility(ambientVisibility) }

        /**
         * Sets the factor of all light, 0 or more. The default is 1.
         *
         * @throws IllegalArgumentException if it is negative or not finite
         */
        public fun lightIntensity(lightIntensity: Float): Builder =
            apply { rest = rest.withLightIntensity(lightIntensity) }

        /** Returns the scene so far. The builder can be used further. */
        public fun build(): Scene = rest.withSurfaces(surfaces.toList()).withLights(lights.toList())
    }

    public companion object {
        /** Returns an empty builder. */
        @JvmStatic
        public fun builder(): Builder = Builder()
    }
}

/**
 * Builds a scene in a block: `scene { add(mesh); background(Rgba.BLACK) }`.
 */
@JvmSynthetic
public fun scene(block: Scene.Builder.() -> Unit): Scene = Scene.builder().apply(block).build()
