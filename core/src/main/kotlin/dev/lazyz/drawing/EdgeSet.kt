package dev.lazyz.drawing

/** Which edges of meshes are drawn. */
public enum class EdgeSet {
    /** Silhouettes, creases and boundaries, see [FeatureEdges]. */
    FEATURES,

    /** All edges of all triangles. */
    ALL,
}
