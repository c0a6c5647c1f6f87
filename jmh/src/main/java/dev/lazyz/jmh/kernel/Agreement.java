package dev.lazyz.jmh.kernel;

import java.util.Arrays;

/** Refuses to measure what does not agree. */
final class Agreement {
    private Agreement() {}

    /** Throws unless all of {@code results} are equal. */
    static void of(long... results) {
        if (Arrays.stream(results).distinct().count() != 1) {
            throw new IllegalStateException("variants differ: " + Arrays.toString(results));
        }
    }
}
