package dev.lazyz.jmh.peers;

import dev.lazyz.jmh.report.GeneratedPage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Predicate;

/**
 * Writes the tables of {@code docs/performance.md} and {@code docs/performance-tables.md}, and their charts, from the
 * results of {@link SideBySide}.
 */
public final class PerformancePage {
    /** Width and height of the pictures in the summary. */
    private static final int SIDE = 1024;

    /** The renderer that the summary is about, and the same without the Vector API. */
    private static final String OURS = "JDK 25, Vector API";

    private static final String PLAIN = "JDK 25";

    /** What the scenes are, for the summary. */
    private static final Map<String, String> CONTENTS = Map.of(
            "S1", "S1, 100,000 triangles of about 200 pixels",
            "S2", "S2, a mesh of 1,002,252 triangles of 1 to 2 pixels",
            "S3", "S3, 100 layers, from back to front",
            "S4", "S4, 100 layers, from front to back",
            "S5", "S5, the triangles of S1 with an expensive shader",
            "S6", "S6, 10,000 triangles of about 20,000 pixels");

    private final Results results;

    PerformancePage(Results results) {
        this.results = results;
    }

    /** Two arguments: the page and the results file, whose folder also receives the charts. */
    public static void main(String[] args) throws IOException {
        if (args.length != 2) {
            throw new IllegalArgumentException("give the page and the file of results");
        }
        Path page = Path.of(args[0]);
        Path file = Path.of(args[1]);
        Results results = Results.read(file);
        GeneratedPage.update(page, new PerformancePage(results)::fill);
        new Charts(results).write(file.toAbsolutePath().getParent());
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
            case "summary" -> summary();
            case "facts" -> facts();
            case "pictures" -> pictures();
            case "compared" -> times(PerformancePage::isCompared);
            case "others" -> times(PerformancePage::isOther);
            case "meshes" -> rows("mesh, 1 thread", PerformancePage::isMesh);
            case "lit" -> rows("scene, 1 thread", time -> isLit(time) && time.samples() == 1);
            case "smooth" -> smooth();
            case "gain" -> gain();
            case "starts" -> starts();
            // Written by dev.lazyz.jmh.jobs.Jobs
            case "jobs", "jobs summary" -> null;
            default -> throw new IllegalArgumentException("no table '" + name + "'");
        };
    }

    /** Whether a time belongs to S1 to S6. */
    static boolean isCompared(Results.Time time) {
        return time.scene().matches("S[1-6]");
    }

    /** Whether a time belongs to a mesh file. */
    static boolean isMesh(Results.Time time) {
        return time.scene().contains(".") && !isLit(time);
    }

    /** Whether a time belongs to a scene or file whose light is computed when it is rendered. */
    static boolean isLit(Results.Time time) {
        return time.scene().endsWith(TriangleSource.LIT_LABEL);
    }

    /** Whether a time belongs to a scene with baked light other than S1 to S6 and mesh files. */
    static boolean isOther(Results.Time time) {
        return !isCompared(time) && !isMesh(time) && !isLit(time);
    }

    /** Returns the figures that matter, all with one thread: each scene at the main size, mesh files, processes. */
    private String summary() {
        List<Results.Time> times = results.times().stream()
                .filter(time -> time.side() == SIDE && time.threads() == 1 && (isCompared(time) || isOther(time)))
                .toList();
        List<List<String>> rows = new ArrayList<>();
        for (String scene : distinct(times.stream().map(Results.Time::scene).toList())) {
            List<String> row = new ArrayList<>(List.of(CONTENTS.getOrDefault(scene, scene)));
            row.add(time(times, scene, Results.BASE));
            for (String contender : List.of(OURS, PLAIN)) {
                row.add(time(times, scene, contender));
                double[] ratios = ratios(times, scene, contender);
                row.add(ratios.length == 0 ? "" : number("**%.2f**", median(ratios)));
            }
            rows.add(row);
        }
        List<String> head = List.of(
                SIDE + " x " + SIDE + ", 1 thread",
                Results.BASE + ", ms",
                "Lazy Z with the Vector API, ms",
                "times as fast",
                "Lazy Z without, ms",
                "times as fast");
        String java = results.facts().getOrDefault("version of JDK 25", "");
        return GeneratedPage.table(head, rows) + "\n" + meshSummary() + startSummary() + "Measured on "
                + results.facts().getOrDefault("date", "") + ", "
                + results.facts().getOrDefault("processor", "") + ", "
                + (java.isEmpty() ? "" : "Java " + java) + ".\n";
    }

    private String time(List<Results.Time> times, String scene, String contender) {
        double[] own = medians(times, scene, contender);
        return own.length == 0 ? "" : milliseconds(median(own));
    }

    /** Returns a sentence about all pictures of mesh files. */
    private String meshSummary() {
        List<Results.Time> meshes =
                results.times().stream().filter(PerformancePage::isMesh).toList();
        double[] ratios = meshes.stream()
                .filter(time -> time.contender().equals(OURS))
                .flatMap(own -> meshes.stream()
                        .filter(base -> base.contender().equals(Results.BASE))
                        .filter(base -> base.scene().equals(own.scene()) && base.side() == own.side())
                        .filter(base -> base.round() == own.round())
                        .map(base -> base.median() / own.median()))
                .mapToDouble(Double::doubleValue)
                .sorted()
                .toArray();
        if (ratios.length == 0) {
            return "";
        }
        long faster = Arrays.stream(ratios).filter(ratio -> ratio > 1).count();
        return "Mesh files: faster than " + Results.BASE + " in " + faster + " of " + ratios.length + " pictures, "
                + number("%.2f", ratios[0]) + " to " + number("%.2f", ratios[ratios.length - 1]) + " times as fast, "
                + number("%.2f", median(ratios)) + " in the median.\n\n";
    }

    /** Returns a sentence about the time of whole processes. */
    private String startSummary() {
        List<String> times = new ArrayList<>();
        for (String contender :
                distinct(results.starts().stream().map(Results.Start::contender).toList())) {
            times.add(contender + " " + milliseconds(median(startTimes(contender))) + " ms");
        }
        return times.isEmpty()
                ? ""
                : "A process that renders a teapot to a file, from start to end: " + String.join("; ", times) + ".\n\n";
    }

    private double[] startTimes(String contender) {
        return sorted(results.starts().stream()
                .filter(start -> start.contender().equals(contender))
                .mapToDouble(Results.Start::time)
                .toArray());
    }

    private String facts() {
        List<List<String>> rows = new ArrayList<>();
        results.facts().forEach((name, value) -> rows.add(List.of(name, value)));
        return GeneratedPage.table(List.of("fact", "value"), rows);
    }

    private String pictures() {
        List<List<String>> rows = new ArrayList<>();
        for (Results.Picture picture : results.pictures()) {
            boolean hasColors = picture.unequal() >= 0;
            rows.add(List.of(
                    picture.scene(),
                    Integer.toString(picture.side()),
                    picture.contender(),
                    grouped(picture.covered()),
                    grouped(picture.oursOnly()),
                    grouped(picture.theirsOnly()),
                    hasColors ? grouped(picture.unequal()) : "",
                    hasColors ? number("%.3f", picture.mean()) : ""));
        }
        List<String> head = List.of(
                "scene",
                "raster",
                "renderer",
                "covered",
                "ours only",
                "theirs only",
                "other colour",
                "mean difference");
        return GeneratedPage.table(head, rows);
    }

    /** Returns a table for each raster and number of threads: medians, and how many times faster than the base. */
    private String times(Predicate<Results.Time> which) {
        StringBuilder text = new StringBuilder();
        for (Map.Entry<String, List<Results.Time>> group : groups(which).entrySet()) {
            List<Results.Time> times = group.getValue();
            List<String> scenes =
                    distinct(times.stream().map(Results.Time::scene).toList());
            List<String> head = new ArrayList<>(List.of(group.getKey()));
            head.addAll(scenes);
            List<List<String>> rows = new ArrayList<>();
            for (String contender :
                    distinct(times.stream().map(Results.Time::contender).toList())) {
                List<String> row = new ArrayList<>(List.of(contender));
                for (String scene : scenes) {
                    row.add(cell(times, scene, contender));
                }
                rows.add(row);
            }
            text.append(GeneratedPage.table(head, rows)).append('\n');
            Charts.fileName(times)
                    .ifPresent(name -> text.append("![Times faster than " + Results.BASE + ": ")
                            .append(group.getKey())
                            .append("](performance/")
                            .append(name)
                            .append(")\n\n"));
        }
        return text.toString();
    }

    /** Returns a table with a row for each scene and raster, and a column for each renderer. */
    private String rows(String title, Predicate<Results.Time> which) {
        List<Results.Time> all = results.times().stream().filter(which).toList();
        List<String> contenders =
                distinct(all.stream().map(Results.Time::contender).toList());
        List<String> head = new ArrayList<>(List.of(title, "raster"));
        head.addAll(contenders);
        List<List<String>> rows = new ArrayList<>();
        for (String scene : distinct(all.stream().map(Results.Time::scene).toList())) {
            for (int side : all.stream()
                    .filter(time -> time.scene().equals(scene))
                    .mapToInt(Results.Time::side)
                    .distinct()
                    .toArray()) {
                List<Results.Time> times =
                        all.stream().filter(time -> time.side() == side).toList();
                List<String> row = new ArrayList<>(List.of(scene, Integer.toString(side)));
                contenders.forEach(contender -> row.add(cell(times, scene, contender)));
                rows.add(row);
            }
        }
        return GeneratedPage.table(head, rows);
    }

    /**
     * Returns a table of anti-aliased pictures with a row for each scene and raster: the time of each renderer, how
     * many times faster than the base it is, and how many times as long as its picture with one sample a pixel takes.
     */
    private String smooth() {
        List<Results.Time> all =
                results.times().stream().filter(time -> time.samples() > 1).toList();
        List<String> contenders =
                distinct(all.stream().map(Results.Time::contender).toList());
        List<String> head = new ArrayList<>(List.of("scene, 1 thread", "raster"));
        head.addAll(contenders);
        List<List<String>> rows = new ArrayList<>();
        for (Results.Time base : all) {
            if (!base.contender().equals(contenders.get(0))) {
                continue;
            }
            List<Results.Time> times = results.times().stream()
                    .filter(time -> time.scene().equals(base.scene()) && time.side() == base.side())
                    .toList();
            List<String> row = new ArrayList<>(List.of(base.scene(), Integer.toString(base.side())));
            for (String contender : contenders) {
                String plain = contender.replace(Contender.PIXELS, "");
                String factor = times.stream()
                        .filter(time -> time.samples() == 1 && time.contender().equals(plain))
                        .flatMap(one -> times.stream()
                                .filter(time -> time.samples() > 1)
                                .filter(time -> time.contender().equals(contender))
                                .map(many -> number("; %.1f", many.median() / one.median())))
                        .findFirst()
                        .orElse("");
                row.add(cell(times.stream().filter(time -> time.samples() > 1).toList(), base.scene(), contender)
                        + factor);
            }
            rows.add(row);
        }
        return GeneratedPage.table(head, rows);
    }

    /** Groups times by raster and threads, in the order of measurement. */
    Map<String, List<Results.Time>> groups(Predicate<Results.Time> which) {
        Map<String, List<Results.Time>> groups = new LinkedHashMap<>();
        for (Results.Time time : results.times()) {
            if (which.test(time)) {
                String threads = time.threads() == 1 ? "1 thread" : time.threads() + " threads";
                String key = time.side() + " x " + time.side() + ", " + threads;
                groups.computeIfAbsent(key, none -> new ArrayList<>()).add(time);
            }
        }
        return groups;
    }

    private static String cell(List<Results.Time> times, String scene, String contender) {
        double[] own = medians(times, scene, contender);
        if (own.length == 0) {
            return "";
        }
        String cell = own.length == 1
                ? milliseconds(own[0])
                : milliseconds(median(own)) + " (" + milliseconds(own[0]) + ".." + milliseconds(own[own.length - 1])
                        + ")";
        double[] ratios = contender.equals(Results.BASE) ? new double[0] : ratios(times, scene, contender);
        return ratios.length == 0 ? cell : cell + ", **" + ratio(ratios) + "**";
    }

    /** Returns the medians of the rounds, in ascending order. */
    private static double[] medians(List<Results.Time> times, String scene, String contender) {
        return sorted(of(times, scene, contender).stream()
                .mapToDouble(Results.Time::median)
                .toArray());
    }

    /** Returns how many times faster than the base, per round, in ascending order; empty if one was not measured. */
    static double[] ratios(List<Results.Time> times, String scene, String contender) {
        List<Double> ratios = new ArrayList<>();
        for (Results.Time own : of(times, scene, contender)) {
            for (Results.Time base : of(times, scene, Results.BASE)) {
                if (base.round() == own.round()) {
                    ratios.add(base.median() / own.median());
                }
            }
        }
        return sorted(ratios.stream().mapToDouble(Double::doubleValue).toArray());
    }

    /** Returns the table of the speedup of two threads over one, for each scene and renderer that has both. */
    private String gain() {
        List<List<String>> rows = new ArrayList<>();
        List<Results.Time> all = results.times();
        for (int side : all.stream().mapToInt(Results.Time::side).distinct().toArray()) {
            for (String scene : distinct(all.stream().map(Results.Time::scene).toList())) {
                for (String contender :
                        distinct(all.stream().map(Results.Time::contender).toList())) {
                    double[] gains = all.stream()
                            .filter(one -> one.threads() == 1 && one.side() == side)
                            .filter(one ->
                                    one.scene().equals(scene) && one.contender().equals(contender))
                            .flatMap(one -> all.stream()
                                    .filter(two ->
                                            two.threads() == 2 && two.side() == side && two.round() == one.round())
                                    .filter(two -> two.scene().equals(scene)
                                            && two.contender().equals(contender))
                                    .map(two -> one.median() / two.median()))
                            .mapToDouble(Double::doubleValue)
                            .sorted()
                            .toArray();
                    if (gains.length > 0) {
                        rows.add(List.of(scene, Integer.toString(side), contender, ratio(gains)));
                    }
                }
            }
        }
        return GeneratedPage.table(List.of("scene", "raster", "renderer", "gain"), rows);
    }

    private String starts() {
        List<List<String>> rows = new ArrayList<>();
        for (String contender :
                distinct(results.starts().stream().map(Results.Start::contender).toList())) {
            double[] times = startTimes(contender);
            rows.add(List.of(
                    contender,
                    milliseconds(median(times)),
                    milliseconds(times[0]) + ".." + milliseconds(times[times.length - 1])));
        }
        return GeneratedPage.table(List.of("process", "median, ms", "least to greatest, ms"), rows);
    }

    static List<Results.Time> of(List<Results.Time> times, String scene, String contender) {
        return times.stream()
                .filter(time -> time.scene().equals(scene) && time.contender().equals(contender))
                .toList();
    }

    static List<String> distinct(List<String> all) {
        return all.stream().distinct().toList();
    }

    static double median(double[] ascending) {
        int middle = ascending.length / 2;
        return ascending.length % 2 == 1 ? ascending[middle] : (ascending[middle - 1] + ascending[middle]) / 2;
    }

    private static double[] sorted(double[] values) {
        Arrays.sort(values);
        return values;
    }

    private static String ratio(double[] ascending) {
        String middle = number("%.2f", median(ascending)) + " x";
        return ascending.length == 1
                ? middle
                : middle + " (" + number("%.2f", ascending[0]) + ".." + number("%.2f", ascending[ascending.length - 1])
                        + ")";
    }

    private static String milliseconds(double time) {
        return number(time < 10 ? "%.2f" : time < 100 ? "%.1f" : "%.0f", time);
    }

    private static String grouped(long count) {
        return number("%,d", count);
    }

    private static String number(String format, Object value) {
        return String.format(Locale.ROOT, format, value);
    }
}
