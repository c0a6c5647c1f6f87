package dev.lazyz.jmh.workload;

import java.io.IOException;
import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;

/** The warm-up of a process before times are measured. */
public final class SteadyState {
    /** Time for which the compilers must have been idle before times are measured, nanoseconds. */
    private static final long IDLE = 2_000_000_000L;

    /** Maximum length of the warm-up, as a multiple of the requested length. */
    private static final int LONGEST = 8;

    private SteadyState() {}

    /** Work that is done again and again. */
    @FunctionalInterface
    public interface Work {
        /** Does it once; returns any number, for example its time. */
        double run() throws InterruptedException, IOException;
    }

    /**
     * Runs {@code work} for at least {@code seconds}, and longer while Java's compilers are active, but at most
     * {@value #LONGEST} times as long.
     */
    public static void await(double seconds, Work work) throws InterruptedException, IOException {
        CompilationMXBean compilers = ManagementFactory.getCompilationMXBean();
        long least = (long) (1e9 * seconds);
        long start = System.nanoTime();
        long busy = compilers.getTotalCompilationTime();
        long idleSince = start;
        for (long now = start;
                now - start < least || (now - idleSince < IDLE && now - start < LONGEST * least);
                now = System.nanoTime()) {
            work.run();
            if (compilers.getTotalCompilationTime() != busy) {
                busy = compilers.getTotalCompilationTime();
                idleSince = System.nanoTime();
            }
        }
    }
}
