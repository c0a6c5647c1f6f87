package dev.lazyz.jmh.stages;

import dev.lazyz.jmh.peers.TriangleSource;
import dev.lazyz.jmh.report.Options;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Measures what each stage of a frame takes, and what it has to take at least on this machine: {@code tiled}, one
 * thread. Writes a file of results and the tables of a page.
 *
 * <p>Each scene has a process of its own, {@link StageRun}, on one processor, with this process's Java runtime and its
 * options. So the command with {@code --add-modules jdk.incubator.vector} measures with the Vector API. Results of
 * other runtimes in the file of results are kept, with {@code --keep} also those of other scenes and sizes.
 */
public final class StageTable {
    private static final Set<String> OPTIONS = Set.of(
            "scenes",
            "models",
            "side",
            "processor",
            "warm-up",
            "measure",
            "record",
            "methods",
            "keep",
            "results",
            "page");

    private static final String SCENES = "S1,S2,S3,S5,S6,cycle,city,teapot";
    private static final Set<String> FORMATS = Set.of("obj", "stl", "ply", "off", "3mf", "glb", "gltf");

    /** Maximum time of a process; longer than any should take. */
    private static final long MINUTES = 5;

    private final Options options;

    private StageTable(Options options) {
        this.options = options;
    }

    /** Options: see {@code jmh/README.md}. */
    public static void main(String[] args) throws IOException, InterruptedException {
        new StageTable(new Options(args, OPTIONS)).run();
    }

    private void run() throws IOException, InterruptedException {
        Path file = Path.of(options.get("results", "docs/performance/stages.json"));
        StageResults results = Files.exists(file) ? StageResults.read(file) : StageResults.empty();
        String jvm = StageResults.jvm();
        if (!Boolean.parseBoolean(options.get("keep", "false"))) {
            results.remove(jvm);
        }
        results.facts().put(jvm, LocalDate.now() + ", Java " + Runtime.version() + ", " + processorName());
        process(List.of(), results);
        for (String scene : scenes()) {
            String side = options.get("side", "1024");
            results.remove(jvm, TriangleSource.label(scene), Integer.parseInt(side));
            List<String> words = new ArrayList<>(List.of("--scene", scene, "--side", side));
            words.addAll(List.of("--warm-up", options.get("warm-up", "2")));
            words.addAll(List.of("--measure", options.get("measure", "3")));
            words.addAll(List.of("--record", options.get("record", "4")));
            words.addAll(List.of("--methods", options.get("methods", "0")));
            process(words, results);
            print(results, jvm, TriangleSource.label(scene), Integer.parseInt(side));

            // If a long run is stopped, the results so far are kept
            results.write(file);
        }
        process(List.of(), results);
        results.write(file);
        Path page = Path.of(options.get("page", "docs/performance-stages.md"));
        if (Files.exists(page)) {
            StagePage.write(page, results);
        }
    }

    private List<String> scenes() throws IOException {
        List<String> scenes = new ArrayList<>(options.list("scenes", SCENES));
        String folder = options.get("models", "");
        if (!folder.isEmpty()) {
            try (Stream<Path> files = Files.list(Path.of(folder))) {
                files.filter(StageTable::isModel).sorted().map(Path::toString).forEach(scenes::add);
            }
        }
        return scenes;
    }

    private static boolean isModel(Path file) {
        String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
        return FORMATS.contains(name.substring(name.lastIndexOf('.') + 1));
    }

    private static void print(StageResults results, String jvm, String scene, int side) {
        for (StageResults.FrameTime frame : results.frames()) {
            if (frame.jvm().equals(jvm) && frame.scene().equals(scene) && frame.side() == side) {
                StringBuilder line = new StringBuilder();
                for (Stage stage : Stage.values()) {
                    line.append(String.format(Locale.ROOT, "  %s %.2f", stage.label(), results.time(frame, stage)));
                }
                System.out.printf(Locale.ROOT, "%-16s %8.2f ms %s%n", scene, frame.time(), line);
            }
        }
    }

    /** Starts {@link StageRun} on one processor, and adds what it prints. */
    private void process(List<String> arguments, StageResults results) throws IOException, InterruptedException {
        List<String> words = new ArrayList<>(List.of("taskset", "-c", options.get("processor", "1")));
        words.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        words.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());

        // So that the profiler finds methods between the points where the JVM can stop a thread, too
        words.addAll(List.of("-XX:+UnlockDiagnosticVMOptions", "-XX:+DebugNonSafepoints"));
        words.addAll(List.of("-cp", System.getProperty("java.class.path"), StageRun.class.getName()));
        words.addAll(arguments);
        Path output = Files.createTempFile("lazyz-stages-", ".txt");
        try {
            Process process = new ProcessBuilder(words)
                    .redirectOutput(output.toFile())
                    .redirectError(ProcessBuilder.Redirect.INHERIT)
                    .start();
            if (!process.waitFor(MINUTES, TimeUnit.MINUTES) || process.exitValue() != 0) {
                process.destroyForcibly();
                throw new IllegalStateException("failed: " + String.join(" ", words));
            }
            try (Stream<String> lines = Files.lines(output, StandardCharsets.UTF_8)) {
                lines.filter(line -> line.contains(" {")).forEach(results::add);
            }
        } finally {
            Files.delete(output);
        }
    }

    private static String processorName() throws IOException {
        Path info = Path.of("/proc/cpuinfo");
        if (!Files.exists(info)) {
            return System.getProperty("os.arch");
        }
        try (Stream<String> lines = Files.lines(info)) {
            return lines.filter(line -> line.startsWith("model name"))
                    .map(line -> line.substring(line.indexOf(':') + 1).trim())
                    .findFirst()
                    .orElse(System.getProperty("os.arch"));
        }
    }
}
