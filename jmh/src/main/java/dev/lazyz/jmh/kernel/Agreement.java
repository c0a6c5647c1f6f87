package dev.lazyz.jmh.kernel;

import java.util.Arrays;

/** Prevents measuring variants that do not give the same result. */
final class Agreement {
    private Agreement() {}

    /** Throws unless all of {@code results} are equal. */
    static void of(long... results) {
        if (Arrays.stream(results).distinct().count() != 1) {
            throw new IllegalStateException("variants differ: " + Arrays.toString(results));
        }
    }
}
