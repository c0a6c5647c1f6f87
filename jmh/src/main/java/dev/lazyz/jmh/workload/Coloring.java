package dev.lazyz.jmh.workload;

/** How triangles get their colours. */
public enum Coloring {
    /** One colour a triangle: that of its vertices, which are the same. */
    FLAT,

    /** Vertex colours, interpolated. */
    SMOOTH,

    /** Vertex colours, interpolated and put through {@link RoundsShader}. */
    ROUNDS,
}
