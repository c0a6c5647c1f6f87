package dev.lazyz.scenes.loading

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Mesh
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertThrows

/** What the loaders' tests share: sources out of text, bytes and files. */
internal object TestSources {
    fun of(text: String, folder: Path? = null) = Source(text.toByteArray(), "test", folder)

    fun of(bytes: ByteArray, folder: Path? = null) = Source(bytes, "test", folder)

    fun error(parser: SceneParser, source: Source): SceneFormatException =
        assertThrows(SceneFormatException::class.java) { parser.parse(source) }
}

internal val Scene.meshes: List<Mesh> get() = surfaces.map { it as Mesh }

/** The corners of each triangle, `x y z` each, so that meshes with other vertex numbers compare. */
internal fun Mesh.corners(): List<List<Float>> = triangles.map { positions.slice(3 * it until 3 * it + 3) }
