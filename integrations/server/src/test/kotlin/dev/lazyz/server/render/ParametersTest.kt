package dev.lazyz.server.render

import dev.lazyz.Rgba
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightRig
import dev.lazyz.scenes.PictureSettings
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.Scenes
import dev.lazyz.server.Client
import dev.lazyz.server.RenderServer
import dev.lazyz.server.ServerConfig
import dev.lazyz.strategies.tiled.Tiled
import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.View
import javax.imageio.ImageIO
import org.junit.jupiter.api.AfterAll
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/**
 * The parameters mean what the settings of the library mean, which are the options of `zcli render`: see
 * `PictureSettingsTest` of `cli`.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class ParametersTest {
    private val usual = PictureSettings(40, 30)
    private val parameters = mapOf(
        "" to usual,
        "aa=1" to usual.withSampling(SuperSampling.NONE),
        "aa=8" to usual.withSampling(SuperSampling(8)),
        "up=-z" to usual.withUp(UpAxis.MINUS_Z),
        "up=z" to usual.withUp(UpAxis.Z),
        "background=transparent" to usual.withBackground(Rgba.TRANSPARENT),
        "background=f80" to usual.withBackground(Rgba.ofRgb(0xFF8800)),
        "view=iso" to usual.withViewpoint(Camera.fit(View.ISO.azimuth, View.ISO.elevation)),
        "view=top&azimuth=5" to usual.withViewpoint(Camera.fit(5.0, 90.0)),
        "azimuth=12.5&elevation=-30" to usual.withViewpoint(Camera.fit(12.5, -30.0)),
        "projection=orthographic" to usual.withViewpoint(Camera.fit(kind = Fit.ORTHOGRAPHIC)),
        "margin=20" to usual.withViewpoint(Camera.fit(margin = 20.0)),
        "zoom=2.5" to usual.withViewpoint(Camera.fit(zoom = 2.5)),
        "light=three-point" to usual.withLight(LightRig.THREE_POINT),
        "light=flat" to usual.withLight(LightRig.FLAT),
        "light=sun&light-intensity=1.5" to usual.withLight(LightRig.SUN).withLightIntensity(1.5f),
        "light-intensity=0.5" to usual.withLightIntensity(0.5f),
    )

    @Test
    fun parametersMeanTheSameAsSettings() {
        for ((format, model) in models) {
            for ((query, settings) in parameters) {
                val answer = client.post("/render?size=40x30&$query", model.toByteArray())
                assertEquals(200, answer.statusCode()) { answer.body().decodeToString() }
                val picture = ImageIO.read(answer.body().inputStream())
                val expected = settings.frame(Scenes.load(model.byteInputStream(), format)).render(Tiled())
                assertEquals(expected.argb.asList(), picture.getRGB(0, 0, 40, 30, null, 0, 40).asList()) {
                    "$format with $query"
                }
            }
        }
    }

    private companion object {
        const val WEDGE = "v 0 0 0\nv 4 0 0\nv 0 2 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"

        /** Of a format in which z points up. */
        const val FACET = "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 1\n" +
            "endloop\nendfacet\nendsolid\n"

        /** Dark enough for more light. */
        const val DARK = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" +
            "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n" +
            "property list uchar int vertex_indices\nend_header\n" +
            "0 0 0 20 9 9\n1 0 0 9 20 9\n0 1 0.5 9 9 20\n3 0 1 2\n"

        val models = listOf(SceneFormat.OBJ to WEDGE, SceneFormat.STL to FACET, SceneFormat.PLY to DARK)
        val server = RenderServer(ServerConfig(port = 0, log = {})).start()
        val client = Client(server)

        @AfterAll
        @JvmStatic
        fun close() = server.close()
    }
}
