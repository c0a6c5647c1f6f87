package dev.lazyz.jmh.peers;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The difference between two images of the same size, given as files of red, green, blue, alpha, one byte each.
 *
 * @param oursOnly samples that only the first image covers
 * @param theirsOnly samples that only the second image covers
 * @param unequal samples covered in both with a component that differs by more than {@value #TOLERANCE} of 255
 * @param mean mean difference of the components of samples covered in both, of 255
 */
record SampleDifference(long oursOnly, long theirsOnly, long unequal, double mean) {
    /** Differences that rounding can cause: some programs approximate the sRGB curve. */
    static final int TOLERANCE = 2;

    /** Compares two files. */
    static SampleDifference of(Path ours, Path theirs) throws IOException {
        return of(Files.readAllBytes(ours), Files.readAllBytes(theirs));
    }

    /**
     * Compares two images.
     *
     * @throws IllegalArgumentException if their sizes differ
     */
    static SampleDifference of(byte[] ours, byte[] theirs) {
        if (ours.length != theirs.length) {
            throw new IllegalArgumentException("pictures of " + ours.length + " and " + theirs.length + " bytes");
        }
        long oursOnly = 0;
        long theirsOnly = 0;
        long unequal = 0;
        long both = 0;
        long sum = 0;
        for (int i = 0; i < ours.length; i += 4) {
            boolean isOurs = ours[i + 3] != 0;
            boolean isTheirs = theirs[i + 3] != 0;
            oursOnly += isOurs && !isTheirs ? 1 : 0;
            theirsOnly += isTheirs && !isOurs ? 1 : 0;
            if (isOurs && isTheirs) {
                int greatest = 0;
                for (int component = i; component < i + 3; component++) {
                    int difference = Math.abs((ours[component] & 0xFF) - (theirs[component] & 0xFF));
                    greatest = Math.max(greatest, difference);
                    sum += difference;
                }
                both++;
                unequal += greatest > TOLERANCE ? 1 : 0;
            }
        }
        return new SampleDifference(oursOnly, theirsOnly, unequal, both == 0 ? 0 : sum / (3.0 * both));
    }
}
