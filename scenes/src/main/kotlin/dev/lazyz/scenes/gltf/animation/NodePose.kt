package dev.lazyz.scenes.gltf.animation

/** What an animation makes of a node at a moment; null is what it leaves as the file has it. */
internal class NodePose {
    var translation: DoubleArray? = null
    var rotation: DoubleArray? = null
    var scale: DoubleArray? = null
    var weights: DoubleArray? = null

    /** Whether the node stands elsewhere than in the file. */
    val isMoved: Boolean get() = translation != null || rotation != null || scale != null
}
