package dev.lazyz;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.lazyz.geometry.Box;
import dev.lazyz.spi.Fragment;
import dev.lazyz.spi.Shader;
import dev.lazyz.spi.Spans;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.world.Camera;
import dev.lazyz.world.Scene;
import dev.lazyz.world.material.Material;
import dev.lazyz.world.surface.SetUp;
import dev.lazyz.world.surface.SetUp.Ray;
import dev.lazyz.world.surface.Sphere;
import dev.lazyz.world.surface.Surface;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import kotlin.sequences.Sequence;
import kotlin.sequences.SequencesKt;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** A surface, a primitive, a shader and a renderer, written in Java with the public API only. */
class JavaOwnKindsTest {
    /** A square in the plane z = 0, found by following the rays of the samples. */
    private record Square(double half, Material material) implements Surface {
        @Override
        public Box getBounds() {
            return new Box(-half, -half, 0, half, half, 0);
        }

        @Override
        public Sequence<Primitive> primitives(SetUp setUp) {
            return SequencesKt.sequenceOf(new RayPrimitive(setUp, half, setUp.shader(material)));
        }
    }

    private record RayPrimitive(SetUp setUp, double half, Shader shader) implements Primitive {
        /** The distance at which the ray of a sample meets the plane z = 0, or NaN if not within the square. */
        private double distance(int x, int y) {
            Ray ray = setUp.ray(x, y);
            double distance = -ray.getOrigin().z() / ray.getDirection().z();
            Vector3d hit = ray.at(distance);
            return Math.abs(hit.x) <= half && Math.abs(hit.y) <= half ? distance : Double.NaN;
        }

        @Override
        public int getRowStart() {
            return 0;
        }

        @Override
        public int getRowEnd() {
            return setUp.getRaster().getHeight();
        }

        @Override
        public int getColumnStart() {
            return 0;
        }

        @Override
        public int getColumnEnd() {
            return setUp.getRaster().getWidth();
        }

        @Override
        public void spans(int y, Spans spans) {
            for (int x = 0; x < getColumnEnd(); x++) {
                int start = x;
                while (x < getColumnEnd() && !Double.isNaN(distance(x, y))) x++;
                if (x > start) spans.add(start, x);
            }
        }

        @Override
        public int depth(int x, int y) {
            return setUp.depth(distance(x, y));
        }

        @Override
        public void shade(Fragment fragment) {
            Vector3d hit = setUp.ray(fragment.getX(), fragment.getY()).at(distance(fragment.getX(), fragment.getY()));
            fragment.worldX = (float) hit.x;
            fragment.worldY = (float) hit.y;
            fragment.normalZ = 1;
            shader.shade(fragment);
        }
    }

    /** Looks at the primitives of each sample from the first to the last. */
    private static class SampleBySample implements Renderer {
        @Override
        public String getId() {
            return "sample-by-sample";
        }

        @Override
        public String getSummary() {
            return "one sample after the other";
        }

        @Override
        public Counters render(Frame frame, RowSink sink) throws IOException {
            Region region = frame.getRegion();
            DepthTest test = frame.getRaster().getDepthTest();
            Fragment fragment = new Fragment();
            for (int y = region.getRowStart(); y < region.getRowEnd(); y++) {
                int[] argb = new int[region.getWidth()];
                int[] depth = new int[region.getWidth()];
                int[] primitive = new int[region.getWidth()];
                Arrays.fill(argb, frame.getRaster().getBackground().toArgb());
                Arrays.fill(depth, frame.getRaster().getBackgroundDepth());
                Arrays.fill(primitive, DepthTest.BACKGROUND);
                List<Primitive> primitives = frame.getPrimitives();
                for (int index = 0; index < primitives.size(); index++) {
                    Primitive one = primitives.get(index);
                    Spans spans = region.spans();
                    one.spans(y, spans);
                    for (int i = 0; i < spans.getCount(); i++) {
                        for (int x = spans.start(i); x < spans.end(i); x++) {
                            int at = x - region.getColumnStart();
                            int d = one.depth(x, y);
                            if (test.key(d, index) >= test.key(depth[at], primitive[at])) continue;
                            fragment.moveTo(x, y);
                            one.shade(fragment);
                            argb[at] = fragment.toArgb();
                            depth[at] = d;
                            primitive[at] = index;
                        }
                    }
                }
                sink.row(y, argb, depth, primitive);
            }
            return new Counters.Builder().build();
        }
    }

    private final Material material =
            new Material().withBaseColor(Rgba.ofRgb(0x3366CC)).withSpecular(Rgba.WHITE);

    private Scene scene(Surface square) {
        return Scene.builder()
                .add(square)
                .add(new Sphere(new Vector3d(0.4, 0.3, 0), 0.5, material))
                .viewpoint(Camera.fit(20.0, 10.0))
                .build();
    }

    @Test
    void allStrategiesShowOnePicture() throws InterruptedException {
        Frame frame = scene(new Square(1, material)).frame(48, 40);
        Image expected = new SampleBySample().render(frame);
        for (Renderer renderer : Renderers.getBuiltIn())
            assertEquals(expected, renderer.render(frame), renderer.getId());
    }

    @Test
    void pointsAreProjectedToWhereVerticesAre() throws InterruptedException {
        Scene scene = scene(new Square(1, material));
        Raster raster = new Raster(64, 64);
        SetUp setUp = new SetUp(raster, scene.camera(64, 64), List.of());
        var middle = setUp.project(new Vector3d(0.2, -0.1, 0));
        Ray ray = setUp.ray((int) middle.getX(), (int) middle.getY());
        Vector3d hit = ray.at(-ray.getOrigin().z() / ray.getDirection().z());
        assertEquals(0.2, hit.x, 0.05);
        assertEquals(-0.1, hit.y, 0.05);
        assertEquals(null, setUp.project(new Vector3d(0, 0, 1000)));
    }
}
