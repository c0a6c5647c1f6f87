package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d

/**
 * A city of [blocks] by [blocks] blocks with four houses each, in metres. Streets run along x and z.
 *
 * The main street is the line x = 0, and the viewer stands at its near end. Houses are added in the order of their
 * blocks, from the far end to the near one, with one mesh for each kind of wall, so the submission order says little
 * about depth.
 */
internal class CityScene(private val blocks: Int, seed: Long) {
    private val random = SplitMix(seed)
    private val walls = List(FACADES) { MeshBuilder() }
    private val roofs = MeshBuilder()
    private val pavements = MeshBuilder()
    private val lines = MeshBuilder()

    init {
        require(blocks in 1..MAX_BLOCKS) { "blocks must be in 1..$MAX_BLOCKS: $blocks" }
    }

    fun scene(): Scene {
        val left = -(blocks / 2) * PITCH
        for (row in blocks - 1 downTo 0) {
            for (column in 0 until blocks) block(left + column * PITCH, -(row + 1) * PITCH)
        }
        dashes()
        return Scene(
            surfaces = surfaces(),
            lights = listOf(
                Light.Ambient(Rgba(0.30f, 0.34f, 0.42f)),
                Light.Directional(Vector3d(0.75, -0.75, -0.42), Rgba(0.95f, 0.84f, 0.66f)),
            ),
            viewpoint = camera(),
            background = Rgba.ofRgb(0xA9C6E0),
        )
    }

    private fun surfaces(): List<Surface> {
        val textures = List(FACADES) { Facade.texture(it, random) }
        val ground = MeshBuilder().apply {
            color = Rgba.ofRgb(0x55585C)
            val half = blocks * PITCH
            floor(-half, -2 * half, half, half, 0.0)
        }
        val plain = Material(name = "stone")
        val houses: List<Mesh> = walls.mapIndexed { kind, builder ->
            builder.build(Material(texture = textures[kind], name = "facade-$kind"))
        }
        return listOf(ground.build(plain)) + houses + listOf(roofs, pavements, lines).map { it.build(plain) }
    }

    private fun camera(): Camera = Camera.perspective(
        eye = Vector3d(1.4, 5.5, 16.0),
        target = Vector3d(0.4, 11.5, -40.0),
        up = Vector3d(0.0, 1.0, 0.0),
        fieldOfViewDegrees = 55.0,
        near = 1.0,
        far = 60.0 + 2 * blocks * PITCH,
    )

    /** Adds one block. ([x], [z]) is the corner next to the streets. */
    private fun block(x: Double, z: Double) {
        val low = STREET / 2
        val high = PITCH - STREET / 2
        pavements.color = Rgba.ofRgb(0x9C9A94)
        pavements.walls(x + low, z + low, x + high, z + high, 0.0, KERB, PITCH)
        pavements.floor(x + low, z + low, x + high, z + high, KERB)

        // Houses stand back from the kerb, with a gap between them
        val start = low + PAVEMENT
        val side = (PITCH - 2 * start - GAP) / 2
        for (number in 0 until HOUSES_PER_BLOCK) {
            val houseX = x + start + (number % 2) * (side + GAP)
            val houseZ = z + start + (number / 2) * (side + GAP)
            house(houseX, houseZ, side)
        }
    }

    private fun house(x: Double, z: Double, side: Double) {
        val kind = random.below(FACADES)
        val shade = random.between(0.75, 1.0)
        val warmth = random.between(-0.06, 0.10)
        val tint = Rgba((shade + warmth).toFloat(), shade.toFloat(), (shade - warmth).toFloat())
        val depth = side - random.between(0.0, 1.5)
        val width = side - random.between(0.0, 1.5)

        // The square of a random number makes most houses low and some of them towers
        val chance = random.between(0.0, 1.0)
        val floors = 3 + (chance * chance * MAX_FLOORS).toInt()
        val height = floors * Facade.FLOOR
        walls[kind].color = tint
        walls[kind].walls(x, z, x + width, z + depth, KERB, KERB + height, Facade.TILE)
        roofs.color = Rgba.ofRgb(0x6E6A66)
        roofs.floor(x, z, x + width, z + depth, KERB + height)
    }

    /** Adds the white dashes along the middle of the main street, 3 cm above the ground. */
    private fun dashes() {
        lines.color = Rgba.ofRgb(0xE6E4DC)
        var z = 12.0
        while (z > -blocks * PITCH) {
            lines.floor(-0.12, z - 3.0, 0.12, z, 0.03)
            z -= 6.0
        }
    }

    override fun toString(): String = "CityScene($blocks x $blocks blocks)"

    private companion object {
        const val MAX_BLOCKS = 100
        const val HOUSES_PER_BLOCK = 4
        const val FACADES = 4
        const val MAX_FLOORS = 17.0

        /** Distance from the middle of a street to the middle of the next. */
        const val PITCH = 40.0
        const val STREET = 9.0
        const val PAVEMENT = 2.0
        const val GAP = 2.0
        const val KERB = 0.2
    }
}
