package dev.lazyz.jmh.stages;

import dev.lazyz.Counters;
import dev.lazyz.DepthTest;
import dev.lazyz.Frame;
import dev.lazyz.Primitive;
import dev.lazyz.Raster;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.Spans;
import dev.lazyz.jmh.workload.Coloring;
import dev.lazyz.jmh.workload.Triangles;
import dev.lazyz.world.Projection;
import dev.lazyz.world.Scene;
import java.io.IOException;
import java.util.BitSet;
import java.util.HashSet;
import java.util.Iterator;
import java.util.Set;

/**
 * Counts of one frame, from its primitives and the rows of its picture.
 *
 * @param scene name of the scene or mesh file
 * @param side width and height of the raster, samples
 * @param vertices vertices
 * @param perspective 1 if w differs between vertices, else 0
 * @param triangles triangles
 * @param small triangles whose bounds are at most 3 x 3 samples and that cover a sample
 * @param smallFragments covered samples of these triangles
 * @param entries pairs of another triangle and a tile in which it covers a sample; of a triangle that reaches 8 tiles,
 *     only tiles in which it is visible
 * @param compared samples at which the renderer compared depths, by its counters
 * @param drawn samples in tiles in which a sample is covered
 * @param visible samples at which something is visible
 * @param runs runs of samples of one primitive, or of background, in a row of a tile in which a sample is covered
 * @param faces pairs of a triangle that is not small and a tile in which it is visible
 * @param mixed visible samples whose colour is interpolated
 * @param mixedFaces pairs of a triangle and a tile in which it is visible, and its colour is interpolated
 * @param rounds visible samples of the expensive shader of S5
 * @param lit visible samples whose light is computed
 */
