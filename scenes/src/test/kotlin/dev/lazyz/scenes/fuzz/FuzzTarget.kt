package dev.lazyz.scenes.fuzz

import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.fuzz.mutations.ByteMutations
import dev.lazyz.scenes.fuzz.mutations.GlbMutations
import dev.lazyz.scenes.fuzz.mutations.HeaderMutations
import dev.lazyz.scenes.fuzz.mutations.JsonMutations
import dev.lazyz.scenes.fuzz.mutations.Mutations
import dev.lazyz.scenes.fuzz.mutations.StlMutations
import dev.lazyz.scenes.fuzz.mutations.TextMutations
import dev.lazyz.scenes.fuzz.mutations.ZipMutations
import java.nio.file.Files
import java.nio.file.Path

/**
 * A kind of file to fuzz: each of [SceneFormat], also those that this package does not know, and material libraries.
 *
 * @property id the format's, or [MTL]
 * @property extension ending of its files
 */
internal class FuzzTarget private constructor(val id: String, val extension: String) {
    /** Inputs to begin with: small files that have all that the loader reads. */
    val seeds: List<ByteArray> = seeds(Path.of(checkNotNull(javaClass.getResource("seeds/$id")).toURI()))

    /** Ways to change an input, those that know the format beside those that do not. */
    val mutations: List<Mutations> = listOf(ByteMutations) + when (id) {
        "gltf", "scene" -> listOf(TextMutations) + List(4) { JsonMutations }
        "glb" -> List(5) { GlbMutations }
        "ply" -> listOf(TextMutations, TextMutations, HeaderMutations("end_header\n"))
        "stl" -> listOf(TextMutations, StlMutations)
        "3mf" -> List(5) { ZipMutations }
        else -> List(3) { TextMutations }
    }

    /** The files of this kind in [folder] that are small, in the order of their names. */
    fun seeds(folder: Path): List<ByteArray> = Files.walk(folder).use { paths ->
        paths.filter { it.toString().lowercase().endsWith(".$extension") && Files.isRegularFile(it) }
            .filter { Files.size(it) in 1..MOST_BYTES }
            .sorted()
            .map { Files.readAllBytes(it) }
            .toList()
    }

    override fun toString(): String = id

    companion object {
        /** The target that is no format of scenes. */
        const val MTL = "mtl"

        private const val MOST_BYTES = 65_536L

        val all: List<FuzzTarget> by lazy {
            SceneFormat.entries.map { FuzzTarget(it.id, it.extensions.first()) } + FuzzTarget(MTL, MTL)
        }
    }
}
