package dev.lazyz.jmh;

import dev.lazyz.Renderer;
import dev.lazyz.jmh.workload.MeshFiles;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.Scenes;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * What it costs to read a mesh from a file that the system has in its cache, beside the least that it could: a plain loop
 * over the file's bytes. The two are measured in one run, so that their ratio means something on any machine.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@State(Scope.Benchmark)
public class LoadingBenchmark {
    /** Raster of the pictures that are compared. */
    private static final int SIDE = 128;

    /** A format that {@link MeshFiles} writes. */
    @Param({"obj", "stl", "ply", "glb"})
    public String format;

    /** Squares along the mesh's side; it has twice their square of triangles. */
    @Param({"224"})
    public int squares;

    private Path file;

    /** Writes the file, and refuses to measure a reader whose mesh does not look like what was written. */
    @Setup
    public void setUp() throws IOException {
        file = Files.createTempFile("lazyz-", "." + format);
        MeshFiles files = new MeshFiles(squares);
        files.write(file);
        PictureCheck.verify(hash(Scenes.load(file).getScene()), hash(files.scene()), "what was read from " + file);
    }

    /** Removes the file. */
    @TearDown
    public void tearDown() throws IOException {
        Files.delete(file);
    }

    /** Reads the file. */
    @Benchmark
    public LoadedScene load() {
        return Scenes.load(file);
    }

    /** Reads the file's bytes and adds them up. */
    @Benchmark
    public int plainLoop() throws IOException {
        int sum = 0;
        for (byte value : Files.readAllBytes(file)) {
            sum = 31 * sum + value;
        }
        return sum;
    }

    private static String hash(Scene scene) {
        Renderer renderer = PictureCheck.renderer("zbuffer");
        return PictureCheck.hash(MeshFiles.facets(scene).frame(SIDE, SIDE), renderer);
    }
}
