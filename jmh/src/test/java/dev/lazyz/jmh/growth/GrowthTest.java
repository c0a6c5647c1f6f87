package dev.lazyz.jmh.growth;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.jmh.report.Measurements;
import dev.lazyz.strategies.Renderers;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;

class GrowthTest {
    private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();
    private static final Path DOCS = ROOT.resolve("docs");

    /** Part of the committed points at which the model's choice must be good. */
    private static final double GOOD = 0.95;

    /** The same where the usual winner is left out: then many are about as fast. */
    private static final double FAIR = 0.7;

    /** Of the committed results: to fit the model takes seconds. */
    private static GrowthPage committedPage;

    @BeforeAll
    static void fit() throws IOException {
        committedPage = new GrowthPage(committed());
    }

    private static Measurements committed() throws IOException {
        return Measurements.read(DOCS.resolve("growth/results.csv"));
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    void theModelChoosesWell() {
        assertTrue(
                committedPage.good(false) >= GOOD * committedPage.choices(false),
                () -> committedPage.section("choices"));
        assertTrue(
                committedPage.good(true) >= FAIR * committedPage.choices(true), () -> committedPage.section("choices"));
    }

    @Test
    void allStrategiesAndAxesWereMeasured() throws IOException {
        Measurements results = committed();
        List<String> measured = results.subjects(Growth.PRIMITIVES);
        for (GrowthAxis axis : GrowthAxis.values()) {
            axis.first(axis.values.length).forEach(value -> assertTrue(measured.contains(axis.subject(value))));
        }
        assertEquals(
                Renderers.getBuiltIn().size(), results.programs(Growth.TIME).size());
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    void thePageAndTheModelAreThoseOfTheResults() throws IOException {
        String remedy = "run GrowthPage, see jmh/README.md";
        String text = Files.readString(DOCS.resolve("growth.md"));
        assertEquals(text, GeneratedPage.fill(text, committedPage::section), remedy);
        assertEquals(Files.readString(ROOT.resolve(GrowthPage.COSTS)), committedPage.fit.toKotlin(), remedy);
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    void aRunWritesResultsPageChartsAndModel(@TempDir Path folder) throws InterruptedException, IOException {
        Path page = folder.resolve("growth.md");
        Path file = folder.resolve("results.csv");
        Files.copy(DOCS.resolve("growth.md"), page);
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
        Measurements results = Measurements.read(file);
        assertEquals(4, results.subjects(Growth.PRIMITIVES).size());
        assertEquals(
                Renderers.getBuiltIn().size(), results.programs(Growth.TIME).size());
        assertEquals(1, results.ascending(Growth.TIME, "threads 1", "tiled").length);
        assertEquals(0, results.ascending(Growth.TIME, "threads 1", "zbuffer").length);
        String summary = Files.readString(page);
        assertTrue(summary.contains("| tiled | – | – | – | – | – |\n"), summary);
        assertTrue(summary.matches("(?s).*`tiled` is the fastest in \\d of 2 measured frames\\..*"), summary);
        assertTrue(Files.size(folder.resolve("depth-time.png")) > 0);
        assertTrue(Files.readString(folder.resolve("costs.kt")).contains("\"tiled\" to doubleArrayOf("));
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    void whatIsTooSlowIsNotMeasuredFurtherOn(@TempDir Path folder) throws InterruptedException, IOException {
        Path page = folder.resolve("growth.md");
        Path file = folder.resolve("results.csv");
        Files.writeString(page, "<!-- generated: summary -->\n<!-- end -->\n");
        Growth.main(new String[] {
            "--points",
            "2",
            "--rounds",
            "1",
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
        Measurements results = Measurements.read(file);
        int strategies = Renderers.getBuiltIn().size();
        assertEquals(List.of("shading 1"), results.subjects(Growth.TIME));
        assertEquals(strategies, results.programs(Growth.TIME).size());
        assertTrue(Files.readString(page).contains("| tiled | – | – | – | – | – |\n"), Files.readString(page));
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
