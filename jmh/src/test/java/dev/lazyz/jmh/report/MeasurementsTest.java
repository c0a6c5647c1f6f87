package dev.lazyz.jmh.report;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MeasurementsTest {
    private final Measurements measured = new Measurements();

    @Test
    void whatIsWrittenIsReadAgain(@TempDir Path folder) throws IOException {
        measured.note("command", "run --a b: c");
        measured.add("frame ms", "S1", "ours", 1, 1.25);
        measured.add("bytes", "S1", "ours", 1, 1e14);
        Path file = folder.resolve("a.csv");
        measured.write(file);
        List<String> lines = List.of(
                "# command: run --a b: c",
                "quantity,subject,program,round,value",
                "frame ms,S1,ours,1,1.25",
                "bytes,S1,ours,1,100000000000000");
        assertEquals(lines, Files.readAllLines(file));
        Measurements.read(file).write(file);
        assertEquals(lines, Files.readAllLines(file));
        Files.writeString(file, "quantity,subject,program,round,value\nframe ms,S1,ours,1\n");
        assertThrows(IllegalArgumentException.class, () -> Measurements.read(file));
    }

    @Test
    void ratiosAreTakenWithinARound() {
        for (double[] row : new double[][] {{1, 10, 30}, {2, 20, 40}, {3, 12, 48}}) {
            measured.add("ms", "a", "ours", (int) row[0], row[1]);
            measured.add("ms", "a", "theirs", (int) row[0], row[2]);
        }
        measured.add("ms", "a", "ours", 4, 1);
        assertArrayEquals(new double[] {2, 3, 4}, measured.ratios("ms", "a", "ours", "theirs"));
        assertEquals(OptionalDouble.of(11), measured.median("ms", "a", "ours"));
        assertTrue(measured.median("ms", "b", "ours").isEmpty());
        measured.removeIf(value -> value.program().equals("ours"));
        assertEquals(List.of("theirs"), measured.programs("ms"));
    }

    @Test
    void factsOfSeveralRunsAreKept() {
        List.of("a", "b", "a").forEach(value -> measured.note("command", value));
        assertEquals("a; b", measured.facts().get("command"));
        assertThrows(IllegalArgumentException.class, () -> measured.add("frame, ms", "S1", "ours", 1, 1));
    }

    @Test
    void whatIsNotGeneratedStays() {
        String page =
                "before\n<!-- generated: a -->\nold\n<!-- end -->\n<!-- generated: b -->\nold\n<!-- end -->\nafter\n";
        assertEquals(
                "before\n<!-- generated: a -->\nnew\n<!-- end -->\n<!-- generated: b -->\nold\n<!-- end -->\nafter\n",
                GeneratedPage.fill(page, name -> name.equals("a") ? "new\n" : null));
        assertThrows(IllegalArgumentException.class, () -> GeneratedPage.fill("<!-- generated: a -->\n", name -> ""));
    }
}
