/** Files of models and scenes in, image files out, and the built-in scenes. */
module dev.lazyz.scenes {
    requires transitive dev.lazyz.core;
    requires transitive java.desktop;
    requires java.xml;
    // Without it, the memory of decoders of WebP is not limited
    requires static jdk.management;
    requires com.fasterxml.jackson.core;
    requires com.twelvemonkeys.imageio.webp;
    // These have no descriptors; their names are those of the files
    requires drako;
    requires earcut4j;
    requires obj;

    exports dev.lazyz.scenes.aov;
    exports dev.lazyz.scenes.diff;
    exports dev.lazyz.scenes.formats;
    exports dev.lazyz.scenes.html;
    exports dev.lazyz.scenes.outputs;
    exports dev.lazyz.scenes.pictures;
    exports dev.lazyz.scenes.ply;
    exports dev.lazyz.scenes.scenefile;
    exports dev.lazyz.scenes.text;
    exports dev.lazyz.scenes.writers;
    exports dev.lazyz.scenes.writers.animation;
    exports dev.lazyz.scenes.writers.deepzoom;
    exports dev.lazyz.scenes.writers.imageio;
    exports dev.lazyz.scenes;
}
