package dev.lazyz.jmh.peers;

import dev.lazyz.jmh.workload.Baked;
import dev.lazyz.jmh.workload.Triangles;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.scenes.Scenes;
import dev.lazyz.world.Scene;
import java.nio.file.Path;

/** Finds triangles by name: S1 to S6, a built-in scene, or a file that the library can load. */
public final class TriangleSource {
    private TriangleSource() {}

    /** Returns the triangles called {@code name}; a name with a dot is a file. */
    public static Triangles find(String name) {
        if (Workloads.COMPARED.contains(name)) {
            return Workloads.triangles(name);
        }
        Scene scene = name.contains(".") ? Scenes.load(Path.of(name)).getScene() : Workloads.scene(name);
        return Baked.of(label(name), scene);
    }

    /** Returns the name as tables show it: a file name without its folder. */
    public static String label(String name) {
        return Path.of(name).getFileName().toString();
    }
}
