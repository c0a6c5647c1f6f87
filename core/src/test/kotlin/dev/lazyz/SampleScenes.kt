package dev.lazyz

import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.Random
import org.joml.Vector3d

/** Small scenes for tests that use all features. */
object SampleScenes {
    val camera: Camera = Camera.perspective(
        Vector3d(0.3, 0.4, 5.0), Vector3d(0.0, 0.0, 0.0), Vector3d(0.0, 1.0, 0.0), 40.0, 1.0, 20.0,
    )

    val checks: Texture = Texture(2, 2, intArrayOf(-0x1, 0x40ff0000, 0x4000ff00, -0xffff01), Texture.Filter.NEAREST)

    /** A mesh of random triangles with all attributes; some extend behind the camera or beyond the far plane. */
    fun soup(random: Random, triangles: Int, material: Material, reach: Double = 3.0): Mesh {
        val count = 3 * triangles
        return Mesh(
            FloatArray(3 * count) { ((random.nextDouble() * 2 - 1) * reach).toFloat() },
            IntArray(count) { it },
            material,
            FloatArray(3 * count) { random.nextFloat() * 2 - 1 },
            FloatArray(2 * count) { random.nextFloat() * 3 - 1 },
            FloatArray(4 * count) { random.nextFloat() },
        )
    }

    /** A mesh of [side] x [side] vertices; [place] returns x, y or z (0, 1 or 2) of that in a column of a row. */
    fun sheet(side: Int, material: Material = Material(), place: (column: Int, row: Int, axis: Int) -> Number): Mesh {
        val positions = FloatArray(3 * side * side) { place(it / 3 % side, it / 3 / side, it % 3).toFloat() }
        val triangles = IntArray(6 * (side - 1) * (side - 1)) {
            val cell = it / 6
            cell / (side - 1) * side + cell % (side - 1) + intArrayOf(0, 1, side + 1, 0, side + 1, side)[it % 6]
        }
        return Mesh(positions, triangles, material)
    }

    /** All kinds of surfaces and shading, with textures, masks and blending. */
    fun mixed(random: Random): Scene {
        val surfaces = ArrayList<Surface>()
        for (shading in Shading.entries) {
            val material = Material(
                Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat(), 0.5f + random.nextFloat() / 2),
                texture = if (random.nextBoolean()) checks.withMipFilter(filterFor(shading)) else null,
                shading = shading,
                specular = Rgba(0.5f, 0.4f, 0.3f),
                shininess = 1 + random.nextInt(40),
                emission = Rgba(0f, 0.05f, 0f),
                alphaMode = AlphaMode.entries[random.nextInt(2)],
                sides = Sides.entries[random.nextInt(2)],
            )
            surfaces.add(soup(random, 3, material, 2.0))
            surfaces.add(soup(random, 1, material, 9.0))
            surfaces.add(Sphere(Vector3d(random.nextDouble() * 2 - 1, random.nextDouble() * 2 - 1, 0.0), 0.7, material))
            surfaces.add(star(material))
        }
        val lights = listOf(
            Light.Ambient(Rgba(0.1f, 0.1f, 0.2f)),
            Light.Directional(Vector3d(-1.0, -2.0, -3.0), Rgba(0.7f, 0.6f, 0.5f)),
            Light.Point(Vector3d(2.0, 2.0, 2.0), Rgba(0.2f, 0.3f, 0.4f)),
        )
        return Scene(surfaces, lights, camera)
    }

    private fun filterFor(shading: Shading): MipFilter = MipFilter.entries[shading.ordinal % MipFilter.entries.size]

    private fun star(material: Material): Polygon {
        val points = List(5) {
            val angle = it * 4 * StrictMath.PI / 5
            Vertex(
                1.5 * StrictMath.sin(angle), 1.5 * StrictMath.cos(angle), -0.5 + 0.2 * StrictMath.sin(angle),
                (it % 2).toFloat(), (it / 2).toFloat(), Rgba(1f, it / 5f, 0.5f, 0.8f),
            )
        }
        return Polygon(listOf(points), material, FillRule.NON_ZERO)
    }

    /** [count] triangles in screen space, with depths from a few planes so that there are ties. */
    fun drawn(random: Random, raster: Raster, count: Int): Frame {
        val builder = FrameBuilder(raster)
        repeat(count) {
            val tie = random.nextInt(4) * 0.25
            val contour = DoubleArray(9) { i ->
                if (i % 3 == 2) (if (random.nextInt(3) > 0) tie else random.nextDouble()) else random.nextInt(40) - 10.0
            }
            builder.polygon(Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat()), contour)
        }
        return builder.build()
    }
}