record FrameCounts(
        String scene,
        int side,
        long vertices,
        int perspective,
        long triangles,
        long small,
        long smallFragments,
        long entries,
        long compared,
        long drawn,
        long visible,
        long runs,
        long faces,
        long mixed,
        long mixedFaces,
        long rounds,
        long lit) {
    /** Width and height of a tile, samples. */
    static final int TILE = new RenderOptions().getTileSize();

    /** The sizes from which {@code tiled} treats triangles differently: samples of a side, and tiles. */
    private static final int SMALL = 3;

    private static final int WIDE = 8;

    /** Number of samples of the raster. */
    long samples() {
        return (long) side * side;
    }

    /** Number of triangles and tiles in which each must be set up at least once. */
    long setUps() {
        return small + faces;
    }

    /** Pairs of a triangle and a tile in which it is visible, and its normals and positions are interpolated. */
    long litFaces() {
        return lit > 0 ? mixedFaces : 0;
    }

    /** Bytes of a mesh: positions, vertex numbers, and vertices on the grid. */
    long meshBytes() {
        return 12 * vertices + 12 * triangles + (12 + 8L * perspective) * vertices;
    }

    /** Bytes of the bins. */
    long binBytes() {
        return 8 * entries + 12 * smallFragments;
    }

    /** Bytes of a row of tiles: colours, depths and primitive numbers. */
    long rowBytes() {
        return 12L * Math.min(TILE, side) * side;
    }

    /** Counts the frame of {@code triangles} on a square raster. */
    static FrameCounts of(String scene, Triangles triangles, int side, Renderer renderer)
            throws InterruptedException, IOException {
        return new Counting(triangles, side).count(scene, renderer);
    }

    /** The state while a frame is counted. */
    private static final class Counting {
        private final Triangles triangles;
        private final int side;
        private final int columns;
        private final BitSet isSmall = new BitSet();
        private final BitSet isWide = new BitSet();
        private final BitSet isDrawn = new BitSet();

        /** Pairs of a tile and a primitive that is visible in it. */
        private final Set<Long> pairs = new HashSet<>();

        private long small;
        private long smallFragments;
        private long entries;
        private long visible;
        private long runs;
        private long mixed;

        Counting(Triangles triangles, int side) {
            this.triangles = triangles;
            this.side = side;
            columns = (side - 1) / TILE + 1;
        }

        FrameCounts count(String label, Renderer renderer) throws InterruptedException, IOException {
            Scene scene = triangles.scene();
            Raster raster = new Raster(side, side, scene.getBackground());
            Iterator<Primitive> primitives = scene.primitives(raster).iterator();
            for (int index = 0; primitives.hasNext(); index++) {
                add(index, primitives.next());
            }
            Frame frame = scene.frame(raster);
            Counters counters = renderer.render(frame, (y, argb, depth, primitive) -> addRow(y, primitive));
            long faces = 0;
            long mixedFaces = 0;
            for (long pair : pairs) {
                int index = (int) pair;
                faces += isSmall.get(index) ? 0 : 1;
                entries += isWide.get(index) ? 1 : 0;
                mixedFaces += isMixed(index) ? 1 : 0;
            }
            boolean isPerspective = scene.camera(side, side).getProjection() instanceof Projection.Perspective;
            return new FrameCounts(
                    label,
                    side,
                    triangles.vertexCount(),
                    isPerspective ? 1 : 0,
                    triangles.triangleCount(),
                    small,
                    smallFragments,
                    entries,
                    counters.getDepthEvaluations(),
                    drawnSamples(),
                    visible,
                    runs,
                    faces,
                    mixed,
                    mixedFaces,
                    triangles.coloring() == Coloring.ROUNDS ? visible : 0,
                    triangles.coloring() == Coloring.LIT ? visible : 0);
        }

        /** Counts the fragments of a primitive, and the tiles in which it has some. */
        private void add(int index, Primitive primitive) {
            int left = Math.max(primitive.getColumnStart(), 0);
            int right = Math.min(primitive.getColumnEnd(), side);
            int top = Math.max(primitive.getRowStart(), 0);
            int bottom = Math.min(primitive.getRowEnd(), side);
            if (left >= right || top >= bottom) {
                return;
            }
            int wide = (right - 1) / TILE - left / TILE + 1;
            isWide.set(index, wide * ((bottom - 1) / TILE - top / TILE + 1) >= WIDE);
            BitSet tiles = new BitSet();
            long fragments = 0;
            Spans spans = new Spans(0, side);
            for (int y = top; y < bottom; y++) {
                spans.clear();
                primitive.spans(y, spans);
                for (int i = 0; i < spans.getCount(); i++) {
                    fragments += spans.end(i) - spans.start(i);
                    int row = y / TILE * columns;
                    tiles.set(row + spans.start(i) / TILE, row + (spans.end(i) - 1) / TILE + 1);
                }
            }
            isDrawn.or(tiles);
            if (right - left <= SMALL && bottom - top <= SMALL && fragments > 0) {
                isSmall.set(index);
                small++;
                smallFragments += fragments;
            } else if (!isWide.get(index)) {
                entries += tiles.cardinality();
            }
        }

        private void addRow(int y, int[] primitive) {
            for (int x = 0; x < side; x++) {
                int tile = y / TILE * columns + x / TILE;
                if (!isDrawn.get(tile)) {
                    continue;
                }
                int index = primitive[x];
                boolean isStart = x % TILE == 0 || primitive[x - 1] != index;
                runs += isStart ? 1 : 0;
                if (index == DepthTest.BACKGROUND) {
                    continue;
                }
                visible++;
                mixed += isMixed(index) ? 1 : 0;
                if (isStart) {
                    pairs.add((long) tile << Integer.SIZE | index);
                }
            }
        }

        private boolean isMixed(int index) {
            if (triangles.coloring() == Coloring.ROUNDS || triangles.coloring() == Coloring.LIT) {
                return true;
            }
            byte[] rgb = triangles.rgb();
            int[] corners = triangles.indices();
            for (int i = 0; i < 3; i++) {
                byte first = rgb[3 * corners[3 * index] + i];
                if (first != rgb[3 * corners[3 * index + 1] + i] || first != rgb[3 * corners[3 * index + 2] + i]) {
                    return true;
                }
            }
            return false;
        }

        private long drawnSamples() {
            long samples = 0;
            for (int tile = isDrawn.nextSetBit(0); tile >= 0; tile = isDrawn.nextSetBit(tile + 1)) {
                long width = Math.min(TILE, side - tile % columns * TILE);
                samples += width * Math.min(TILE, side - tile / columns * TILE);
            }
            return samples;
        }
    }
}
