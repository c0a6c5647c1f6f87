package dev.lazyz.jmh;

import dev.lazyz.Renderer;
import dev.lazyz.jmh.workload.MeshFiles;
import dev.lazyz.jmh.workload.PlainLoops;
import dev.lazyz.scenes.LoadLimits;
import dev.lazyz.scenes.LoadOptions;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.Scenes;
import dev.lazyz.world.Scene;
import dev.lazyz.world.surface.Mesh;
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
 * The time to read a mesh from a file that is in the system's file cache, with and without computing smooth normals,
 * compared with a lower bound: {@link PlainLoops}. All are measured in one run, so that their ratios are comparable
 * between machines. Meshes of GLB files get no normals, so reading and loading are the same there.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@State(Scope.Benchmark)
public class LoadingBenchmark {
    /** Raster size of the images that are compared. */
    private static final int SIDE = 128;

    private static final LoadOptions READING = new LoadOptions(new LoadLimits(), null, false);

    /** A format that {@link MeshFiles} writes. */
    @Param({"obj", "stl", "ply", "glb"})
    public String format;

    /** Number of squares along the mesh's side; the mesh has twice the square of this number of triangles. */
    @Param({"224"})
    public int squares;

    private Path file;
    private PlainLoops loops;

    /** Writes the file, and fails if a reader returns a mesh that renders differently from the written mesh. */
    @Setup
    public void setUp() throws InterruptedException, IOException {
        file = Files.createTempFile("lazyz-", "." + format);
        MeshFiles files = new MeshFiles(squares);
        files.write(file);
        loops = files.plainLoops();
        String expected = hash(files.scene());
        PictureCheck.verify(hash(Scenes.load(file).getScene()), expected, "what was read from " + file);
        Scene plain = Scene.builder().add(loops.read(file)).build();
        PictureCheck.verify(hash(plain), expected, "what a plain loop read from " + file);
    }

    /** Removes the file. */
    @TearDown
    public void tearDown() throws IOException {
        Files.delete(file);
    }

    /** Reads the file, and computes smooth normals. */
    @Benchmark
    public LoadedScene load() throws IOException {
        return Scenes.load(file);
    }

    /** Reads the file into a mesh without normals: parses, checks, and merges equal corners of STL. */
    @Benchmark
    public LoadedScene read() throws IOException {
        return Scenes.load(file, READING);
    }

    /** Reads the file into a mesh without normals; checks nothing, and does not merge corners of STL. */
    @Benchmark
    public Mesh plainLoop() throws IOException {
        return loops.read(file);
    }

    private static String hash(Scene scene) throws InterruptedException, IOException {
        Renderer renderer = PictureCheck.renderer("zbuffer");
        return PictureCheck.hash(MeshFiles.facets(scene).frame(SIDE, SIDE), renderer);
    }
}
