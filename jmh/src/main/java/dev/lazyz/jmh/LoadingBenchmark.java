package dev.lazyz.jmh;

import dev.lazyz.Renderer;
import dev.lazyz.Rgba;
import dev.lazyz.jmh.workload.MeshFiles;
import dev.lazyz.jmh.workload.PlainLoops;
import dev.lazyz.scenes.LoadLimits;
import dev.lazyz.scenes.LoadOptions;
import dev.lazyz.scenes.LoadedScene;
import dev.lazyz.scenes.formats.Scenes;
import dev.lazyz.world.Scene;
import dev.lazyz.world.camera.Camera;
import dev.lazyz.world.camera.FittedViewpoint.Fit;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.material.Material.Shading;
import dev.lazyz.world.surface.Mesh;
import dev.lazyz.world.surface.Surface;
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
        MeshFiles files = new MeshFiles(squares, LoadingBenchmark::heights);
        files.write(file, format);
        loops = new PlainLoops(3 * files.vertexCount(), 3 * files.triangleCount());
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
        return PictureCheck.hash(facets(scene).frame(SIDE, SIDE), renderer);
    }

    /** Returns a scene with only the shapes of the meshes, flat-shaded, seen from the front. */
    private static Scene facets(Scene scene) {
        Scene.Builder facets = Scene.builder()
                .viewpoint(Camera.fit(0.0, 0.0, 1.0, Fit.ORTHOGRAPHIC))
                .background(Rgba.BLACK);
        Material material = new Material(Rgba.WHITE).withShading(Shading.FLAT);
        for (Surface surface : scene.getSurfaces()) {
            if (surface instanceof Mesh mesh) {
                facets.add(new Mesh(mesh.getPositions(), mesh.getTriangles(), material));
            }
        }
        return facets.build();
    }

    private static float[] heights(int squares, int row) {
        float[] heights = new float[squares + 1];
        double y = 2.0 * row / squares - 1;
        for (int column = 0; column <= squares; column++) {
            double x = 2.0 * column / squares - 1;
            heights[column] = (float) (0.2 * StrictMath.sin(5 * x + 1) * StrictMath.sin(7 * y));
        }
        return heights;
    }
}
