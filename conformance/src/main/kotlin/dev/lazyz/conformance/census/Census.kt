package dev.lazyz.conformance.census

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.Collections
import java.util.EnumSet
import java.util.IdentityHashMap
import org.joml.Vector3d

/** Counts the frames of a rule by their traits. Thread safe, because a rule may render frames in several threads. */
internal class Census {
    private val pairs = PairCounts()
    private val seen = Collections.newSetFromMap(IdentityHashMap<Frame, Boolean>())
    private var frames = 0L
    private var unexamined = 0L

    /** Starts a new try: each frame is counted once per try. */
    @Synchronized
    fun nextTry() = seen.clear()

    /**
     * Counts [frame], unless it was already counted in this try.
     *
     * @param scene the scene of the frame, or null
     * @param how how the renderer differs from the default; empty if it does not
     */
    @Synchronized
    fun add(frame: Frame, scene: Scene? = null, how: String = "") {
        if (!seen.add(frame)) return
        frames++
        val traits = try {
            if (frame.width.toLong() * frame.primitives.size > MOST_IN_A_ROW) null else traits(frame, scene, how)
        } catch (_: Exception) {
            // Custom primitives may throw anything; the census itself must not fail
            null
        }
        if (traits == null) unexamined++ else pairs.add(traits)
    }

    @Synchronized
    fun distribution(): Distribution = Distribution(frames, unexamined, PairCounts() + pairs)

    companion object {
        /**
         * Greatest product of columns and primitives. Larger frames are few, and examining them would take longer than
         * rendering them.
         */
        private const val MOST_IN_A_ROW = 100_000L

        /** Returns the traits of [frame]; see [add]. Time: samples x primitives, less for large frames. */
        fun traits(frame: Frame, scene: Scene? = null, how: String = ""): Set<FrameTrait> {
            val traits = rasterTraits(frame.raster)
            if (frame.primitives.isEmpty()) traits.add(FrameTrait.NO_PRIMITIVES)
            if (frame.region != frame.raster.region) traits.add(FrameTrait.REGION)
            if (frame.hasTranslucency) traits.add(FrameTrait.TRANSLUCENT)
            if (maxOf(frame.width, frame.height) > USUAL_TILE) traits.add(FrameTrait.SEVERAL_TILES)
            if (frame.primitives.any { it.depthForm == null }) traits.add(FrameTrait.FORMLESS)
            if (how.isNotEmpty()) traits.add(FrameTrait.CONFIGURED)
            if (scene != null) addSceneTraits(scene, traits)
            SampleTraits(frame).addTo(traits)
            return traits
        }

        private const val USUAL_TILE = 64
    }
}

/** Returns the traits that a raster gives to its frames. */
internal fun rasterTraits(raster: Raster): EnumSet<FrameTrait> {
    val test = when (raster.depthTest) {
        DepthTest.LESS -> FrameTrait.LESS
        DepthTest.LESS_OR_EQUAL -> FrameTrait.LESS_OR_EQUAL
        DepthTest.GREATER -> FrameTrait.GREATER
        DepthTest.GREATER_OR_EQUAL -> FrameTrait.GREATER_OR_EQUAL
    }
    val convention = when (raster.convention) {
        DepthConvention.SMALLER_IS_NEARER -> FrameTrait.SMALLER_IS_NEARER
        DepthConvention.LARGER_IS_NEARER -> FrameTrait.LARGER_IS_NEARER
    }
    val traits = EnumSet.of(test, convention)
    if (raster.backgroundDepth != Rasters.behindAll(raster.depthTest)) traits.add(FrameTrait.BACKGROUND_DEPTH)
    if (raster.width == 1 || raster.height == 1) traits.add(FrameTrait.NARROW)
    return traits
}

/** Adds the traits that a scene gives to its frames; scenes in screen space have none. */
internal fun addSceneTraits(scene: Scene, traits: MutableSet<FrameTrait>) {
    val camera = scene.viewpoint as? Camera ?: return
    if (scene.isOnScreen) return
    addLightTraits(scene, traits)
    for (surface in scene.surfaces) {
        val material = when (surface) {
            is Mesh -> surface.material.also { traits.add(FrameTrait.MESH) }
            is Sphere -> surface.material.also { traits.add(FrameTrait.SPHERE) }
            is Polygon -> surface.material
            is Points -> unmapped(surface.material, surface.normals != null).also { traits.add(FrameTrait.POINTS) }
            is Lines -> unmapped(surface.material, isLit = false).also { traits.add(FrameTrait.LINES) }
            else -> continue
        }
        if (material.texture != null) traits.add(FrameTrait.TEXTURED)
        if (material.alphaMode == AlphaMode.MASK) traits.add(FrameTrait.MASKED)
        if (reachesAcrossNearPlane(surface, camera)) traits.add(FrameTrait.NEAR_PLANE)
        addMapTraits(material, surface as? Mesh, traits)
        if (material.metallicRoughness == null || material.shading == Shading.CONSTANT) continue
        traits.add(FrameTrait.PHYSICAL)
        if (scene.environment != Environment.NONE) traits.add(FrameTrait.ENVIRONMENT)
    }
}

/** Returns what points and lines use of their [material]. */
private fun unmapped(material: Material, isLit: Boolean): Material =
    material.withoutMaps().let { if (isLit) it else it.withShading(Shading.CONSTANT) }

