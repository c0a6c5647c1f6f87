package dev.lazyz.jmh.stages;

import dev.lazyz.RowSink;

/** A sink that drops the rows. It reads a colour of each, so that the JVM cannot leave their computation out. */
final class DroppedRows implements RowSink {
    private volatile int seen;

    @Override
    public void row(int y, int[] argb, int[] depth, int[] primitive) {
        seen = argb[0];
    }

    /** The last colour that was read. */
    int seen() {
        return seen;
    }
}
