package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.light.Light
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture
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

/** Textures of walls with windows: four by four windows, in pale colours that the house tints. */
internal object Facade {
    /** Height of a storey, and width of a window including the wall beside it, in metres. */
    const val FLOOR = 3.2

    private const val WINDOWS = 4

    /** Width and height of wall that one texture covers, in metres. */
    const val TILE = FLOOR * WINDOWS

    private const val CELL = 16
    private const val SIDE = CELL * WINDOWS

    private class Style(val wall: Int, val ledge: Int, val glass: List<Int>, val columns: IntRange, val rows: IntRange)

    private val styles = listOf(
        Style(0xE6DCCB, 0xCFC3AF, listOf(0x5B6C7C, 0x66788A, 0x4F5E6C), 4..11, 4..13),
        Style(0xC98E70, 0xDCC7B0, listOf(0x4C5A66, 0x58676F, 0xE2C987), 4..11, 4..11),
        Style(0xB9C4CC, 0x93A2AE, listOf(0x6F8CA3, 0x7E9BB0, 0x617C92), 0..13, 2..13),
        Style(0xD8D4CE, 0xBDB8B1, listOf(0x55606B, 0x616D78, 0xD8C38C), 2..13, 6..11),
    )

    fun texture(kind: Int, random: SplitMix): Texture {
        val style = styles[kind]
        val panes = IntArray(WINDOWS * WINDOWS) { style.glass[random.below(style.glass.size)] }
        val texels = IntArray(SIDE * SIDE) {
            val x = it % SIDE
            val y = it / SIDE
            val isWindow = x % CELL in style.columns && y % CELL in style.rows
            val rgb = when {
                isWindow -> panes[y / CELL * WINDOWS + x / CELL]
                y % CELL >= CELL - 2 -> style.ledge
                else -> style.wall
            }
            rgb or (0xFF shl 24)
        }
        return Texture(
            SIDE, SIDE, texels, Texture.Filter.BILINEAR, Texture.Wrap.REPEAT, Texture.Wrap.REPEAT, "facade-$kind",
        )
    }
}

/**
 * Random numbers that are the same on every machine.
 *
 * Source: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014 (SplitMix64).
 */
internal class SplitMix(private var state: Long) {
    private fun nextLong(): Long {
        state += GAMMA
        var z = state
        z = (z xor (z ushr 30)) * FIRST
        z = (z xor (z ushr 27)) * SECOND
        return z xor (z ushr 31)
    }

    /** Returns a number in [low]..[high], [high] excluded. */
    fun between(low: Double, high: Double): Double = low + (high - low) * ((nextLong() ushr 11) / TWO_TO_53)

    /** Returns a number in 0 until [bound]. */
    fun below(bound: Int): Int = Math.floorMod(nextLong(), bound.toLong()).toInt()

    override fun toString(): String = "SplitMix($state)"

    private companion object {
        val GAMMA = 0x9E3779B97F4A7C15uL.toLong()
        val FIRST = 0xBF58476D1CE4E5B9uL.toLong()
        val SECOND = 0x94D049BB133111EBuL.toLong()
        const val TWO_TO_53 = 9007199254740992.0
    }
}
