package dev.lazyz.jmh.workload;

/** The source of the triangles' colours. */
public enum Coloring {
    /** One colour per triangle; its three vertices have the same colour. */
    FLAT,

    /** Vertex colours, interpolated. */
    SMOOTH,

    /** Vertex colours, interpolated and processed by {@link RoundsShader}. */
    ROUNDS,

    /** Vertex colours, interpolated and multiplied by the light of a scene without lights, at each sample. */
    LIT,
}
