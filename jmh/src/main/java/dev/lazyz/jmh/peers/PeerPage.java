package dev.lazyz.jmh.peers;

import dev.lazyz.jmh.report.Charts;
import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.jmh.report.Measurements;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * Writes the tables of {@code docs/performance.md} and its charts from the results of {@link SideBySide} and {@link
 * Jobs}.
 */
public final class PeerPage {
    /** Width and height of the pictures in tables. */
    private static final int SIDE = 1024;

    /** Lazy Z as tables show it: with the Vector API, and without. */
    private static final List<String> OURS = List.of("JDK 25 with the Vector API", "JDK 25");

    /** Lazy Z as sentences about lit files show it. */
    private static final List<String> LIT = List.of("JDK 25 with the Vector API", "JDK 25", "JDK 17");

    private static final String LIT_RATIOS = "%.2f to %.2f (median %.2f)";

    /** What the scenes are. */
    private static final Map<String, String> CONTENTS = Map.of(
            "S1", "S1, 100,000 triangles of about 200 pixels",
            "S2", "S2, a mesh of 1,002,252 triangles of 1 to 2 pixels",
            "S3", "S3, 100 layers, from back to front",
            "S4", "S4, 100 layers, from front to back",
            "S5", "S5, the triangles of S1 with an expensive shader",
            "S6", "S6, 10,000 triangles of about 20,000 pixels");

    private final Measurements results;
    private final List<PeerScene> subjects;

    private final Measurements jobs;

    PeerPage(Measurements results, Measurements jobs) {
        this.results = results;
        this.jobs = jobs;
        this.subjects =
                results.subjects(SideBySide.TIME).stream().map(PeerScene::parse).toList();
    }

    /** Two arguments: the page, and the folder with results.csv and jobs.csv, which also receives the charts. */
    public static void main(String[] args) throws IOException {
        if (args.length != 2) {
            throw new IllegalArgumentException("give the page and the folder of results");
        }
        Path folder = Path.of(args[1]);
        PeerPage page = new PeerPage(
                Measurements.read(folder.resolve("results.csv")), Measurements.read(folder.resolve("jobs.csv")));
        GeneratedPage.update(Path.of(args[0]), page::section);
        for (int threads : List.of(1, 2)) {
            page.writeChart(folder, threads);
        }
    }

    /** Returns a table of the page by its name. */
    String section(String name) {
        return switch (name) {
            case "summary" -> summary();
            case "meshes" -> meshes();
            case "starts" -> starts();
            case "lit" -> lit();
            case "jobs" -> Jobs.table(jobs);
            default -> throw new IllegalArgumentException("no table '" + name + "'");
        };
    }

    private static boolean isMesh(PeerScene subject) {
        return subject.scene().contains(".") && !isLit(subject);
    }

    private static boolean isLit(PeerScene subject) {
        return subject.scene().endsWith(TriangleSource.LIT_LABEL);
    }

    /** Scenes that are not mesh files, at the main size, with baked light. */
    private Predicate<PeerScene> isScene(int threads) {
        return subject -> subject.side() == SIDE && subject.threads() == threads && !isMesh(subject) && !isLit(subject);
    }

    private OptionalDouble time(PeerScene subject, String program) {
        return results.median(SideBySide.TIME, subject.toString(), program);
    }

    private OptionalDouble ratio(PeerScene subject, String program) {
        return Measurements.median(results.ratios(SideBySide.TIME, subject.toString(), program, SideBySide.BASE));
    }

    /** Returns the times of scenes with one thread. */
    private String summary() {
        return times(
                        subjects.stream().filter(isScene(1)).toList(),
                        subject -> CONTENTS.getOrDefault(subject.scene(), subject.scene()))
                + "\n" + GeneratedPage.source(results);
    }

    /**
     * Returns the times of lit mesh files with 16 samples a pixel, where llvmpipe has 4, and sentences about one sample
     * and 16.
     */
    private String lit() {
        List<PeerScene> lit = subjects.stream().filter(PeerPage::isLit).toList();
        StringBuilder text = new StringBuilder(times(
                lit.stream().filter(subject -> subject.samples() > 1).toList(),
                subject -> subject.scene().replace(TriangleSource.LIT_LABEL, "")));
        text.append('\n');
        for (String program : LIT) {
            String many = spread(LIT_RATIOS, ratios(lit, 4, program));
            if (!many.isEmpty()) {
                text.append(String.format(
                        "- %s: 1 sample %s, 16 samples %s times as fast as %s; 16 take %s times as long as 1.%n",
                        program,
                        spread(LIT_RATIOS, ratios(lit, 1, program)),
                        many,
                        SideBySide.BASE,
                        spread(LIT_RATIOS, lit.stream().map(subject -> more(subject, program)))));
            }
        }
        return text.toString();
    }

