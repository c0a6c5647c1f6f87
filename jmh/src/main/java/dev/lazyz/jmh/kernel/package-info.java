/**
 * Inner loops in plain Java, each with slower alternatives. These benchmarks determined how {@code tiled} is written.
 * Run them again before rewriting it. The library does not use this package.
 *
 * <p>A benchmark fails if its variants do not give the same result.
 */
package dev.lazyz.jmh.kernel;
