package example;

import dev.lazyz.Blending;
import dev.lazyz.Capability;
import dev.lazyz.Counters;
import dev.lazyz.DepthTest;
import dev.lazyz.Frame;
import dev.lazyz.Primitive;
import dev.lazyz.RenderOptions;
import dev.lazyz.Renderer;
import dev.lazyz.RowSink;
import dev.lazyz.spi.Fragment;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Set;

/** A strategy that collects the fragments of each row, and sorts them when it draws the row. */
public record SortedRows(RenderOptions options) implements Renderer {
    public SortedRows() { this(new RenderOptions()); }

    @Override public String getId() { return "sorted-rows"; }
    @Override public String getSummary() { return "sorts the fragments of each row"; }
    @Override public Set<Capability> getCapabilities() { return Set.of(Capability.TRANSPARENCY, Capability.PARALLEL); }
    @Override public Renderer configured(RenderOptions options) { return new SortedRows(options.requireSupportedBy(this)); }

    @Override public Counters render(Frame frame, RowSink sink) throws InterruptedException, IOException {
        var region = frame.getRegion();
        var rows = new Row[frame.getHeight()];
        Arrays.setAll(rows, i -> new Row(frame, region.getRowStart() + i));
        var counters = new Counters.Builder();
        var caller = Thread.currentThread();
        // Once, and in their order: the primitives of a streamed frame are read while this loop runs
        for (Primitive primitive : frame.getPrimitives()) {
            endIfInterrupted();
            int index = (int) counters.primitives++;
            if (primitive.getColumnEnd() <= region.getColumnStart()) continue;
            if (primitive.getColumnStart() >= region.getColumnEnd()) continue;
            int end = Math.min(primitive.getRowEnd(), region.getRowEnd());
            for (int y = Math.max(primitive.getRowStart(), region.getRowStart()); y < end; y++) {
                rows[y - region.getRowStart()].collect(primitive, index);
            }
        }
        options.inParallel(rows.length, i -> rows[i].draw(caller));
        long bytes = 0;
        for (Row row : rows) {
            endIfInterrupted();
            sink.row(row.y, row.argb, row.depths, row.indices);
            counters.add(row.counters.build());
            bytes += 38L * row.hits.size() + 12L * frame.getWidth() + 256;
        }
        counters.peakBytes = bytes;
        return counters.build();
    }

    private static void endIfInterrupted() throws InterruptedException {
        if (Thread.interrupted()) throw new InterruptedException();
    }

    /** A fragment, without its colour. The one with the least key is visible. */
    private record Hit(int x, long key, Primitive primitive) {}

    /** A row of the picture. Used by one thread at a time. */
    private static final class Row {
        final Frame frame;
        final int y;
        final List<Hit> hits = new ArrayList<>();
        final Counters.Builder counters = new Counters.Builder();
        int[] argb, depths, indices;

        Row(Frame frame, int y) { this.frame = frame; this.y = y; }

        void collect(Primitive primitive, int index) {
            var raster = frame.getRaster();
            long background = raster.getDepthTest().key(raster.getBackgroundDepth(), DepthTest.BACKGROUND);
            var spans = frame.getRegion().spans();
            primitive.spans(y, spans);
            for (int i = 0; i < spans.getCount(); i++) {
                for (int x = spans.start(i); x < spans.end(i); x++) {
                    counters.fragments++;
                    counters.depthEvaluations++;
                    long key = raster.getDepthTest().key(primitive.depth(x, y), index);
                    if (key < background) hits.add(new Hit(x, key, primitive));
                }
            }
        }

        void draw(Thread caller) {
            argb = filled(frame.getRaster().getBackground().toArgb());
            depths = filled(frame.getRaster().getBackgroundDepth());
            indices = filled(DepthTest.BACKGROUND);
            hits.sort(Comparator.comparingInt(Hit::x).thenComparingLong(Hit::key));
            for (int i = 0, end; i < hits.size() && !caller.isInterrupted(); i = end) {
                for (end = i + 1; end < hits.size() && hits.get(end).x == hits.get(i).x; ) end++;
                Hit nearest = hits.get(i);
                int column = nearest.x - frame.getRegion().getColumnStart();
                depths[column] = frame.getRaster().getDepthTest().depthOf(nearest.key);
                indices[column] = frame.getRaster().getDepthTest().indexOf(nearest.key);
                argb[column] = blend(hits.subList(i, end));
                counters.depthPasses++;
            }
        }

        private int[] filled(int value) {
            int[] numbers = new int[frame.getWidth()];
            Arrays.fill(numbers, value);
            return numbers;
        }

        /** Blends the fragments of a sample, as far as something shows through. What is hidden is not shaded. */
        private int blend(List<Hit> fromFront) {
            var fragment = new Fragment();
            var blending = new Blending();
            blending.clear();
            for (Hit hit : fromFront) {
                if (!blending.isOpen()) break;
                fragment.moveTo(hit.x, y);
                hit.primitive.shade(fragment);
                counters.shadingCalls++;
                if (!hit.primitive.isTranslucent()) {
                    blending.end(fragment);
                    return blending.toArgb();
                }
                blending.add(fragment);
            }
            blending.end(frame.getRaster().getBackground());
            return blending.toArgb();
        }
    }
}
