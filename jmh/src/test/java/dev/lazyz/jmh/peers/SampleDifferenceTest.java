package dev.lazyz.jmh.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

class SampleDifferenceTest {
    @Test
    void coverageAndColoursAreComparedSampleBySample() {
        byte[] ours = {10, 10, 10, -1, 0, 0, 0, 0, 7, 7, 7, -1, 50, 50, 50, -1};
        byte[] theirs = {12, 10, 10, -1, 9, 9, 9, -1, 0, 0, 0, 0, 50, 57, 50, -1};
        assertEquals(new SampleDifference(1, 1, 1, 1.5), SampleDifference.of(ours, theirs));
    }

    @Test
    void aPictureDoesNotDifferFromItself() {
        byte[] picture = {1, 2, 3, -1, 0, 0, 0, 0};
        assertEquals(new SampleDifference(0, 0, 0, 0), SampleDifference.of(picture, picture.clone()));
    }

    @Test
    void picturesOfTwoSizesAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> SampleDifference.of(new byte[4], new byte[8]));
    }
}
