package dev.lazyz.jmh;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Measures the phases of one zcli process, from its start to a finished PNG, and prints a table in Markdown.
 *
 * <p>A phase begins when Java loads the first class that the phase needs, according to Java's class loading log; zcli
 * itself is not changed. Runs alternate; a figure is the median of the rounds. Encoding is the difference to a run
 * that writes a PPM file instead, because encoding runs while rows arrive. Arguments: the path of {@code zcli.jar},
 * and Java home directories. If the script {@code zcli} is next to the jar, its starts from a class data archive are
 * also measured.
 */
public final class ColdStartPhases {
    private static final int ROUNDS = 9;
    private static final List<String> JOB = List.of("render", "teapot", "--size", "256x256", "-o");

    /** Phases, with the class whose loading ends each phase; the last phase ends with the process. */
    private static final Map<String, String> PHASES = new LinkedHashMap<>();

    static {
        PHASES.put("JVM", "dev.lazyz.cli.MainKt");
        PHASES.put("command line", "dev.lazyz.cli.render.RenderJob");
        PHASES.put("scene", "dev.lazyz.setup.PlanarSetUp");
        PHASES.put("set-up", "dev.lazyz.cli.output.Tally");
        PHASES.put("render, encode", "java.lang.Shutdown");
        PHASES.put("exit", "");
    }

    private final Path folder;

    private ColdStartPhases(Path folder) {
        this.folder = folder;
    }

    /** Arguments: see above. */
    public static void main(String[] args) throws IOException, InterruptedException {
        if (args.length < 2) {
            throw new IllegalArgumentException("the path of zcli.jar and at least one home of Java are needed");
        }
        Path folder = Files.createTempDirectory("zcli-");
        try {
            Path jar = Path.of(args[0]).toAbsolutePath();
            new ColdStartPhases(folder).run(jar, Arrays.copyOfRange(args, 1, args.length));
        } finally {
            try (Stream<Path> files = Files.list(folder)) {
                for (Path file : files.toList()) {
                    Files.delete(file);
                }
            }
            Files.delete(folder);
        }
    }

    private void run(Path jar, String... homes) throws IOException, InterruptedException {
        Path script = jar.resolveSibling("zcli");
        Map<String, List<double[]>> rows = new LinkedHashMap<>();
        for (int round = 0; round <= ROUNDS; round++) {
            for (String home : homes) {
                measure(rows, home, "java -jar", List.of(home + "/bin/java", log(), "-jar", jar.toString()));
                if (Files.exists(script)) {
                    measure(rows, home, "archive", List.of("/bin/sh", script.toString()));
                }
            }
        }
        System.out.println(
                "| start | " + String.join(" | ", PHASES.keySet()) + " | whole | of it PNG | classes | not archived |");
        System.out.println("|---" + "|---".repeat(PHASES.size() + 4) + "|");
        rows.forEach((name, values) -> {
            StringBuilder line = new StringBuilder("| " + name);
            // The first round fills caches and creates the archive
            List<double[]> counted = values.subList(1, values.size());
            for (int column = 0; column < counted.get(0).length; column++) {
                int at = column;
                double[] sorted =
                        counted.stream().mapToDouble(row -> row[at]).sorted().toArray();
                line.append(String.format(Locale.ROOT, " | %.0f", sorted[sorted.length / 2]));
            }
            System.out.println(line + " |");
        });
    }

    private void measure(Map<String, List<double[]>> rows, String home, String how, List<String> start)
            throws IOException, InterruptedException {
        double[] row = new double[PHASES.size() + 4];
        double whole = process(home, start, "picture.png");
        double previous = 0;
        int column = 0;
        List<String> log = Files.readAllLines(logFile());
        for (String mark : PHASES.values()) {
            double end = mark.isEmpty() ? whole : loaded(log, mark);
            row[column++] = end - previous;
            previous = end;
        }
        row[column++] = whole;
        row[column + 1] = log.size();
        row[column + 2] = log.stream()
                .filter(line -> !line.contains("shared objects file"))
                .count();
        row[column] = whole - process(home, start, "picture.ppm");
        rows.computeIfAbsent(version(home) + ", " + how, name -> new ArrayList<>())
                .add(row);
    }

    /** Runs zcli, and returns the time in milliseconds. */
    private double process(String home, List<String> start, String picture) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(start);
        command.addAll(JOB);
        Path file = folder.resolve(picture);
        command.add(file.toString());
        ProcessBuilder builder = new ProcessBuilder(command).inheritIO();
        builder.environment().put("JAVA_HOME", home);
        builder.environment().put("ZCLI_CACHE", folder.toString());
        builder.environment().put("ZCLI_JAVA_OPTIONS", log());
        Files.deleteIfExists(file);
        long begin = System.nanoTime();
        Process process = builder.start();
        if (!process.waitFor(1, TimeUnit.MINUTES) || process.exitValue() != 0 || !Files.exists(file)) {
            process.destroyForcibly();
            throw new IllegalStateException("failed: " + String.join(" ", command));
        }
        return (System.nanoTime() - begin) / 1e6;
    }

    private String log() {
        return "-Xlog:class+load:file=" + logFile() + ":uptimenanos";
    }

    private Path logFile() {
        return folder.resolve("classes.txt");
    }

    /** Returns the milliseconds from the JVM's start until it loaded the class. */
    private static double loaded(List<String> log, String name) {
        String line = log.stream()
                .filter(entry -> entry.contains("ns] " + name + " "))
                .findFirst()
                .orElseThrow(() -> new IllegalStateException("not loaded, or renamed: " + name));
        return Long.parseLong(line.substring(1, line.indexOf("ns]"))) / 1e6;
    }

    private static String version(String home) throws IOException {
        return Files.readAllLines(Path.of(home, "release")).stream()
                .filter(line -> line.startsWith("JAVA_VERSION="))
                .map(line -> "JDK " + line.substring(line.indexOf('"') + 1).split("[.\"]")[0])
                .findFirst()
                .orElse(home);
    }
}
