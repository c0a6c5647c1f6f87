package dev.lazyz;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import dev.lazyz.spi.BatchShader;
import dev.lazyz.spi.FragmentBatch;
import org.junit.jupiter.api.Test;

/** A {@link BatchShader} can be tested without a renderer. */
class JavaBatchShaderTest {
    private final BatchShader stripes = batch -> {
        for (int i = 0; i < batch.getSize(); i++) {
            batch.red[i] = batch.u[i] * batch.vertexRed[i];
            batch.green[i] = batch.v[i];
            batch.blue[i] = 0.5f;
        }
    };

    @Test
    void aShaderIsTriedOnABatchOfOnesOwn() {
        FragmentBatch batch = FragmentBatch.of(3);
        for (int i = 0; i < batch.getSize(); i++) {
            batch.u[i] = i / 2f;
            batch.v[i] = 1 - i / 2f;
        }
        stripes.shade(batch);
        assertEquals(1f, batch.red[2]);
        assertEquals(0f, batch.green[2]);
        assertEquals(0.5f, batch.blue[2]);
        assertEquals(1f, batch.alpha[2]);
    }

    @Test
    void aBatchHasAtLeastOneFragmentAndNoMoreThanItsCapacity() {
        for (int size : new int[] {Integer.MIN_VALUE, -1, 0, FragmentBatch.CAPACITY + 1}) {
            IllegalArgumentException error = assertThrows(IllegalArgumentException.class, () -> FragmentBatch.of(size));
            assertEquals("size must be in 1..256: " + size, error.getMessage());
        }
    }
}
