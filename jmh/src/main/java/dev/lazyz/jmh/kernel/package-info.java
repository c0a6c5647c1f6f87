/**
 * Inner loops in plain Java, each beside the ways of doing the same that lost: what decided how {@code tiled} is written, and
 * what to run again before it is written otherwise. Nothing here is used by the library.
 *
 * <p>A benchmark refuses to measure variants that do not give the same result.
 */
package dev.lazyz.jmh.kernel;
