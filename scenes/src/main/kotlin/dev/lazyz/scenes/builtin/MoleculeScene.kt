package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d

/**
 * Caffeine, C8H10N4O2. Every atom is a sphere of its van der Waals radius: the space-filling model of Corey, Pauling
 * and Koltun, in their colours.
 *
 * Source: coordinates in angstrom of the conformer of compound 2519 in PubChem; radii by A. Bondi, "van der Waals
 * Volumes and Radii", Journal of Physical Chemistry 68 (1964).
 */
internal object MoleculeScene {
    private enum class Element(val radius: Double, color: Int) {
        HYDROGEN(1.20, 0xF2F2F2),
        CARBON(1.70, 0x4A4A4E),
        NITROGEN(1.55, 0x3558C8),
        OXYGEN(1.52, 0xD4342C),
        ;

        val material = Material(
            Rgba.ofRgb(color),
            shading = Shading.BLINN_PHONG,
            specular = Rgba(0.35f, 0.35f, 0.35f),
            shininess = 48,
            name = name.lowercase(),
        )
    }

    private val atoms = listOf(
        atom(Element.OXYGEN, 0.4700, 2.5688, 0.0006),
        atom(Element.OXYGEN, -3.1271, -0.4436, -0.0003),
        atom(Element.NITROGEN, -0.9686, -1.3125, 0.0000),
        atom(Element.NITROGEN, 2.2182, 0.1412, -0.0003),
        atom(Element.NITROGEN, -1.3477, 1.0797, -0.0001),
        atom(Element.NITROGEN, 1.4119, -1.9372, 0.0002),
        atom(Element.CARBON, 0.8579, 0.2592, -0.0008),
        atom(Element.CARBON, 0.3897, -1.0264, -0.0004),
        atom(Element.CARBON, 0.0307, 1.4220, -0.0006),
        atom(Element.CARBON, -1.9061, -0.2495, -0.0004),
        atom(Element.CARBON, 2.5032, -1.1998, 0.0003),
        atom(Element.CARBON, -1.4276, -2.6960, 0.0008),
        atom(Element.CARBON, 3.1926, 1.2061, 0.0003),
        atom(Element.CARBON, -2.2969, 2.1881, 0.0007),
        atom(Element.HYDROGEN, 3.5163, -1.5787, 0.0008),
        atom(Element.HYDROGEN, -1.0451, -3.1973, -0.8937),
        atom(Element.HYDROGEN, -2.5186, -2.7596, 0.0011),
        atom(Element.HYDROGEN, -1.0447, -3.1963, 0.8957),
        atom(Element.HYDROGEN, 4.1992, 0.7801, 0.0002),
        atom(Element.HYDROGEN, 3.0468, 1.8092, -0.8992),
        atom(Element.HYDROGEN, 3.0466, 1.8083, 0.9004),
        atom(Element.HYDROGEN, -1.8087, 3.1651, -0.0003),
        atom(Element.HYDROGEN, -2.9322, 2.1027, 0.8881),
        atom(Element.HYDROGEN, -2.9346, 2.1021, -0.8849),
    )

    fun scene(): Scene = Scene(
        surfaces = atoms,
        lights = listOf(
            Light.Ambient(Rgba(0.16f, 0.16f, 0.18f)),
            Light.Directional(Vector3d(0.5, -0.7, -1.0), Rgba(0.80f, 0.79f, 0.76f)),
            Light.Directional(Vector3d(-0.9, -0.1, -0.4), Rgba(0.14f, 0.16f, 0.20f)),
        ),
        viewpoint = Camera.fit(azimuth = 22.0, elevation = 24.0),
        background = Rgba.ofRgb(0xDDE6EC),
    )

    private fun atom(element: Element, x: Double, y: Double, z: Double): Sphere =
        Sphere(Vector3d(x, y, z), element.radius, element.material)
}
