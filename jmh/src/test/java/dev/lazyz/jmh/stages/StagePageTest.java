package dev.lazyz.jmh.stages;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class StagePageTest {
    private static final List<String> LINES = List.of(
            "machine {\"jvm\":\"JDK 25\",\"l2\":12e9,\"l3\":6e9,\"memory\":3e9,\"operations\":36e9,\"divisions\":1e9}",
            "frame {\"jvm\":\"JDK 25\",\"scene\":\"S1\",\"side\":64,\"time\":10,\"setUp\":3,\"median\":11,"
                    + "\"frames\":9,\"samples\":100,\"found\":0.25}",
            "stage {\"jvm\":\"JDK 25\",\"scene\":\"S1\",\"side\":64,\"stage\":\"transform\",\"time\":3}",
            "stage {\"jvm\":\"JDK 25\",\"scene\":\"S1\",\"side\":64,\"stage\":\"set up\",\"time\":7}",
            "counts {\"scene\":\"S1\",\"side\":64,\"vertices\":1000000,\"perspective\":0,\"triangles\":0,\"small\":0,"
                    + "\"smallFragments\":0,\"entries\":0,\"compared\":0,\"drawn\":0,\"visible\":0,\"runs\":0,"
                    + "\"faces\":0,\"mixed\":0,\"mixedFaces\":0,\"rounds\":0,\"lit\":0}");

    @Test
    void theStageWithTheLargestDifferenceIsNamed() {
        String page = fill("largest");
        assertTrue(
                page.contains("JDK 25: the largest difference is *set up* of S1, 7.00 ms with a limit of 0.00."), page);
        assertTrue(fill("summary").contains("| 12.0 | 10.0 | **0.8** | set up 7.00 |"), fill("summary"));
    }

    @Test
    void eachStageHasARow() {
        String page = fill("scenes");
        assertTrue(page.contains("### S1, 64 x 64"), page);
        assertTrue(page.contains("| transform | 4.00 | bytes | 3.00 | 0.8 | -1.00 |"), page);
        assertTrue(page.contains("| hand out |  |  | 0.00 |  | 0.00 |"), page);
    }

    @Test
    void constantsAndSamplesAreShown() {
        assertTrue(fill("work").contains("| transform | vertices | 12 | mesh | 36 | 0 |"), fill("work"));
        assertTrue(fill("machines").contains("for each millisecond of the thread: 0.25 to 0.25"), fill("machines"));
        assertTrue(fill("counts").contains("| S1 | 64 | 1,000,000 |"), fill("counts"));
        assertTrue(fill("stages").contains("| encode |"), fill("stages"));
    }

    @Test
    void aTableOfUnknownNameIsRefused() {
        assertThrows(IllegalArgumentException.class, () -> fill("no"));
    }

    @Test
    void resultsSurviveTheirFileAndReplaceTheirRuntimeOnly(@TempDir Path folder) throws IOException {
        StageResults results = results();
        results.write(folder.resolve("stages.json"));
        StageResults read = StageResults.read(folder.resolve("stages.json"));
        assertEquals(results, read);
        read.remove("JDK 25", "S1", 128);
        read.remove("JDK 17");
        assertEquals(results, read);
        read.remove("JDK 25");
        assertEquals(StageResults.empty(), read);
        assertThrows(IllegalArgumentException.class, () -> read.add("other {}"));
    }

    @Test
    void aFrameCanBeMeasuredAgain() {
        StageResults results = results();
        results.remove("JDK 25", "S1", 64);
        assertTrue(results.frames().isEmpty());
        assertTrue(results.stages().isEmpty());
        assertEquals(results().machines(), results.machines());
        LINES.stream().filter(line -> !line.startsWith("machine")).forEach(results::add);
        assertEquals(results(), results);
    }

    @Test
    void thePageShowsTheResultsBesideIt() throws IOException {
        Path docs = Path.of("..", "docs").toAbsolutePath().normalize();
        StageResults results = StageResults.read(docs.resolve("performance/stages.json"));
        assertFalse(results.frames().isEmpty());
        String page = Files.readString(docs.resolve("performance-stages.md"));
        assertEquals(page, new StagePage(results).fill(page), "run StagePage, see jmh/README.md");
    }

    private static StageResults results() {
        StageResults results = StageResults.empty();
        LINES.forEach(results::add);
        return results;
    }

    private static String fill(String table) {
        return new StagePage(results()).fill("<!-- generated: " + table + " -->\n<!-- end -->");
    }
}
