package dev.lazyz.jmh.stages;

import dev.lazyz.jmh.report.GeneratedPage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** Writes the tables of {@code docs/performance-stages.md} from the results of {@link StageTable}. */
public final class StagePage {
    /** Limits below this are shown as 0, and no ratio to them, milliseconds. */
    private static final double NEGLIGIBLE = 0.005;

    private final StageResults results;

    StagePage(StageResults results) {
        this.results = results;
    }

    /** Two arguments: the page and the results file. */
    public static void main(String[] args) throws IOException {
        if (args.length != 2) {
            throw new IllegalArgumentException("give the page and the file of results");
        }
        write(Path.of(args[0]), StageResults.read(Path.of(args[1])));
    }

    /** Updates a page. */
    static void write(Path page, StageResults results) throws IOException {
        GeneratedPage.update(page, new StagePage(results)::fill);
    }

    /**
     * Returns the page with updated tables.
     *
     * @throws IllegalArgumentException if a table has no end or an unknown name
     */
    String fill(String page) {
        return GeneratedPage.fill(page, this::section);
    }

    private String section(String name) {
        return switch (name) {
            case "largest" -> largest();
            case "summary" -> summary();
            case "stages" -> stages();
            case "machines" -> machines();
            case "work" -> work();
            case "counts" -> counts();
            case "scenes" -> scenes();
            default -> throw new IllegalArgumentException("no table '" + name + "'");
        };
    }

    /** A stage of a frame, and how much more it takes than its limit, milliseconds. */
    private record Gap(FrameCounts counts, Stage stage, double time, Limit limit) {
        double difference() {
            return time - limit.time();
        }
    }

    /** Returns the stages of a frame, those with the largest difference first. */
    private List<Gap> gaps(StageResults.FrameTime frame, FrameCounts counts) {
        return Arrays.stream(Stage.values())
                .map(stage -> new Gap(counts, stage, results.time(frame, stage), results.limit(counts, stage)))
                .sorted(Comparator.comparingDouble(Gap::difference).reversed())
                .toList();
    }

    /** Returns a sentence for each runtime: which stage of which scene is farthest from its limit. */
    private String largest() {
        StringBuilder text = new StringBuilder();
        for (String jvm : results.jvms()) {
            text.append(text.isEmpty() ? "" : "\n");
            List<Gap> all = new ArrayList<>();
            for (FrameCounts counts : results.counts()) {
                results.frame(jvm, counts).ifPresent(frame -> all.addAll(gaps(frame, counts)));
            }
            all.stream()
                    .max(Comparator.comparingDouble(Gap::difference))
                    .ifPresent(gap -> text.append(jvm)
                            .append(": the largest difference is *")
                            .append(gap.stage().label())
                            .append("* of ")
                            .append(gap.counts().scene())
                            .append(", ")
                            .append(milliseconds(gap.time()))
                            .append(" ms with a limit of ")
                            .append(milliseconds(gap.limit().time()))
                            .append(".\n"));
        }
        return text.toString();
    }

    /** Returns a row for each frame: what it takes, the sum of the limits, and the stage farthest from its limit. */
    private String summary() {
        List<String> head = new ArrayList<>(List.of("scene", "raster", "limit, ms"));
        for (String jvm : results.jvms()) {
            head.addAll(List.of(jvm + ", ms", "times the limit", "largest difference, ms"));
        }
        List<List<String>> rows = new ArrayList<>();
        for (FrameCounts counts : results.counts()) {
            List<String> row = new ArrayList<>(
                    List.of(counts.scene(), Integer.toString(counts.side()), milliseconds(limit(counts))));
            for (String jvm : results.jvms()) {
                row.addAll(results.frame(jvm, counts)
                        .map(frame -> summary(frame, counts))
                        .orElse(List.of("", "", "")));
            }
            rows.add(row);
        }
        return GeneratedPage.table(head, rows);
    }

    private List<String> summary(StageResults.FrameTime frame, FrameCounts counts) {
        Gap first = gaps(frame, counts).get(0);
        return List.of(
                milliseconds(frame.time()),
                "**" + ratio(frame.time(), limit(counts)) + "**",
                first.stage().label() + " " + milliseconds(first.difference()));
    }

    /** The sum of the limits of all stages of a frame, milliseconds. */
    private double limit(FrameCounts counts) {
        return Arrays.stream(Stage.values())
                .mapToDouble(stage -> results.limit(counts, stage).time())
                .sum();
    }

    private static String stages() {
        List<List<String>> rows = new ArrayList<>();
        for (Stage stage : Stage.values()) {
            rows.add(List.of(stage.label(), stage.content));
        }
        return GeneratedPage.table(List.of("stage", "what"), rows);
    }

