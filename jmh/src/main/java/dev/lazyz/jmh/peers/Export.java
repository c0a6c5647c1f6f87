package dev.lazyz.jmh.peers;

import dev.lazyz.jmh.workload.Triangles;
import java.io.IOException;
import java.nio.file.Path;

/** Writes triangles to a file for other renderers: {@code Export NAME FILE}. */
public final class Export {
    private Export() {}

    /** Two arguments: a scene's name, see {@code jmh/README.md}, and the file. */
    public static void main(String[] args) throws IOException {
        if (args.length != 2) {
            throw new IllegalArgumentException("give a scene and a file");
        }
        Triangles triangles = TriangleSource.find(args[0]);
        triangles.write(Path.of(args[1]));
        System.out.println(triangles);
    }
}
