package dev.lazyz.jmh.jobs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.jmh.report.JsonRecords;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class JobResultsTest {
    private static final JobResults RESULTS = new JobResults(
            Map.of("VTK", "9"),
            List.of(
                    job("a.obj", JobResults.OURS, 1, 10),
                    job("a.obj", JobResults.VTK, 1, 30),
                    job("a.obj", JobResults.OURS, 2, 20),
                    job("a.obj", JobResults.VTK, 2, 40),
                    job("a.obj", JobResults.OURS, 3, 12),
                    job("a.obj", JobResults.VTK, 3, 48),
                    job("b.stl", JobResults.OURS, 1, 5)));

    @Test
    void ratiosAreTakenWithinARound() {
        String page = RESULTS.tables();
        assertTrue(page.contains("| a.obj | 12.0 (8.0 + 4.0) | 40.0 (36.0 + 4.0) | **3.00 x** (2.00..4.00) |"), page);
        assertTrue(page.contains("| b.stl | 5.0 (1.0 + 4.0) |  |  |"), page);
        assertTrue(page.contains("| VTK | 9 |"), page);
    }

    @Test
    void theSummaryHasTheExtremes() {
        String page = RESULTS.fill("<!-- generated: jobs summary -->\n<!-- end -->");
        assertTrue(page.contains("3.0 to 3.0 times as fast as VTK (1 files)"), page);
    }

    @Test
    void resultsAreKept() {
        var root = JsonRecords.parse(RESULTS.toJson());
        assertEquals(RESULTS.jobs(), JsonRecords.records(root, "jobs", JobResults.Job.class));
    }

    @Test
    void thePageShowsTheJobsBesideIt() throws IOException {
        Path docs = Path.of("..", "docs").toAbsolutePath().normalize();
        var root = JsonRecords.parse(Files.readString(docs.resolve("performance/jobs.json")));
        JobResults results = new JobResults(
                JsonRecords.texts(root, "facts"), JsonRecords.records(root, "jobs", JobResults.Job.class));
        for (String name : List.of("performance.md", "performance-tables.md")) {
            String page = Files.readString(docs.resolve(name));
            assertEquals(page, results.fill(page), "run jmh/peers/whole-job");
        }
    }

    private static JobResults.Job job(String file, String program, int round, double total) {
        return new JobResults.Job(file, program, round, 7, total, total - 4, 4);
    }
}