    private Stream<OptionalDouble> ratios(List<PeerScene> subjects, int samples, String program) {
        return subjects.stream()
                .filter(subject -> subject.samples() == samples)
                .map(subject -> ratio(subject, program));
    }

    /** Returns how many times as long a picture takes with several samples a pixel; nothing for one with one sample. */
    private OptionalDouble more(PeerScene subject, String program) {
        OptionalDouble one = time(new PeerScene(subject.scene(), SIDE, 1, 1), program);
        OptionalDouble many = time(subject, program);
        return subject.samples() > 1 && one.isPresent() && many.isPresent()
                ? OptionalDouble.of(many.getAsDouble() / one.getAsDouble())
                : OptionalDouble.empty();
    }

    /** Returns a table of times with one thread. */
    private String times(List<PeerScene> shown, Function<PeerScene, String> label) {
        List<String> head = new ArrayList<>(List.of(SIDE + " x " + SIDE + ", 1 thread", SideBySide.BASE + ", ms"));
        OURS.forEach(program -> head.addAll(List.of(program + ", ms", "times as fast")));
        List<List<String>> rows = new ArrayList<>();
        for (PeerScene subject : shown) {
            List<String> row =
                    new ArrayList<>(List.of(label.apply(subject), GeneratedPage.time(time(subject, SideBySide.BASE))));
            OURS.forEach(program -> row.addAll(
                    List.of(GeneratedPage.time(time(subject, program)), GeneratedPage.ratio(ratio(subject, program)))));
            rows.add(row);
        }
        return GeneratedPage.table(head, rows);
    }

    /** Returns a line about the least, the greatest and the middle one of some ratios; nothing if there are none. */
    static String range(String before, Stream<OptionalDouble> ratios, String after) {
        return spread("- " + before + "%.2f to %.2f" + after + ", %.2f in the median.%n", ratios);
    }

    /** Returns the least, the greatest and the middle one of some ratios in a format; nothing if there are none. */
    private static String spread(String format, Stream<OptionalDouble> ratios) {
        double[] known = ratios.flatMapToDouble(OptionalDouble::stream).sorted().toArray();
        return known.length == 0
                ? ""
                : String.format(
                        Locale.ROOT,
                        format,
                        known[0],
                        known[known.length - 1],
                        Measurements.median(known).getAsDouble());
    }

    /** Returns sentences about all pictures of mesh files. */
    private String meshes() {
        StringBuilder text = new StringBuilder();
        for (String program : OURS) {
            List<OptionalDouble> ratios = subjects.stream()
                    .filter(PeerPage::isMesh)
                    .map(subject -> ratio(subject, program))
                    .filter(OptionalDouble::isPresent)
                    .toList();
            long faster =
                    ratios.stream().filter(ratio -> ratio.getAsDouble() > 1).count();
            text.append(range(
                    program + ": faster than " + SideBySide.BASE + " in " + faster + " of " + ratios.size()
                            + " pictures of mesh files, ",
                    ratios.stream(),
                    " times as fast"));
        }
        return text.toString();
    }

    /** Returns a sentence about the time of whole processes. */
    private String starts() {
        List<String> times = new ArrayList<>();
        for (String program : results.programs(SideBySide.START)) {
            times.add(program + " "
                    + GeneratedPage.time(results.median(SideBySide.START, SideBySide.COLD_SCENE, program)) + " ms");
        }
        return "A process that renders a teapot to a file, from start to end: " + String.join("; ", times) + ".\n";
    }

    private void writeChart(Path folder, int threads) throws IOException {
        List<PeerScene> shown = subjects.stream().filter(isScene(threads)).toList();
        Map<String, List<Double>> programs = new LinkedHashMap<>();
        for (String program : results.programs(SideBySide.TIME)) {
            List<Double> bars = new ArrayList<>();
            for (PeerScene subject : shown) {
                OptionalDouble ratio = ratio(subject, program);
                bars.add(ratio.isPresent() ? (Double) ratio.getAsDouble() : null);
            }
            programs.put(program, bars);
        }
        programs.remove(SideBySide.BASE);
        if (!shown.isEmpty()) {
            Charts.bars(
                    folder.resolve("scenes-" + threads + ".png"),
                    "Times faster than " + SideBySide.BASE + ": " + SIDE + " x " + SIDE + ", "
                            + (threads == 1 ? "1 thread" : threads + " threads"),
                    shown.stream().map(PeerScene::scene).toList(),
                    programs);
        }
    }
}
