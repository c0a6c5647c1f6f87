package dev.lazyz.jmh.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.jmh.report.Measurements;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class PeerPageTest {
    private static final String PLAIN = "JDK 25";
    private static final String VECTOR = "JDK 25 with the Vector API";
    private static final Path DOCS = Path.of("..", "docs").toAbsolutePath().normalize();

    private final Measurements results = new Measurements();

    private String section(String name) {
        return new PeerPage(results, results).section(name);
    }

    private void time(String scene, int samples, String program, int round, double millis) {
        results.add(SideBySide.TIME, new PeerScene(scene, 1024, samples, 1).toString(), program, round, millis);
    }

    @Test
    void scenesAreInTheSummaryAndMeshesAreNot() {
        time("S1", 1, SideBySide.BASE, 1, 100);
        time("S1", 1, PLAIN, 1, 20);
        time("S1", 1, PLAIN, 2, 30);
        time("S1", 1, SideBySide.BASE, 2, 90);
        time("city", 1, PLAIN, 1, 2);
        time("cow.obj", 1, PLAIN, 1, 2);
        time("cow.obj lit", 1, PLAIN, 1, 2);
        String page = section("summary");
        String row = "| S1, 100,000 triangles of about 200 pixels | 95.0 | – | – | 25.0 | **4.00** |\n";
        assertTrue(page.contains(row), page);
        assertTrue(page.contains("| city | – | – | – | 2.00 | – |\n"), page);
        assertFalse(page.contains("cow"), page);
    }

    @Test
    void meshesAreSummedUp() {
        time("a.obj", 1, SideBySide.BASE, 1, 8);
        time("a.obj", 1, VECTOR, 1, 2);
        time("b.obj", 1, SideBySide.BASE, 1, 3);
        time("b.obj", 1, VECTOR, 1, 4);
        assertEquals(
                "- " + VECTOR + ": faster than llvmpipe in 1 of 2 pictures of mesh files, 0.75 to 4.00 times as fast, "
                        + "2.38 in the median.\n",
                section("meshes"));
    }

    @Test
    void jobsHaveARatioWithinARound() {
        for (double[] job : new double[][] {{1, 10, 30}, {2, 20, 40}, {3, 12, 48}}) {
            results.add(Jobs.TOTAL, "a.obj; 512", "JDK 17: 16 samples", (int) job[0], job[1]);
            results.add(Jobs.TOTAL, "a.obj; 512", "JDK 17" + Jobs.ONE_SAMPLE, (int) job[0], job[1]);
            results.add(Jobs.TOTAL, "a.obj; 512", Jobs.VTK + ": 4 samples", (int) job[0], job[2]);
            results.add(Jobs.TOTAL, "a.obj; 512", Jobs.VTK + Jobs.ONE_SAMPLE, (int) job[0], 2 * job[2]);
        }
        results.add(Jobs.LOAD, "a.obj; 512", "JDK 17: 16 samples", 1, 5);
        String table = section("jobs");
        assertTrue(table.contains("| a.obj; 512 | 40.0 | 12.0 (5.00) | **3.00** |\n"), table);
        assertTrue(table.contains("- JDK 17: 1 sample: 6.00 to 6.00 times as fast as VTK: 1 sample, "), table);
    }

    @Test
    void thePageAndTheChartsAreThoseOfTheResults(@TempDir Path folder) throws IOException {
        Path page = folder.resolve("performance.md");
        Files.copy(DOCS.resolve("performance.md"), page);
        for (String name : List.of("results.csv", "jobs.csv")) {
            Files.copy(DOCS.resolve("performance").resolve(name), folder.resolve(name));
        }
        PeerPage.main(new String[] {page.toString(), folder.toString()});
        assertEquals(
                Files.readString(DOCS.resolve("performance.md")),
                Files.readString(page),
                "run PeerPage, see jmh/README.md");
        assertTrue(Files.size(folder.resolve("scenes-1.png")) > 0);
    }
}
