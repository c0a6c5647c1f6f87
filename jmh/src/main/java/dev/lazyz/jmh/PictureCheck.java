package dev.lazyz.jmh;

import dev.lazyz.Counters;
import dev.lazyz.Frame;
import dev.lazyz.Image.PixelHash;
import dev.lazyz.Renderer;
import dev.lazyz.strategies.Renderers;
import java.io.IOException;
import org.openjdk.jmh.infra.Blackhole;

/** Prevents a benchmark from measuring a wrong image: compares pixel hashes (contract rule 7.2). */
public final class PictureCheck {
    private PictureCheck() {}

    /** Returns the renderer called {@code id}. */
    public static Renderer renderer(String id) {
        Renderer found = Renderers.find(id);
        if (found == null) {
            throw new IllegalArgumentException("no such strategy: " + id);
        }
        return found;
    }

    /** Returns the pixel hash of a rendering. */
    static String hash(Frame frame, Renderer renderer) throws InterruptedException, IOException {
        PixelHash hash = new PixelHash();
        renderer.render(frame, (y, argb, depth, primitive) -> hash.add(argb, frame.getWidth()));
        return hash.digest();
    }

    /**
     * Checks a renderer's image against the plain z-buffer's.
     *
     * @throws IllegalStateException if they differ
     */
    static void verify(Frame frame, Renderer renderer) throws InterruptedException, IOException {
        verify(frame, renderer, "zbuffer");
    }

    /**
     * Checks a renderer's image against that of the strategy {@code other}.
     *
     * @throws IllegalStateException if they differ
     */
    public static void verify(Frame frame, Renderer renderer, String other) throws InterruptedException, IOException {
        verify(hash(frame, renderer), hash(frame, renderer(other)), renderer.getId());
    }

    /**
     * Checks a hash.
     *
     * @throws IllegalStateException if it differs from the expected hash
     */
    static void verify(String actual, String expected, String what) {
        if (!actual.equals(expected)) {
            throw new IllegalStateException(what + " gives " + actual + " instead of " + expected);
        }
    }

    /**
     * Renders into a sink that consumes and discards the rows, so that the JVM cannot optimise their computation
     * away.
     */
    static Counters render(Frame frame, Renderer renderer, Blackhole hole) throws InterruptedException, IOException {
        return renderer.render(frame, (y, argb, depth, primitive) -> {
            hole.consume(argb);
            hole.consume(depth);
            hole.consume(primitive);
        });
    }
}
