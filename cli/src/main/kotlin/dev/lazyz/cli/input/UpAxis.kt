package dev.lazyz.cli.input

import dev.lazyz.cli.output.Mistake
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Lines
import dev.lazyz.world.Mesh
import dev.lazyz.world.Points
import dev.lazyz.world.Polygon
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.Sphere
import dev.lazyz.world.Surface
import dev.lazyz.world.Vertex
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Rotates a scene whose z axis points up, so that y points up: (x, y, z) becomes (x, z, -y).
 *
 * Coordinates are only exchanged and negated, so nothing is rounded. The lights and camera of the scene are rotated,
 * too.
 */
internal object UpAxis {
    fun fromZ(scene: Scene): Scene {
        val viewpoint = scene.viewpoint
        return Scene(
            scene.surfaces.map { turned(it) },
            scene.lights.map { turned(it) },
            if (viewpoint is Camera) turned(viewpoint) else viewpoint,
            scene.background,
        )
    }

    private fun turned(surface: Surface): Surface = when (surface) {
        is Mesh -> Mesh(
            turned(surface.positions),
            surface.triangles,
            surface.material,
            surface.normals?.let { turned(it) },
            surface.uvs,
            surface.colors,
            turned(surface.origin),
        )

        is Polygon -> Polygon(
            surface.contours.map { contour -> contour.map { Vertex(it.x, it.z, -it.y, it.u, it.v, it.color) } },
            surface.material,
            surface.fillRule,
        )

        is Sphere -> Sphere(turned(surface.center), surface.radius, surface.material)

        is Points -> Points(
            turned(surface.positions), surface.size, surface.material, surface.normals?.let { turned(it) },
            surface.colors, turned(surface.origin),
        )

        is Lines -> Lines(
            turned(surface.positions), surface.segments, surface.width, surface.material, surface.colors,
            turned(surface.origin),
        )

        else -> throw Mistake("--up z cannot turn a surface of class ${surface.javaClass.name}")
    }

    private fun turned(xyz: FloatArray): FloatArray = FloatArray(xyz.size) {
        when (it % 3) {
            0 -> xyz[it]
            1 -> xyz[it + 1]
            else -> -xyz[it - 1]
        }
    }

    private fun turned(v: Vector3dc): Vector3d = Vector3d(v.x(), v.z(), -v.y())

    private fun turned(light: Light): Light = when (light) {
        is Light.Ambient -> light
        is Light.Directional -> Light.Directional(turned(light.direction), light.color)
        is Light.Point -> Light.Point(turned(light.position), light.color)
    }

    private fun turned(camera: Camera): Camera {
        val view = camera.viewMatrix()
        val backward = Vector3d(view.m02(), view.m12(), view.m22())
        val upward = turned(Vector3d(view.m01(), view.m11(), view.m21()))
        val eye = turned(camera.eye)
        val target = Vector3d(eye).sub(turned(backward))
        return when (val projection = camera.projection) {
            is Projection.Perspective -> Camera.perspective(
                eye,
                target,
                upward,
                projection.verticalFieldOfView,
                camera.near,
                camera.far,
            )

            is Projection.Orthographic -> Camera.orthographic(
                eye,
                target,
                upward,
                projection.height,
                camera.near,
                camera.far,
            )

            Projection.Screen -> throw Mistake("--up z cannot turn a scene that is given on the screen")
        }
    }
}
