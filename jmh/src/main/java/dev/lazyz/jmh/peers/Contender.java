package dev.lazyz.jmh.peers;

import dev.lazyz.jmh.workload.Coloring;
import dev.lazyz.jmh.workload.Triangles;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * A program that is measured.
 *
 * @param name name in tables
 * @param kind the kind of program, which determines what it supports
 * @param command its command line, without options
 */
record Contender(String name, Kind kind, List<String> command) {
    /** Kinds of programs. */
    enum Kind {
        /** {@code llvmpipe.c}. */
        LLVMPIPE,

        /** {@code llvmpipe.c} with shading after visibility is determined. */
        LLVMPIPE_VISIBILITY,

        /** {@code glimpsw.cpp}: no shader for the rounds; only for processors with AVX-512. */
        GLIMPSW,

        /** {@code euc}: one thread; does not clip. */
        EUC,

        /** {@code vtk_peer.py}: no shader for the rounds; its image is not sRGB. */
        VTK,

        /** {@code JmolPeer.java}: one thread, no perspective, no shader, one colour per triangle, not sRGB. */
        JMOL,

        /** {@link PeerRun} on some JVM. */
        OURS,
    }

    /** Returns the contender for {@code NAME=COMMAND}; the words of the command are separated by spaces. */
    static Contender parse(Kind kind, String text) {
        int at = text.indexOf('=');
        if (at < 1) {
            throw new IllegalArgumentException("NAME=COMMAND is expected: " + text);
        }
        List<String> command = Arrays.asList(text.substring(at + 1).trim().split(" +"));
        return new Contender(text.substring(0, at), kind, command);
    }

    /** Whether this program can draw the triangles with this number of threads. */
    boolean canDraw(Triangles triangles, boolean isPerspective, int threads) {
        boolean isExpensive = triangles.coloring() == Coloring.ROUNDS;
        boolean isPlain = !isExpensive && triangles.coloring() != Coloring.LIT;
        return switch (kind) {
            case LLVMPIPE, OURS -> true;
            case GLIMPSW -> !isExpensive;
            case LLVMPIPE_VISIBILITY -> isExpensive && !isPerspective;
            case EUC -> threads == 1 && (isPlain || isExpensive) && !isPerspective;
            case VTK -> isPlain;
            case JMOL -> threads == 1 && isPlain && !isPerspective;
        };
    }

    /** Returns a builder of a process on as many processors as it has threads; its errors are discarded. */
    static ProcessBuilder builder(List<String> command, int threads) {
        String processors =
                IntStream.range(0, threads).mapToObj(Integer::toString).collect(Collectors.joining(","));
        List<String> pinned = new ArrayList<>(List.of("taskset", "-c", processors));
        pinned.addAll(command);
        ProcessBuilder builder = new ProcessBuilder(pinned).redirectError(ProcessBuilder.Redirect.DISCARD);
        builder.environment().put("LP_NUM_THREADS", Integer.toString(threads));
        builder.environment().put("GALLIUM_DRIVER", "llvmpipe");
        builder.environment().put("LIBGL_ALWAYS_SOFTWARE", "1");
        return builder;
    }

    /** Whether this draws all scenes, also those that are measured once: Lazy Z, and the fastest of the others. */
    boolean isOfAllScenes() {
        return hasSamples() || kind == Kind.GLIMPSW;
    }

    /** Whether this can draw several samples a pixel. */
    boolean hasSamples() {
        return kind == Kind.OURS || kind == Kind.LLVMPIPE || kind == Kind.LLVMPIPE_VISIBILITY;
    }

    /** Whether the colours of its images can be compared with Lazy Z's. */
    boolean isSrgb() {
        return kind != Kind.VTK && kind != Kind.JMOL;
    }

    /**
     * Returns the command line that draws a scene with {@code samples} x {@code samples} samples a pixel. Lazy Z gets
     * the scene's name, other programs get the file; of them, only llvmpipe can draw more than one sample.
     */
    List<String> drawing(String scene, String file, int side, int samples, int threads) {
        List<String> words = new ArrayList<>(command);
        if (kind == Kind.OURS) {
            words.addAll(List.of("--scene", scene, "--threads", Integer.toString(threads)));
        } else {
            words.add(file);
        }
        words.addAll(List.of("--side", Integer.toString(side)));
        if (samples > 1) {
            words.addAll(List.of("--samples", Integer.toString(kind == Kind.OURS ? samples : samples * samples)));
        }
        if (kind == Kind.LLVMPIPE_VISIBILITY) {
            words.add("--visibility");
        }
        return words;
    }
}
