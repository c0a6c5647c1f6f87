package dev.lazyz.scenes.gltf.animation

/** The values that an animation gives to a node at one moment. Null means that the value from the file is unchanged. */
internal class NodePose {
    var translation: DoubleArray? = null
    var rotation: DoubleArray? = null
    var scale: DoubleArray? = null
    var weights: DoubleArray? = null

    /** Whether the animation changes the transform of the node. */
    val isMoved: Boolean get() = translation != null || rotation != null || scale != null
}
