package dev.lazyz.jmh.peers;

import dev.lazyz.jmh.workload.Baked;
import dev.lazyz.jmh.workload.Triangles;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.nio.file.Path;

/**
 * Finds triangles by name: S1 to S6, a built-in scene, or a file that the library can load. After {@value #LIT}, the
 * light of a scene or file is computed when it is rendered; otherwise it is baked into its colours.
 */
public final class TriangleSource {
    /** Begins the names of scenes and files whose light is computed when they are rendered. */
    static final String LIT = "lit:";

    /** Ends the labels of such scenes and files. */
    static final String LIT_LABEL = " lit";

    private TriangleSource() {}

    /** Returns the triangles called {@code name}; a name with a dot is a file. */
    public static Triangles find(String name) throws IOException {
        if (Workloads.COMPARED.contains(name)) {
            return Workloads.triangles(name);
        }
        String plain = plain(name);
        Scene scene = plain.contains(".") ? Scenes.load(Path.of(plain)).getScene() : Workloads.scene(plain);
        return isLit(name) ? Baked.lit(label(name), scene) : Baked.of(label(name), scene);
    }

    /** Returns the name as tables show it: a file name without its folder, and whether it is lit. */
    public static String label(String name) {
        return Path.of(plain(name)).getFileName().toString().replace(',', ' ') + (isLit(name) ? LIT_LABEL : "");
    }

    private static boolean isLit(String name) {
        return name.startsWith(LIT);
    }

    private static String plain(String name) {
        return isLit(name) ? name.substring(LIT.length()) : name;
    }
}