    private String machines() {
        List<List<String>> rows = new ArrayList<>();
        List<Machine> machines = new ArrayList<>(results.machines());
        machines.add(Machine.best(results.machines()));
        for (Machine machine : machines) {
            rows.add(List.of(
                    machine.jvm(),
                    billions(machine.l2()),
                    billions(machine.l3()),
                    billions(machine.memory()),
                    billions(machine.operations()),
                    billions(machine.divisions())));
        }
        List<String> head = List.of(
                "runtime",
                "copy of " + kibibytes(Machine.L2_SIZE) + ", GB/s",
                "copy of " + kibibytes(Machine.L3_SIZE) + ", GB/s",
                "copy of " + kibibytes(Machine.MEMORY_SIZE) + ", GB/s",
                "operations, 10^9/s",
                "divisions, 10^9/s");
        StringBuilder facts = new StringBuilder();
        for (Map.Entry<String, String> fact : results.facts().entrySet()) {
            facts.append("- ")
                    .append(fact.getKey())
                    .append(": ")
                    .append(fact.getValue())
                    .append('\n');
        }
        for (String jvm : results.jvms()) {
            facts.append("- Samples with ")
                    .append(jvm)
                    .append(", for each millisecond of the thread: ")
                    .append(found(jvm))
                    .append('\n');
        }
        return GeneratedPage.table(head, rows) + "\n" + facts;
    }

    /** The least and the greatest number of samples for each millisecond. */
    private String found(String jvm) {
        DoubleSummaryStatistics found = results.frames().stream()
                .filter(frame -> frame.jvm().equals(jvm))
                .mapToDouble(StageResults.FrameTime::found)
                .summaryStatistics();
        return number("%.2f", found.getMin()) + " to " + number("%.2f", found.getMax());
    }

    private static String work() {
        List<List<String>> rows = new ArrayList<>();
        for (Work work : Work.ALL) {
            rows.add(List.of(
                    work.stage().label(),
                    work.unit(),
                    number("%.0f", work.bytes()),
                    work.data().name().toLowerCase(Locale.ROOT),
                    number(work.operations() % 1 == 0 ? "%.0f" : "%.1f", work.operations()),
                    number("%.0f", work.divisions()),
                    work.reason()));
        }
        return GeneratedPage.table(
                List.of("stage", "for each of the", "bytes", "of", "operations", "divisions", "what they are"), rows);
    }

    private String counts() {
        List<List<String>> rows = new ArrayList<>();
        for (FrameCounts counts : results.counts()) {
            rows.add(List.of(
                    counts.scene(),
                    Integer.toString(counts.side()),
                    grouped(counts.vertices()) + (counts.perspective() == 1 ? ", perspective" : ""),
                    grouped(counts.triangles()),
                    grouped(counts.entries()),
                    grouped(counts.smallFragments()),
                    grouped(counts.setUps()),
                    grouped(counts.compared()),
                    grouped(counts.drawn()),
                    grouped(counts.runs()),
                    grouped(counts.visible()),
                    grouped(counts.mixed())));
        }
        return GeneratedPage.table(
                List.of(
                        "scene",
                        "raster",
                        "vertices",
                        "triangles",
                        "entries",
                        "fragments of small triangles",
                        "triangles by tile",
                        "compared samples",
                        "samples of tiles drawn into",
                        "runs",
                        "visible samples",
                        "interpolated samples"),
                rows);
    }

    /** Returns a table for each frame. */
    private String scenes() {
        StringBuilder text = new StringBuilder();
        for (FrameCounts counts : results.counts()) {
            text.append("\n### ").append(counts.scene());
            text.append(", ").append(counts.side()).append(" x ").append(counts.side());
            text.append("\n\n").append(scene(counts));
        }
        return text.append('\n').toString();
    }

    private String scene(FrameCounts counts) {
        List<String> head = new ArrayList<>(List.of("stage", "limit, ms", "by"));
        for (String jvm : results.jvms()) {
            head.addAll(List.of(jvm + ", ms", "times the limit", "difference, ms"));
        }
        List<List<String>> rows = new ArrayList<>();
        for (Stage stage : Stage.values()) {
            Limit limit = results.limit(counts, stage);
            List<String> row = new ArrayList<>(List.of(
                    stage.label(),
                    limit.time() == 0 ? "" : milliseconds(limit.time()),
                    limit.time() < NEGLIGIBLE ? "" : limit.bound()));
            for (String jvm : results.jvms()) {
                row.addAll(results.frame(jvm, counts)
                        .map(frame -> cells(results.time(frame, stage), limit))
                        .orElse(List.of("", "", "")));
            }
            rows.add(row);
        }
        return GeneratedPage.table(head, rows);
    }

    private static List<String> cells(double time, Limit limit) {
        return List.of(
                milliseconds(time),
                limit.time() < NEGLIGIBLE ? "" : ratio(time, limit.time()),
                milliseconds(time - limit.time()));
    }

    private static String ratio(double time, double limit) {
        double ratio = time / limit;
        return number(ratio < 10 ? "%.1f" : "%.0f", ratio);
    }

    private static String milliseconds(double time) {
        if (Math.abs(time) < NEGLIGIBLE) {
            return "0.00";
        }
        return number(Math.abs(time) < 10 ? "%.2f" : Math.abs(time) < 100 ? "%.1f" : "%.0f", time);
    }

    private static String billions(double perSecond) {
        return number(perSecond < 1e10 ? "%.2f" : "%.1f", perSecond / 1e9);
    }

    private static String kibibytes(long bytes) {
        return bytes < 1 << 20 ? (bytes >> 10) + " KiB" : (bytes >> 20) + " MiB";
    }

    private static String grouped(long count) {
        return number("%,d", count);
    }

    private static String number(String format, Object value) {
        return String.format(Locale.ROOT, format, value);
    }
}
