package dev.lazyz.lighting

import dev.lazyz.geometry.FaceNormal
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.Surface
import kotlin.math.sqrt

/**
 * Chooses the light for scenes with dark materials, like the exposure meter of a camera.
 *
 * The mean luminance of the lit meshes is measured: base colour, texture and vertex colours in the middle of each
 * triangle, weighted by area; of large meshes, of every n-th triangle. If it is below that of middle grey, the light is
 * increased, but less than the colours are darker: black stays darker than grey. The camera has no effect, so the
 * pictures of a turntable have the same light.
 */
public object LightMeter {
    /** The reflectance of middle grey. Scenes that are as bright or brighter need no more light. */
    public const val MIDDLE_GREY: Float = 0.18f

    /** The largest result of [intensity]. */
    public const val MAX_INTENSITY: Float = 3f

    /**
     * Returns whether [scene] has light that nobody chose for its materials, and whose [intensity] may be measured: the
     * lights of [rig], except [LightRig.FLAT], or with null the scene's own if it has none.
     */
    @JvmStatic
    public fun appliesTo(scene: Scene, rig: LightRig?): Boolean =
        if (rig == null) scene.lights.isEmpty() else rig != LightRig.FLAT

    /**
     * Returns the factor of all light that makes [scene] legible, 1..[MAX_INTENSITY], for [Scene.withLightIntensity]:
     * the square root of [MIDDLE_GREY] / luminance. 1 if no mesh is lit. Cost: at most 65,536 triangles of each
     * mesh.
     */
    @JvmStatic
    public fun intensity(scene: Scene): Float {
        if (scene.surfaces.all { it is StreamedMesh && isBright(it) }) return 1f
        var light = 0.0
        var area = 0.0
        for (surface in scene.surfaces) {
            val material = surface.material
            if (material == null || material.shading == Shading.CONSTANT || material.shader != null) continue
            measure(surface) { itsArea, luminance ->
                area += itsArea
                light += itsArea * luminance
            }
        }
        if (!(area > 0.0) || light >= MIDDLE_GREY * area) return 1f
        return minOf(StrictMath.sqrt(MIDDLE_GREY * area / light), MAX_INTENSITY.toDouble()).toFloat()
    }

    /** Whether all triangles of [mesh] are middle grey or brighter, which is known without reading them. */
    private fun isBright(mesh: StreamedMesh): Boolean {
        val color = mesh.material.baseColor
        val luminance = luminance(floatArrayOf(color.red, color.green, color.blue))
        return !mesh.hasColors && mesh.material.textureMap == null && luminance >= MIDDLE_GREY
    }

    private fun measure(surface: Surface, use: (area: Double, luminance: Float) -> Unit) {
        if (surface is Mesh) measure(surface, 0, stepOf(surface.triangleCount), use)
        if (surface !is StreamedMesh) return

        // Every step-th triangle of the whole mesh, wherever the parts begin
        val step = stepOf(surface.triangleCount)
        var first = 0L
        for (parts in surface.groups()) {
            val count = parts.sumOf { surface.source.triangleCount(it) }
            val skipped = ((step - first % step) % step).toInt()
            if (skipped < count) measure(surface.read(parts), skipped, step, use)
            first += count
        }
    }

    private fun stepOf(triangles: Int): Int {
        val step = (triangles.toLong() + MOST_TRIANGLES - 1) / MOST_TRIANGLES
        return maxOf(1, step.toInt())
    }

    private inline fun measure(mesh: Mesh, first: Int, step: Int, use: (area: Double, luminance: Float) -> Unit) {
        val color = FloatArray(4)
        val face = FaceNormal(mesh.positions, mesh.triangles)
        for (triangle in first until mesh.triangleCount step step) {
            face.compute(3 * triangle)
            val area = sqrt(face.x * face.x + face.y * face.y + face.z * face.z)
            if (!(area > 0.0 && area < Double.POSITIVE_INFINITY)) continue
            color(mesh, triangle, color)
            val luminance = luminance(color)
            if (luminance >= 0f && luminance < Float.POSITIVE_INFINITY) use(area, luminance)
        }
    }

    /** Stores the colour in the middle of a triangle in [out]. */
    private fun color(mesh: Mesh, triangle: Int, out: FloatArray) {
        val material = mesh.material
        out.fill(1f)
        val map = material.textureMap
        val uvs = if (map == null) {
            null
        } else if (map.uvSet == 0) {
            mesh.uvs
        } else {
            mesh.uvs2
        }
        if (map != null && uvs != null) {
            val u = mean(mesh, triangle, uvs, 2, 0)
            val v = mean(mesh, triangle, uvs, 2, 1)
            map.texture.sample(map.transform.u(u, v), map.transform.v(u, v), out)
        }
        val colors = mesh.colors
        for (k in 0 until 3) {
            out[k] *= material.baseColor.channel(k)
            if (colors != null) out[k] *= mean(mesh, triangle, colors, 4, k)
        }
    }

    private fun mean(mesh: Mesh, triangle: Int, values: FloatArray, stride: Int, place: Int): Float {
        val corners = mesh.triangles
        val at = 3 * triangle
        return (
            values[stride * corners[at] + place] + values[stride * corners[at + 1] + place] +
                values[stride * corners[at + 2] + place]
            ) / 3f
    }

    /** Relative luminance of linear light, ITU-R BT.709. */
    private fun luminance(color: FloatArray): Float = 0.2126f * color[0] + 0.7152f * color[1] + 0.0722f * color[2]

    private const val MOST_TRIANGLES = 65_536
}
