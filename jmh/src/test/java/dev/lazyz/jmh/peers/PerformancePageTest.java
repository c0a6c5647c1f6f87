package dev.lazyz.jmh.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class PerformancePageTest {
    private static final Results RESULTS = new Results(
            Map.of("processor", "a \"fast\" one"),
            List.of(
                    time("S1", 1, "llvmpipe", 1, 100),
                    time("S1", 1, "JDK 25", 1, 20),
                    time("S1", 2, "JDK 25", 1, 10),
                    time("S1", 1, "llvmpipe", 2, 90),
                    time("S1", 1, "JDK 25", 2, 30),
                    time("S1", 2, "JDK 25", 2, 20),
                    time("S1", 1, "llvmpipe", 3, 200),
                    time("S1", 1, "JDK 25", 3, 50),
                    time("city", 1, "llvmpipe", 1, 3),
                    time("city", 1, "JDK 25", 1, 2),
                    time("cow.obj", 1, "llvmpipe", 1, 8),
                    time("cow.obj", 1, "JDK 25", 1, 2),
                    lit(1, "llvmpipe", 6),
                    lit(1, "JDK 25", 3),
                    lit(4, "llvmpipe", 12),
                    lit(4, "JDK 25", 24),
                    lit(4, "JDK 25, once a pixel", 8),
                    new Results.Time("bunny.obj", 256, 1, 1, "llvmpipe", 1, 5, 5, 5, 5, 5, 5, 9)),
            List.of(new Results.Picture("S1", 1024, "VTK", 1000, 2, 3, -1, -1)),
            List.of(
                    new Results.Start("zcli", 1, 400),
                    new Results.Start("VTK", 1, 900),
                    new Results.Start("zcli", 2, 500)));

    @Test
    void ratiosAreTakenWithinARound() {
        String page = fill("compared");
        assertTrue(page.contains("| llvmpipe | 100 (90.0..200) |"), page);
        assertTrue(page.contains("| JDK 25 | 30.0 (20.0..50.0), **4.00 x (3.00..5.00)** |"), page);
        assertTrue(page.contains("| 1024 x 1024, 2 threads | S1 |"), page);
        assertTrue(page.contains("(performance/compared-1024-1.png)"), page);
        assertFalse(page.contains("(performance/compared-1024-2.png)"), page);
    }

    @Test
    void scenesThatWereNotMadeToBeComparedHaveTheirOwnTable() {
        assertTrue(fill("others").contains("| JDK 25 | 2.00, **1.50 x** |"), fill("others"));
    }

    @Test
    void meshesHaveARowEach() {
        assertTrue(fill("meshes").contains("| cow.obj | 1024 | 8.00 | 2.00, **4.00 x** |"), fill("meshes"));
        assertTrue(fill("meshes").contains("| bunny.obj | 256 | 5.00 |  |"), fill("meshes"));
        assertFalse(fill("meshes").contains("| bunny.obj | 1024 |"), fill("meshes"));
        assertFalse(fill("others").contains("cow"), fill("others"));
    }

    @Test
    void litScenesHaveTheirOwnTable() {
        assertTrue(fill("lit").contains("| cow.obj, lit | 1024 | 6.00 | 3.00, **2.00 x** |\n"), fill("lit"));
        assertFalse(fill("meshes").contains("lit"), fill("meshes"));
        assertFalse(fill("others").contains("lit"), fill("others"));
        assertFalse(fill("summary").contains("lit"), fill("summary"));
    }

    @Test
    void antiAliasedPicturesAreComparedWithTheBaseAndWithOneSample() {
        String row = "| cow.obj, lit | 1024 | 12.0; 2.0 | 24.0, **0.50 x**; 8.0 | 8.00, **1.50 x**; 2.7 |";
        assertTrue(fill("smooth").contains(row), fill("smooth"));
    }

    @Test
    void resultsOfASceneCanBeReplaced() {
        Results results =
                new Results(Map.of(), new ArrayList<>(RESULTS.times()), new ArrayList<>(RESULTS.pictures()), List.of());
        results.drop("S1");
        assertTrue(results.pictures().isEmpty());
        assertTrue(results.times().stream().noneMatch(PerformancePage::isCompared));
        assertTrue(results.times().stream().anyMatch(PerformancePage::isMesh));
    }

    @Test
    void runsAreCountedAndTheirFactsKept() {
        assertEquals(3, RESULTS.rounds());
        assertEquals(0, Results.empty().rounds());
        Results results = Results.empty();
        for (String value : List.of("a", "b", "a")) {
            results.addFact("added: command", value);
        }
        assertEquals("a; b", results.facts().get("added: command"));
    }

    @Test
    void threadsGain() {
        assertTrue(fill("gain").contains("| S1 | 1024 | JDK 25 | 1.75 x (1.50..2.00) |"), fill("gain"));
    }

    @Test
    void coloursThatCannotBeComparedAreNotShown() {
        assertTrue(fill("pictures").contains("| VTK | 1,000 | 2 | 3 |  |  |"), fill("pictures"));
    }

    @Test
    void startsAreSummedUp() {
        assertTrue(fill("starts").contains("| zcli | 450 | 400..500 |"), fill("starts"));
    }

    @Test
    void whatIsNotGeneratedStays() {
        String page = "before\n<!-- generated: facts -->\nold\n<!-- end -->\nafter\n";
        String filled = new PerformancePage(RESULTS).fill(page);
        assertTrue(filled.startsWith("before\n<!-- generated: facts -->\n| fact | value |\n"), filled);
        assertTrue(filled.endsWith("|\n<!-- end -->\nafter\n"), filled);
        assertEquals(filled, new PerformancePage(RESULTS).fill(filled));
    }

    @Test
    void aTableWithoutEndOrOfUnknownNameIsRefused() {
        PerformancePage page = new PerformancePage(RESULTS);
        assertThrows(IllegalArgumentException.class, () -> page.fill("<!-- generated: facts -->\n"));
        assertThrows(IllegalArgumentException.class, () -> page.fill("<!-- generated: no -->\n<!-- end -->"));
    }

    @Test
    void resultsSurviveTheirFile(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("results.json");
        RESULTS.write(file);
        assertEquals(RESULTS, Results.read(file));
    }

    @Test
    void aChartIsDrawnForEachTableThatHasTheBase(@TempDir Path folder) throws IOException {
        new Charts(RESULTS).write(folder);
        assertTrue(Files.size(folder.resolve("compared-1024-1.png")) > 0);
        assertTrue(Files.size(folder.resolve("others-1024-1.png")) > 0);
        assertTrue(Files.notExists(folder.resolve("compared-1024-2.png")));
    }

    @Test
    void thePageShowsTheResultsBesideIt() throws IOException {
        Path docs = Path.of("..", "docs").toAbsolutePath().normalize();
        Results results = Results.read(docs.resolve("performance/results.json"));
        for (String name : List.of("performance.md", "performance-tables.md")) {
            String page = Files.readString(docs.resolve(name));
            assertEquals(page, new PerformancePage(results).fill(page), "run PerformancePage, see jmh/README.md");
        }
    }

    /** The first screen, of about forty lines, has the figures that matter. */
    @Test
    void thePageBeginsWithTheSummary() throws IOException {
        Path docs = Path.of("..", "docs").toAbsolutePath().normalize();
        List<String> lines = Files.readAllLines(docs.resolve("performance.md"));
        assertTrue(lines.indexOf("## What is measured") <= 45);
        assertTrue(lines.indexOf("<!-- generated: summary -->") < lines.indexOf("## What is measured"));
        assertTrue(lines.indexOf("<!-- generated: jobs summary -->") < lines.indexOf("## What is measured"));
    }

    @Test
    void theSummaryTellsWhatTheTablesTell() {
        String page = fill("summary");
        assertTrue(page.contains("| S1, 100,000 triangles of about 200 pixels | 100 |  |  | 30.0 | **4.00** |"), page);
        assertTrue(page.contains("| city | 3.00 |  |  | 2.00 | **1.50** |"), page);
        assertTrue(page.contains("from start to end: zcli 450 ms; VTK 900 ms."), page);
        List<Results.Time> meshes = List.of(
                time("a.obj", 1, "llvmpipe", 1, 8),
                time("a.obj", 1, "JDK 25, Vector API", 1, 2),
                time("b.obj", 1, "llvmpipe", 1, 3),
                time("b.obj", 1, "JDK 25, Vector API", 1, 4));
        String meshPage = new PerformancePage(new Results(Map.of(), meshes, List.of(), List.of()))
                .fill("<!-- generated: summary -->\n<!-- end -->");
        String sentence = "faster than llvmpipe in 1 of 2 pictures, 0.75 to 4.00 times as fast, 2.38 in the median.";
        assertTrue(meshPage.contains(sentence), meshPage);
    }

    private static String fill(String table) {
        return new PerformancePage(RESULTS).fill("<!-- generated: " + table + " -->\n<!-- end -->");
    }

    private static Results.Time lit(int samples, String contender, double median) {
        return new Results.Time(
                "cow.obj, lit", 1024, samples, 1, contender, 1, median, median, median, median, median, median, 9);
    }

    private static Results.Time time(String scene, int threads, String contender, int round, double median) {
        return new Results.Time(
                scene, 1024, 1, threads, contender, round, median, median, median, median, median, median, 9);
    }
}
