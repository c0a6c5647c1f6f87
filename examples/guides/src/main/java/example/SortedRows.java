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
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicInteger;

/** A strategy that collects the fragments of each row, and sorts them when it draws the row. */
public record SortedRows(RenderOptions options) implements Renderer {
    public SortedRows() { this(new RenderOptions()); }

    @Override public String getId() { return "sorted-rows"; }

    @Override public String getSummary() { return "sorts the fragments of each row"; }

    @Override public Set<Capability> getCapabilities() { return EnumSet.of(Capability.TRANSPARENCY, Capability.PARALLEL); }

    @Override public Renderer configured(RenderOptions options) { return new SortedRows(options.requireSupportedBy(this)); }

    @Override public Counters render(Frame frame, RowSink sink) throws IOException {
        var region = frame.getRegion();
        var rows = new Row[frame.getHeight()];
        Arrays.setAll(rows, i -> new Row(frame, region.getRowStart() + i));
        var counters = new Counters.Builder();
        try {
            // Once, and in their order: the primitives of a streamed frame are read while this loop runs
            for (Primitive primitive : frame.getPrimitives()) {
                int index = (int) counters.primitives++;
                if (primitive.getColumnEnd() <= region.getColumnStart()) continue;
                if (primitive.getColumnStart() >= region.getColumnEnd()) continue;
                int end = Math.min(primitive.getRowEnd(), region.getRowEnd());
                for (int y = Math.max(primitive.getRowStart(), region.getRowStart()); y < end; y++) {
                    rows[y - region.getRowStart()].collect(primitive, index);
                }
            }
            long bytes = 0;
            for (Row row : rows) bytes += row.bytes();
            help(rows);
            for (Row row : rows) {
                row.draw();
                row.deliver(sink);
                counters.add(row.counters.build());
            }
            counters.peakBytes = bytes;
            return counters.build();
        } finally {
            for (Row row : rows) row.close();
        }
    }

    /** Lets other threads draw rows. The calling thread draws those that no other has begun. */
    private void help(Row[] rows) {
        var next = new AtomicInteger();
        Executor executor = options.getExecutor() != null ? options.getExecutor() : ForkJoinPool.commonPool();
        try {
            for (int i = 1; i < Math.min(options.getThreads(), rows.length); i++) {
                executor.execute(() -> {
                    for (int row; (row = next.getAndIncrement()) < rows.length; ) rows[row].draw();
                });
            }
        } catch (RejectedExecutionException busy) {
            // The calling thread draws all rows
        }
    }

    /** A fragment, without its colour. The one with the least key is visible. */
    private record Hit(int x, long key, Primitive primitive) {}

    /** A row of the picture. Used by one thread at a time. */
    private static final class Row {
        final Counters.Builder counters = new Counters.Builder();
        private final int y;
        private Frame frame;
        private List<Hit> hits = new ArrayList<>();
        private int[] argb, depths, indices;
        private Throwable failure;

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

        /** A hit has 32 bytes and its place in the list, a sample three numbers, a row some objects. */
        long bytes() { return 38L * hits.size() + 12L * frame.getWidth() + 256; }

        synchronized void draw() {
            if (frame == null || argb != null) return;
            try {
                argb = filled(frame.getRaster().getBackground().toArgb());
                depths = filled(frame.getRaster().getBackgroundDepth());
                indices = filled(DepthTest.BACKGROUND);
                hits.sort(Comparator.comparingInt(Hit::x).thenComparingLong(Hit::key));
                var fragment = new Fragment();
                var blending = new Blending();
                for (int i = 0; i < hits.size(); ) i = drawSample(i, fragment, blending);
            } catch (Throwable e) {
                failure = e;
            }
        }

        private int[] filled(int value) {
            int[] numbers = new int[frame.getWidth()];
            Arrays.fill(numbers, value);
            return numbers;
        }

        /** Draws the sample whose fragments begin at hit {@code i}; returns where those of the next sample begin. */
        private int drawSample(int i, Fragment fragment, Blending blending) {
            var test = frame.getRaster().getDepthTest();
            Hit nearest = hits.get(i);
            int column = nearest.x - frame.getRegion().getColumnStart();
            depths[column] = test.depthOf(nearest.key);
            indices[column] = test.indexOf(nearest.key);
            counters.depthPasses++;

            // From front to back, as far as something shows through
            blending.clear();
            boolean hasBackdrop = false;
            for (; i < hits.size() && hits.get(i).x == nearest.x; i++) {
                if (hasBackdrop || !blending.isOpen()) continue;
                Primitive primitive = hits.get(i).primitive;
                fragment.moveTo(nearest.x, y);
                primitive.shade(fragment);
                counters.shadingCalls++;
                hasBackdrop = !primitive.isTranslucent();
                if (hasBackdrop) blending.end(fragment); else blending.add(fragment);
            }
            if (!hasBackdrop) blending.end(frame.getRaster().getBackground());
            argb[column] = blending.toArgb();
            return i;
        }

        /** Hands the row out, on the calling thread, or throws what a primitive has thrown. */
        void deliver(RowSink sink) throws IOException {
            if (failure != null) throw Row.<RuntimeException>unchanged(failure);
            sink.row(y, argb, depths, indices);
        }

        @SuppressWarnings("unchecked")
        private static <T extends Throwable> T unchanged(Throwable failure) throws T { throw (T) failure; }

        /** Waits for a thread that draws the row, and lets others do nothing: the rendering has ended. */
        synchronized void close() {
            frame = null;
            hits = null;
            argb = null;
        }
    }
}
