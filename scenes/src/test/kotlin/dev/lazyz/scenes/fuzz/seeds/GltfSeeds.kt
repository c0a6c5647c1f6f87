package dev.lazyz.scenes.fuzz.seeds

import dev.lazyz.scenes.fuzz.Companions
import dev.lazyz.scenes.gltf.GltfFiles
import dev.lazyz.scenes.gltf.GltfFiles.Companion.BYTE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.ONE_NODE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.UBYTE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.UINT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.USHORT

/** Meshes in glTF, as text and binary. */
internal object GltfSeeds {
    private val square = listOf(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0)

    private class Model(val files: GltfFiles, val rest: String)

    private val plain = GltfFiles().let {
        it.accessor("VEC3", FLOAT, square.take(9), ""","min":[0,0,0],"max":[1,1,0]""")
        Model(it, """$ONE_NODE,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]""")
    }

    private val materials = """[{"name":"a","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0,0.75],
        "metallicFactor":0,"roughnessFactor":0.5,"baseColorTexture":{"index":0,"texCoord":0,"extensions":{"KHR_texture_transform":
        {"scale":[2,3],"offset":[0.5,0.25],"rotation":1.5,"texCoord":0}}}},"emissiveFactor":[0,0.5,1],"alphaMode":"MASK",
        "alphaCutoff":0.25,"doubleSided":true,"normalTexture":{"index":0},"extensions":{"KHR_materials_unlit":{},
        "KHR_materials_emissive_strength":{"emissiveStrength":5}}},{"alphaMode":"BLEND"}]"""

    private val cameras = """[{"type":"perspective","perspective":{"yfov":0.7,"znear":0.1,"zfar":100,"aspectRatio":1.5}},
        {"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":100}}]"""

    private val nodes = """[{"children":[1,2],"translation":[0,0,-5]},{"mesh":0,"scale":[2,-3,4],"rotation":[0,0,1,0]},
        {"mesh":1,"matrix":[0,5,0,0,7,0,0,0,0,0,1,0,1,2,3,1]},{"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}}]"""

    private val rich = GltfFiles().let {
        val positions = it.accessor("VEC3", FLOAT, square)
        val normals = it.accessor("VEC3", BYTE, List(4) { listOf(0, 0, 127) }.flatten(), ""","normalized":true""")
        val places = it.accessor("VEC2", USHORT, listOf(0, 0, 65535, 0, 0, 65535, 9, 9), ""","normalized":true""")
        val colors = it.accessor("VEC4", UBYTE, List(16) { i -> 16 * i }, ""","normalized":true""")
        val indices = listOf(UBYTE, USHORT, UINT).map { type -> it.accessor("SCALAR", type, listOf(0, 1, 2, 1, 3, 2)) }
        val image = it.view(Companions.png)
        val rows = it.view(it.encode(FLOAT, List(20) { i -> i }), ""","byteStride":20,"target":34962""")
        val woven =
            it.accessor("""{"bufferView":$rows,"byteOffset":8,"componentType":$FLOAT,"count":4,"type":"VEC3"}""")
        val places2 = it.view(it.encode(USHORT, listOf(0, 2)))
        val values = it.view(it.encode(FLOAT, listOf(-1, -2, -3, -4, -5, -6)))
        val sparse = it.accessor(
            """{"bufferView":0,"componentType":$FLOAT,"count":4,"type":"VEC3","sparse":{"count":2,
            "indices":{"bufferView":$places2,"componentType":$USHORT},"values":{"bufferView":$values}}}""",
        )
        val all = """"attributes":{"POSITION":$positions,"NORMAL":$normals,"TEXCOORD_0":$places,"COLOR_0":$colors},
            "material":0,"targets":[{"POSITION":$positions}]"""
        val parts = indices.withIndex().joinToString { (i, index) -> """{$all,"indices":$index,"mode":${4 + i}}""" }
        val others = listOf(woven, sparse).joinToString { """{"attributes":{"POSITION":$it},"mode":5,"material":1}""" }
        Model(
            it,
            """"scene":0,"scenes":[{"nodes":[0,3]}],"nodes":$nodes,"meshes":[{"primitives":[$parts],"weights":[0.5]},
            {"name":"b","primitives":[$others,{"attributes":{"POSITION":0},"mode":1}]}],"cameras":$cameras,
            "materials":$materials,"textures":[{"source":0,"sampler":0},{}],"skins":[{"joints":[0]}],"animations":[],
            "samplers":[{"magFilter":9728,"minFilter":9987,"wrapS":33071,"wrapT":33648}],
            "images":[{"bufferView":$image,"mimeType":"image/png"},{"uri":"t.png"}],
            "extensionsUsed":["KHR_texture_transform","KHR_lights_punctual"],"extensionsRequired":["KHR_mesh_quantization"],
            "extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}}""",
        )
    }

    val texts: List<ByteArray> = listOf(
        plain.files.json(plain.rest),
        plain.files.json(plain.rest, Companions.BUFFER),
        rich.files.json(rich.rest),
    ).map { it.toByteArray() }

    val binaries: List<ByteArray> = listOf(plain, rich).map { it.files.glb(it.rest) }
}
