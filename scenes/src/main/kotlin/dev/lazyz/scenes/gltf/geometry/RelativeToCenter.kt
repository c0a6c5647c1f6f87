package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.scenes.gltf.document.GltfDocument
import org.joml.Matrix4d

/** The extension `CESIUM_RTC`, which moves the whole model by a vector. */
internal object RelativeToCenter {
    const val NAME: String = "CESIUM_RTC"

    /** Returns the transform from the model's space to world space: a translation, the identity without [NAME]. */
    fun toWorld(document: GltfDocument): Matrix4d {
        val extension = document.json.extension(NAME) ?: return Matrix4d()
        val center = (extension["center"] as? List<*>).orEmpty().mapNotNull { (it as? Number)?.toDouble() }
        if (center.size != 3 || !center.all { it.isFinite() }) {
            document.fail("extensions.$NAME.center", "it must be three numbers")
        }
        return Matrix4d().translation(center[0], center[1], center[2])
    }
}
