package dev.lazyz.jmh.growth;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.strategies.Renderers;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIfSystemProperty;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

class GrowthTest {
    private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();
    private static final Path DOCS = ROOT.resolve("docs");

    /** Part of the committed points at which the model's choice must be good. */
    private static final double GOOD = 0.95;

    /** The same where the usual winner is left out: then many are about as fast. */
    private static final double FAIR = 0.7;

    private static GrowthResults committed() throws IOException {
        return GrowthResults.read(DOCS.resolve("growth/results.json"));
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    void theModelChoosesWell() throws IOException {
        GrowthPage page = new GrowthPage(committed());
        assertTrue(page.good(false) >= GOOD * page.points(false), page.good(false) + " of " + page.points(false));
        assertTrue(page.good(true) >= FAIR * page.points(true), page.good(true) + " of " + page.points(true));
    }

    @Test
    void allStrategiesAndAxesWereMeasured() throws IOException {
        GrowthResults results = committed();
        for (Axis axis : Axis.values()) {
            assertEquals(axis.values.length, results.points(axis).size(), axis.id());
        }
        assertEquals(Renderers.getBuiltIn().size(), results.strategies().size());
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    void thePageAndTheModelAreThoseOfTheResults() throws IOException {
        String remedy = "run GrowthPage, see jmh/README.md";
        GrowthPage results = new GrowthPage(committed());
        for (String name : List.of("growth.md", "growth-tables.md")) {
            String page = Files.readString(DOCS.resolve(name));
            assertEquals(page, results.fill(page), remedy);
        }
        assertEquals(Files.readString(ROOT.resolve(GrowthPage.COSTS)), new ModelFit(committed()).toKotlin(), remedy);
    }

    /** The first screen, of about forty lines, has the figures that matter. */
    @Test
    void thePageBeginsWithTheSummary() throws IOException {
        List<String> lines = Files.readAllLines(DOCS.resolve("growth.md"));
        assertTrue(lines.indexOf("## What is measured") <= 40);
        assertTrue(lines.indexOf("<!-- generated: summary -->") < lines.indexOf("<!-- end -->"));
        assertTrue(lines.indexOf("<!-- end -->") < lines.indexOf("## What is measured"));
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    void aRunWritesResultsPageChartsAndModel(@TempDir Path folder) throws InterruptedException, IOException {
        Path page = folder.resolve("growth.md");
        Path tables = folder.resolve("growth-tables.md");
        Path file = folder.resolve("results.json");
        Files.copy(DOCS.resolve("growth.md"), page);
        Files.copy(DOCS.resolve("growth-tables.md"), tables);
        Growth.main(new String[] {
            "--points",
            "2",
            "--rounds",
            "1",
            "--warm-up",
            "0",
            "--axes",
            "depth,threads",
            "--results",
            file.toString(),
            "--page",
            page.toString(),
            "--costs",
            folder.resolve("costs.kt").toString(),
        });
        GrowthResults results = GrowthResults.read(file);
        assertEquals(4, results.points().size());
        assertEquals(
                Renderers.getBuiltIn().size(), results.strategies(Axis.DEPTH).size());
        assertEquals(List.of("tiled"), results.strategies(Axis.THREADS));
        assertTrue(Files.readString(tables).contains("| depth complexity | 1 | 3 | theory |"));
        String summary = Files.readString(page);
        assertTrue(summary.contains("| tiled |  |  |  |  |  |\n"), summary);
        assertTrue(summary.matches("(?s).*`tiled` is the fastest in \\d of 2 measured frames\\..*"), summary);
        assertTrue(Files.size(folder.resolve("depth-time.png")) > 0);
        assertTrue(Files.readString(folder.resolve("costs.kt")).contains("\"tiled\" to doubleArrayOf("));
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    void whatIsTooSlowIsNotMeasuredFurtherOn(@TempDir Path folder) throws InterruptedException, IOException {
        Path page = folder.resolve("growth.md");
        Path file = folder.resolve("results.json");
        Files.writeString(page, "<!-- generated: shading time -->\n<!-- end -->\n");
        Growth.main(new String[] {
            "--points",
            "2",
            "--rounds",
            "2",
            "--warm-up",
            "0",
            "--axes",
            "shading",
            "--limit",
            "0",
            "--results",
            file.toString(),
            "--page",
            page.toString(),
            "--costs",
            folder.resolve("costs.kt").toString(),
        });
        GrowthResults results = GrowthResults.read(file);
        assertEquals(Renderers.getBuiltIn().size(), results.costs().size());
        assertEquals(Renderers.getBuiltIn().size(), results.missing().size());
        assertTrue(Files.readString(page).contains(" | too slow | p c |  |  |"), Files.readString(page));
    }

    @Test
    void slopesAreExponents() {
        List<double[]> square =
                List.of(new double[] {1, 5}, new double[] {2, 5}, new double[] {4, 80}, new double[] {8, 320});
        assertEquals(2, Slope.last(square.subList(1, 4).subList(1, 3)), 1e-9);
        assertEquals(Math.log(64) / Math.log(4), Slope.last(square), 1e-9);
        assertTrue(Double.isNaN(Slope.last(square.subList(0, 1))));
        assertTrue(new Order("n", 1, 1).isDeparture(1.2) && !new Order("n", 1, 1).isDeparture(0.9));
    }

    @Test
    void coefficientsAreFoundAgainAndNeverNegative() {
        List<double[]> rows = new ArrayList<>();
        for (double[] terms : new double[][] {{1, 10}, {1, 100}, {1, 1000}, {1, 5}}) {
            double value = 30 + 2 * terms[1];
            rows.add(new double[] {terms[0] / value, terms[1] / value});
        }
        assertArrayEquals(new double[] {30, 2}, ModelFit.leastSquares(rows), 1e-6);
        List<double[]> falling = List.of(new double[] {0.01, 0.1}, new double[] {0.02, 2});
        for (double coefficient : ModelFit.leastSquares(falling)) {
            assertTrue(coefficient >= 0);
        }
    }
}
