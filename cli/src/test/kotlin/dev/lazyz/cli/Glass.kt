package dev.lazyz.cli

import java.nio.file.Path
import kotlin.io.path.writeText

/** A scene file of 40 x 30 pixels: a red glass ball in front of a blue one. */
internal fun Path.glass(): Path = resolve("glass.json").apply {
    writeText(
        """
        {
          "lazyz": 1,
          "size": [40, 30],
          "camera": {"fit": {"azimuth": 0, "elevation": 0}},
          "materials": {
            "red": {"baseColor": [0.8, 0.1, 0.1, 0.5], "alphaMode": "blend", "shading": "constant"},
            "blue": {"baseColor": "#2244cc", "shading": "constant"}
          },
          "surfaces": [
            {"sphere": {"center": [0, 0, 0], "radius": 1}, "material": "red"},
            {"sphere": {"center": [0.4, 0, -1.5], "radius": 1}, "material": "blue"}
          ]
        }
        """.trimIndent(),
    )
}
