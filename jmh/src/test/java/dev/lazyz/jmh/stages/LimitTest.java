package dev.lazyz.jmh.stages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

class LimitTest {
    private static final Machine MACHINE = new Machine("any", 12e9, 6e9, 3e9, 36e9, 1e9);

    @Test
    void theSlowestOfBytesOperationsAndDivisionsDecides() {
        Limit small = Limit.of(Stage.TRANSFORM, vertices(1000, 0), MACHINE);
        assertEquals(1e-3, small.bytes(), 1e-12);
        assertEquals(1e-3, small.operations(), 1e-12);
        assertEquals("bytes", small.bound());
        Limit snap = Limit.of(Stage.SNAP, vertices(1000, 1), MACHINE);
        assertEquals(4e-3, snap.time(), 1e-12);
        assertEquals("divisions", snap.bound());
    }

    @Test
    void moreDataThanACacheHoldsMovesMoreSlowly() {
        assertEquals(
                2e-1, Limit.of(Stage.TRANSFORM, vertices(100_000, 0), MACHINE).bytes(), 1e-9);
        assertEquals(
                4, Limit.of(Stage.TRANSFORM, vertices(1_000_000, 0), MACHINE).bytes(), 1e-9);
    }

    @Test
    void stagesWithoutCountedWorkHaveNoLimit() {
        Set<Stage> counted = Work.ALL.stream().map(Work::stage).collect(Collectors.toSet());
        for (Stage stage : Stage.values()) {
            assertEquals(stage != Stage.HAND_OUT && stage != Stage.OTHER, counted.contains(stage), stage.label());
        }
        Limit none = Limit.of(Stage.OTHER, vertices(1000, 1), MACHINE);
        assertEquals(0, none.time());
        assertEquals("", none.bound());
    }

    @Test
    void theBestFiguresOfAllMachinesCount() {
        Machine other = new Machine("other", 1e9, 7e9, 1e9, 1e9, 2e9);
        assertEquals(new Machine("best of all", 12e9, 7e9, 3e9, 36e9, 2e9), Machine.best(List.of(MACHINE, other)));
        assertTrue(MACHINE.bandwidth(Machine.L2_SIZE) > MACHINE.bandwidth(Machine.L2_SIZE + 1));
    }

    private static FrameCounts vertices(long count, int perspective) {
        return new FrameCounts("scene", 64, count, perspective, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    }
}
