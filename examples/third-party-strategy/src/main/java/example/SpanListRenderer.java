package example;

import dev.lazyz.Capability;
import dev.lazyz.Counters;
import dev.lazyz.DepthTest;
import dev.lazyz.Frame;
import dev.lazyz.Primitive;
import dev.lazyz.Raster;
import dev.lazyz.Region;
import dev.lazyz.Renderer;
import dev.lazyz.RowSink;
import dev.lazyz.spi.Fragment;
import dev.lazyz.spi.Spans;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.Iterator;
import java.util.List;
import java.util.Set;

/**
 * A strategy that is not one of Lazy Z's: each row is a list of spans, sorted by first column, and a sweep over it
 * keeps those that cover the current column.
 *
 * <p>Thread safe: whatever a rendering needs, it makes for itself.
 */
public final class SpanListRenderer implements Renderer {
    @Override
    public String getId() {
        return "span-list";
    }

    @Override
    public String getSummary() {
        return "an example: sorts the spans of each row and sweeps over them";
    }

    /** Promises; the suite holds a renderer to those that it declares, and to no others. */
    @Override
    public Set<Capability> getCapabilities() {
        return EnumSet.of(
                Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS);
    }

    @Override
    public Counters render(Frame frame, RowSink sink) throws IOException {
        if (frame.getHasTranslucency()) {
            int index = 0;
            while (!frame.getPrimitives().get(index).isTranslucent()) {
                index++;
            }
            throw new IllegalArgumentException(
                    "primitive " + index + " is translucent; span-list does not blend: use Frame.asOpaque()");
        }
        Counters.Builder counters = new Counters.Builder();
        counters.primitives = frame.getPrimitives().size();
        Row row = new Row(frame, counters);
        Region region = frame.getRegion();
        for (int y = region.getRowStart(); y < region.getRowEnd(); y++) {
            row.sweep(y, spansOf(frame, y));
            row.shade(y);
            sink.row(y, row.colors, row.depths, row.indices);
        }
        counters.peakBytes += 12L * frame.getWidth();
        return counters.build();
    }

    private record Span(int start, int end, int index) {}

    /** The spans of all primitives on row y, within the region, sorted by first column. */
    private static List<Span> spansOf(Frame frame, int y) {
        List<Span> all = new ArrayList<>();
        Spans spans = frame.getRegion().spans();
        for (int index = 0; index < frame.getPrimitives().size(); index++) {
            Primitive primitive = frame.getPrimitives().get(index);
            if (!reaches(primitive, frame.getRegion(), y)) {
                continue;
            }
            spans.clear();
            primitive.spans(y, spans);
            for (int i = 0; i < spans.getCount(); i++) {
                all.add(new Span(spans.start(i), spans.end(i), index));
            }
        }
        all.sort(Comparator.comparingInt(Span::start));
        return all;
    }

    /** Whether the primitive may cover a sample of row y within the region; if not, it is left alone. */
    private static boolean reaches(Primitive primitive, Region region, int y) {
        return y >= primitive.getRowStart()
                && y < primitive.getRowEnd()
                && primitive.getColumnStart() < region.getColumnEnd()
                && primitive.getColumnEnd() > region.getColumnStart();
    }

    /** One row of the picture. */
    private static final class Row {
        private static final int BYTES_PER_SPAN = 32;

        private final Frame frame;
        private final Counters.Builder counters;
        private final Raster raster;
        private final DepthTest test;
        private final int firstColumn;
        private final Fragment fragment = new Fragment();

        final int[] colors;
        final int[] depths;
        final int[] indices;

        Row(Frame frame, Counters.Builder counters) {
            this.frame = frame;
            this.counters = counters;
            raster = frame.getRaster();
            test = raster.getDepthTest();
            firstColumn = frame.getRegion().getColumnStart();
            colors = new int[frame.getWidth()];
            depths = new int[frame.getWidth()];
            indices = new int[frame.getWidth()];
        }

        /** Finds out which primitive is visible at each column: the one with the least key. */
        void sweep(int y, List<Span> sorted) {
            counters.peakBytes = Math.max(counters.peakBytes, (long) BYTES_PER_SPAN * sorted.size());
            List<Span> active = new ArrayList<>();
            Iterator<Span> coming = sorted.iterator();
            Span next = coming.hasNext() ? coming.next() : null;
            for (int i = 0; i < colors.length; i++) {
                int x = firstColumn + i;
                active.removeIf(span -> span.end() <= x);
                while (next != null && next.start() <= x) {
                    active.add(next);
                    next = coming.hasNext() ? coming.next() : null;
                }
                long least = test.key(raster.getBackgroundDepth(), DepthTest.BACKGROUND);
                for (Span span : active) {
                    long key = test.key(frame.getPrimitives().get(span.index()).depth(x, y), span.index());
                    counters.fragments++;
                    counters.depthEvaluations++;
                    if (key < least) {
                        least = key;
                        counters.depthPasses++;
                    }
                }
                depths[i] = test.depthOf(least);
                indices[i] = test.indexOf(least);
            }
        }

        /** Makes the colours, now that it is known what is visible. */
        void shade(int y) {
            for (int i = 0; i < colors.length; i++) {
                if (indices[i] == DepthTest.BACKGROUND) {
                    colors[i] = raster.getBackground().toArgb();
                    continue;
                }
                counters.shadingCalls++;
                fragment.moveTo(firstColumn + i, y);
                frame.getPrimitives().get(indices[i]).shade(fragment);
                colors[i] = fragment.toArgb();
            }
        }
    }
}