private fun addLightTraits(scene: Scene, traits: MutableSet<FrameTrait>) {
    if (scene.lights.isNotEmpty()) traits.add(FrameTrait.LIT)
    if (scene.lights.any { it is Light.Spot }) traits.add(FrameTrait.SPOT)
    val falloffs = scene.lights.map { (it as? Light.Point)?.falloff ?: (it as? Light.Spot)?.falloff ?: Falloff.NONE }
    if (falloffs.any { it != Falloff.NONE }) traits.add(FrameTrait.FALLOFF)
    if (scene.lightIntensity != 1f) traits.add(FrameTrait.LIGHT_INTENSITY)
    if (scene.ambientVisibility != null) traits.add(FrameTrait.AMBIENT_VISIBILITY)
    if (scene.effectiveToneMapping != ToneMapping.NONE) traits.add(FrameTrait.TONE_MAPPING)
}

/** Adds the traits of the maps of [material], on [mesh] or on a surface that is not a mesh. */
private fun addMapTraits(material: Material, mesh: Mesh?, traits: MutableSet<FrameTrait>) {
    val normalMap = material.normalMap?.takeIf { mesh?.tangents != null }
    val maps = listOfNotNull(
        material.textureMap, material.metallicRoughness?.map, normalMap?.map, material.occlusionMap?.map,
        material.emissionMap,
    )
    if (maps.any { it.texture.mipFilter != MipFilter.NONE }) traits.add(FrameTrait.MIP_FILTER)
    if (mesh?.uvs2 != null && maps.any { it.uvSet == 1 }) traits.add(FrameTrait.SECOND_UVS)
    if (normalMap != null) traits.add(FrameTrait.NORMAL_MAP)
}

private fun reachesAcrossNearPlane(surface: Surface, camera: Camera): Boolean {
    val forward = Vector3d(camera.target).sub(camera.eye).normalize()
    fun distance(x: Double, y: Double, z: Double) = Vector3d(x, y, z).sub(camera.eye).dot(forward)
    val distances = when (surface) {
        is Polygon -> surface.contours.map { contour -> contour.map { distance(it.x, it.y, it.z) } }

        is Mesh -> surface.triangles.toList().chunked(3).map { triangle ->
            triangle.map { 3 * it }.map {
                distance(
                    surface.positions[it].toDouble(),
                    surface.positions[it + 1].toDouble(),
                    surface.positions[it + 2].toDouble(),
                )
            }
        }

        else -> return false
    }
    return distances.any { part -> part.any { it < camera.near } && part.any { it > camera.near } }
}

/** The traits that depend on the samples of [frame]. Of large frames, only some rows are examined. */
internal class SampleTraits(private val frame: Frame) {
    private val test = frame.raster.depthTest
    private val background = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val firstColumn = frame.region.columnStart

    // The two nearest fragments of each sample, including the background, and the number of fragments
    private val nearest = LongArray(frame.width)
    private val second = LongArray(frame.width)
    private val layers = IntArray(frame.width)

    // Columns where spans begin and end: if both occur in one column, two primitives meet there
    private val starts = BooleanArray(frame.width + 1)
    private val ends = BooleanArray(frame.width + 1)

    private val spans = frame.region.spans()
    private val visible = HashSet<Int>()
    private val pairs = HashSet<Pair<Int, Int>>()

    fun addTo(traits: MutableSet<FrameTrait>) {
        val fragments = maxOf(1, frame.region.size * frame.primitives.size)
        val step = (fragments + MOST_FRAGMENTS - 1) / MOST_FRAGMENTS
        for (y in frame.region.rowStart until frame.region.rowEnd step minOf(step, frame.height.toLong()).toInt()) {
            row(y, traits)
        }
        if (visible.isEmpty()) traits.add(FrameTrait.NOTHING_VISIBLE)
        if (visible.size > 1) traits.add(FrameTrait.SEVERAL_VISIBLE)
        if (pairs.any { (a, b) -> (b to a) in pairs }) traits.add(FrameTrait.CROSSING)
    }

    private fun row(y: Int, traits: MutableSet<FrameTrait>) {
        nearest.fill(background)
        second.fill(Long.MAX_VALUE)
        layers.fill(0)
        starts.fill(false)
        ends.fill(false)
        for (index in frame.primitives.indices) compare(index, y, traits)
        for (i in nearest.indices) note(nearest[i], second[i], traits)
        if (layers.any { it > MANY_LAYERS }) traits.add(FrameTrait.DEEP)
        if (starts.indices.any { starts[it] && ends[it] }) traits.add(FrameTrait.MEETING)
    }

    private fun compare(index: Int, y: Int, traits: MutableSet<FrameTrait>) {
        spans.clear()
        val primitive = frame.primitives[index]
        primitive.spans(y, spans)
        if (spans.count > MANY_SPANS) traits.add(FrameTrait.MANY_SPANS)
        for (span in 0 until spans.count) {
            starts[spans.start(span) - firstColumn] = true
            ends[spans.end(span) - firstColumn] = true
            for (x in spans.start(span) until spans.end(span)) {
                val key = test.key(primitive.depth(x, y), index)
                val i = x - firstColumn
                layers[i]++
                if (key < nearest[i]) {
                    second[i] = nearest[i]
                    nearest[i] = key
                } else if (key < second[i]) {
                    second[i] = key
                }
            }
        }
    }

    private fun note(first: Long, next: Long, traits: MutableSet<FrameTrait>) {
        val winner = test.indexOf(first)
        if (winner != DepthTest.BACKGROUND) visible.add(winner)
        if (next == Long.MAX_VALUE) return
        val loser = test.indexOf(next)
        if (loser == DepthTest.BACKGROUND) return
        traits.add(FrameTrait.HIDDEN)
        if (winner == DepthTest.BACKGROUND) return
        if (test.depthOf(first) == test.depthOf(next)) traits.add(FrameTrait.TIE)
        pairs.add(winner to loser)
    }

    private companion object {
        const val MOST_FRAGMENTS = 20_000L
        const val MANY_LAYERS = 8
        const val MANY_SPANS = 6
    }
}
