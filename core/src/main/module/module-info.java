/** The contract of hidden-surface rendering, twelve renderers that keep it, and the scenes that they draw. */
module dev.lazyz.core {
    requires transitive kotlin.stdlib;
    requires transitive kotlinx.coroutines.core;
    requires transitive org.joml;
    // For kernels that are loaded only where the JVM has it
    requires static jdk.incubator.vector;

    exports dev.lazyz.aov;
    exports dev.lazyz.drawing;
    exports dev.lazyz.filter;
    exports dev.lazyz.geometry;
    exports dev.lazyz.lighting;
    exports dev.lazyz.pipeline;
    exports dev.lazyz.planning;
    exports dev.lazyz.sections;
    exports dev.lazyz.setup;
    exports dev.lazyz.spi;
    exports dev.lazyz.strategies.bsp;
    exports dev.lazyz.strategies.flow;
    exports dev.lazyz.strategies.hierarchical;
    exports dev.lazyz.strategies.hybrid;
    exports dev.lazyz.strategies.lazy;
    exports dev.lazyz.strategies.lists;
    exports dev.lazyz.strategies.painter;
    exports dev.lazyz.strategies.raycast;
    exports dev.lazyz.strategies.scanline;
    exports dev.lazyz.strategies.tiled;
    exports dev.lazyz.strategies.warnock;
    exports dev.lazyz.strategies.zbuffer;
    exports dev.lazyz.strategies;
    exports dev.lazyz.world.camera;
    exports dev.lazyz.world.light;
    exports dev.lazyz.world.material;
    exports dev.lazyz.world.surface;
    exports dev.lazyz.world;
    exports dev.lazyz;

    uses dev.lazyz.Renderer;
}
