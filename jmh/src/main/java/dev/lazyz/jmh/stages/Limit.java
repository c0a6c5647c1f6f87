package dev.lazyz.jmh.stages;

/**
 * The time that a stage takes at least on a machine, milliseconds: what its data needs, and what its arithmetic needs.
 * At best both happen at the same time, and divisions beside other operations.
 *
 * @param bytes for moving bytes
 * @param operations for operations
 * @param divisions for divisions
 */
record Limit(double bytes, double operations, double divisions) {
    private static final double MILLISECONDS = 1e3;

    /** Returns the limit of a stage, by {@link Work#ALL}; 0 for a stage without counted work. */
    static Limit of(Stage stage, FrameCounts counts, Machine machine) {
        double bytes = 0;
        double operations = 0;
        double divisions = 0;
        for (Work work : Work.ALL) {
            if (work.stage() == stage) {
                double count = work.count().applyAsLong(counts);
                bytes += count * work.bytes() / machine.bandwidth(work.data().size(counts));
                operations += count * work.operations() / machine.operations();
                divisions += count * work.divisions() / machine.divisions();
            }
        }
        return new Limit(MILLISECONDS * bytes, MILLISECONDS * operations, MILLISECONDS * divisions);
    }

    /** The time, milliseconds. */
    double time() {
        return Math.max(bytes, Math.max(operations, divisions));
    }

    /** What decides: {@code bytes}, {@code operations}, {@code divisions}, or nothing. */
    String bound() {
        if (time() == 0) {
            return "";
        }
        return time() == bytes ? "bytes" : time() == operations ? "operations" : "divisions";
    }
}
