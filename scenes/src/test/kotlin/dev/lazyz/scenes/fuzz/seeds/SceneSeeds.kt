package dev.lazyz.scenes.fuzz.seeds

import dev.lazyz.scenes.fuzz.Companions
import dev.lazyz.scenes.scenefile.RandomScenes
import dev.lazyz.scenes.scenefile.SceneFile
import java.util.Base64

/** Scene files: one of each kind of camera, and some of random scenes. */
internal object SceneSeeds {
    private val image = "data:image/png;base64," + Base64.getEncoder().encodeToString(Companions.png)

    private const val MESH = """{"mesh":{"positions":[0,0,0,1,0,0,1,1,0,0,1,0],"triangles":[0,1,2,0,2,3],
        "origin":[1e6,0,0],"normals":[0,0,1,0,0,1,0,0,1,0,0,1],"uvs":[0,1,1,1,1,0,0,0],
        "colors":[1,0,0,1,0,1,0,1,0,0,1,1,1,1,1,0.5]},"material":"a","smoothNormals":30,"transform":[{"scale":0.001},
        {"rotate":{"axis":[0,0,1],"degrees":90}},{"translate":[0,0,0.25]},{"scale":[1,2,3]},
        {"matrix":[[1,0.5,0,0],[0,1,0,0],[0,0,1,-1],[0,0,0,1]]}]}"""

    private const val POLYGON = """{"polygon":{"fillRule":"non-zero","contours":[[[-2,-2,0],[2,-2,0],[2,2,0],[-2,2,0]],
        [{"position":[-1,-1,0],"uv":[0,1],"color":"#ff0000"},[1,-1,0],[0,1,"NaN"]]]},"material":{"tint":7}}"""

    private val materials = """{"a":{"baseColor":"#cc4b37","texture":{"image":"$image","filter":"nearest",
        "wrap":["clamp","mirror"],"name":"t"},"shading":"blinn-phong","specular":[0.5,0.5,0.5],"shininess":60,
        "emission":"black","alphaMode":"mask","alphaCutoff":0.25,"sides":"front","name":"x"},"b":{"texture":"t.png"}}"""

    private const val LIGHTS = """[{"ambient":{"color":[0.1,0.1,0.12]}},{"directional":{"direction":[0.5,-1,-0.6],
        "color":"#fff4e0"}},{"point":{"position":[-2,3,2]}}]"""

    private val cameras = listOf(
        """"perspective":{"eye":[3,2,6],"target":[0,0.5,0],"up":[0,1,0],"fieldOfView":35,"near":1,"far":50}""",
        """"orthographic":{"eye":[3,2,6],"target":[0,0.5,0],"height":5,"near":1,"far":50}""",
        """"fit":{"azimuth":30,"elevation":20,"zoom":2,"projection":"orthographic"}""",
        """"screen":{"near":-1,"far":100}""",
    )

    private fun scene(camera: String) = """{"lazyz":1,"size":[32,24],"up":"y","background":"#e9edf0","camera":{$camera},
        "depth":{"convention":"larger-is-nearer","test":"greater","background":0},"lights":$LIGHTS,"materials":$materials,
        "surfaces":[$MESH,$POLYGON,{"sphere":{"center":[0,1,0],"radius":1},"material":"b"},{"mesh":"a.obj"},
        {"builtin":{"name":"teapot","segments":1}},{"builtin":{"name":"city","blocks":1,"seed":2}},
        {"builtin":{"name":"layers","count":2}}]}"""

    private fun random(seed: Long): ByteArray = SceneFile.format(RandomScenes(seed).scene()).toByteArray()

    val all: List<ByteArray> = cameras.map { scene(it).toByteArray() } + List(4) { random(it.toLong()) }
}
