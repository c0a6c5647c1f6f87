package dev.lazyz.jmh.peers;

import dev.lazyz.jmh.report.Measurements;
import dev.lazyz.jmh.report.Options;
import dev.lazyz.jmh.workload.Triangles;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.world.camera.Projection;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import kotlinx.serialization.json.Json;
import kotlinx.serialization.json.JsonElementKt;
import kotlinx.serialization.json.JsonObject;

/**
 * Measures Lazy Z and other renderers alternately: round by round, scene by scene, one process after the other, each
 * pinned to its own processors. {@code peers/run} starts it.
 *
 * <p>First the image of every other renderer is compared with Lazy Z's; if a renderer covers other samples, its times
 * are for different work.
 *
 * <p>All of this is done with the first raster. Further rasters, and mesh files, are measured once, with Lazy Z,
 * llvmpipe and GLimpSW on one thread, because everything would take more than a day. So are lit scenes, with one
 * sample a pixel and with {@value #SAMPLES} x {@value #SAMPLES}, or 4 for llvmpipe, which has no more.
 *
 * <p>With {@code --keep}, the file of results exists already, and results of other scenes and of whole processes are
 * kept.
 */
public final class SideBySide {
    private static final Set<String> OPTIONS = Set.of(
            "llvmpipe",
            "glimpsw",
            "euc",
            "vtk",
            "jmol",
            "ours",
            "cold",
            "scenes",
            "others",
            "sides",
            "other-sides",
            "meshes",
            "lit",
            "threads",
            "rounds",
            "warm-up",
            "measure",
            "results",
            "keep",
            "fact");

    /** The renderer that others are compared with. */
    static final String BASE = "llvmpipe";

    /** Wall-clock time of a frame in steady state: the median of the frames of a process. */
    static final String TIME = "frame ms";

    /** Wall-clock time of a process that renders one small image, from its start to its end. */
    static final String START = "process ms";

    /** The scene of the processes that are timed from start to end. */
    static final String COLD_SCENE = "teapot";

    /** Samples a pixel of anti-aliased pictures, along each side of the pixel. */
    static final int SAMPLES = 4;

    /** Maximum time of a process; longer than any should take. */
    private static final long MINUTES = 10;

    private final Options options;
    private final Path folder;
    private final Measurements results;
    private final List<Contender> contenders = new ArrayList<>();
    private final Map<String, Triangles> triangles = new HashMap<>();

    private SideBySide(Options options, Path folder, Measurements results) {
        this.options = options;
        this.folder = folder;
        this.results = results;
        for (String command : options.all("llvmpipe")) {
            contenders.add(Contender.parse(Contender.Kind.LLVMPIPE, BASE + "=" + command));
            contenders.add(Contender.parse(Contender.Kind.LLVMPIPE_VISIBILITY, BASE + " for visibility=" + command));
        }
        options.all("glimpsw")
                .forEach(command -> contenders.add(Contender.parse(Contender.Kind.GLIMPSW, "GLimpSW=" + command)));
        options.all("euc").forEach(command -> contenders.add(Contender.parse(Contender.Kind.EUC, "euc=" + command)));
        options.all("vtk").forEach(command -> contenders.add(Contender.parse(Contender.Kind.VTK, "VTK=" + command)));
        options.all("jmol").forEach(command -> contenders.add(Contender.parse(Contender.Kind.JMOL, "Jmol=" + command)));
        options.all("ours").forEach(text -> contenders.add(Contender.parse(Contender.Kind.OURS, text)));
    }

    /** Options: see {@code jmh/README.md}. */
    public static void main(String[] args) throws IOException, InterruptedException {
        Options options = new Options(args, OPTIONS);
        Path output = Path.of(options.get("results", "results.csv"));
        boolean isKept = Boolean.parseBoolean(options.get("keep", "false"));
        Measurements results = isKept ? Measurements.read(output) : new Measurements();
        Path folder = Files.createTempDirectory("lazyz-peers-");
        try {
            new SideBySide(options, folder, results).run(output, !isKept);
        } finally {
            for (Path file : Files.list(folder).toList()) {
                Files.delete(file);
            }
            Files.delete(folder);
        }
    }

    private void run(Path file, boolean isWhole) throws IOException, InterruptedException {
        List<String> lit = options.list("lit", "").stream()
                .map(name -> TriangleSource.LIT + name)
                .toList();
        List<String> compared = options.list("scenes", String.join(",", Workloads.COMPARED));
        List<String> others = options.list("others", "");
        List<String> meshes = options.list("meshes", "");
        List<Integer> sides = integers("sides", "1024");
        List<Integer> otherSides = integers("other-sides", "1024");
        List<Integer> threads = integers("threads", "1,2");
        results.noteMachine(options);
        for (List<String> scenes : List.of(compared, others, meshes, lit)) {
            for (String scene : scenes) {
                export(scene);
            }
        }
        comparePictures(compared, sides.get(0), contender -> true);
        comparePictures(others, otherSides.get(0), contender -> true);
        int rounds = Integer.parseInt(options.get("rounds", "3"));
        for (int round = 1; round <= rounds; round++) {
            if (isWhole) {
                start(round);
            }
            measure(compared, sides.get(0), threads, round, file, contender -> true);
            measure(others, otherSides.get(0), threads, round, file, contender -> true);
        }
        for (int side : sides.subList(1, sides.size())) {
            measureOnce(compared, side, file);
        }
        for (int side : otherSides.subList(1, otherSides.size())) {
            measureOnce(others, side, file);
        }
        for (int side : otherSides) {
            measureOnce(meshes, side, file);
        }
        for (int side : otherSides) {
            measureOnce(lit, side, file);
            measureSmooth(lit, side, file);
        }
    }

    private void measureOnce(List<String> scenes, int side, Path file) throws IOException, InterruptedException {
        comparePictures(scenes, side, Contender::isOfAllScenes);
        measure(scenes, side, List.of(1), 1, file, Contender::isOfAllScenes);
    }

    /** Measures anti-aliased pictures of scenes once. */
    private void measureSmooth(List<String> scenes, int side, Path file) throws IOException, InterruptedException {
        for (String scene : scenes) {
            for (Contender contender : contenders) {
                if (contender.hasSamples() && canDraw(contender, scene, 1)) {
                    measure(contender, scene, side, SAMPLES, 1, 1);
                }
            }
            results.write(file);
        }
    }

    private List<Integer> integers(String name, String otherwise) {
        return options.list(name, otherwise).stream().map(Integer::valueOf).toList();
    }

    private void export(String scene) throws IOException {
        Triangles exported = TriangleSource.find(scene);
        exported.write(file(scene));
        triangles.put(scene, exported);
        String label = TriangleSource.label(scene);
        results.removeIf(value -> value.subject().startsWith(label + "; "));
    }

    private Path file(String scene) {
        return folder.resolve(TriangleSource.label(scene) + ".triangles");
    }

    private boolean canDraw(Contender contender, String scene, int threads) {
        Triangles drawn = triangles.get(scene);
        boolean isPerspective = drawn.scene().camera(1, 1).getProjection() instanceof Projection.Perspective;
        return contender.canDraw(drawn, isPerspective, threads);
    }

    /**
     * Draws each scene once with every contender that can. All JVMs give the same bits, so only one Lazy Z contender
     * draws.
     */
    private void comparePictures(List<String> scenes, int side, Predicate<Contender> which)
            throws IOException, InterruptedException {
        Contender ours = contenders.stream()
                .filter(contender -> contender.kind() == Contender.Kind.OURS)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("--ours is needed"));
        Path ourPicture = folder.resolve("ours.picture");
        Path theirPicture = folder.resolve("theirs.picture");
        for (String scene : scenes) {
            addPicture(ours, scene, side, ourPicture, ourPicture);
            for (Contender contender : contenders) {
                if (contender.kind() != Contender.Kind.OURS && which.test(contender) && canDraw(contender, scene, 1)) {
                    addPicture(contender, scene, side, ourPicture, theirPicture);
                }
            }
        }
    }

    private JsonObject drawn(Contender contender, String scene, int side, Path picture)
            throws IOException, InterruptedException {
        List<String> command = contender.drawing(scene, file(scene).toString(), side, 1, 1);
        command.addAll(List.of("--picture", picture.toString()));
        return process(command, 1);
    }

    private void addPicture(Contender contender, String scene, int side, Path ours, Path theirs)
            throws IOException, InterruptedException {
        JsonObject printed = drawn(contender, scene, side, theirs);
        if (printed == null) {
            return;
        }
        SampleDifference difference = SampleDifference.of(ours, theirs);
        String subject = new PeerScene(TriangleSource.label(scene), side, 1, 1).toString();
        results.add("samples covered", subject, contender.name(), 0, number(printed, "covered"));
        results.add("samples of ours only", subject, contender.name(), 0, difference.oursOnly());
        results.add("samples of theirs only", subject, contender.name(), 0, difference.theirsOnly());
        if (contender.isSrgb()) {
            results.add("samples of other colour", subject, contender.name(), 0, difference.unequal());
            results.add("mean difference of 255", subject, contender.name(), 0, difference.mean());
        }
    }

    private void measure(
            List<String> scenes, int side, List<Integer> threads, int round, Path file, Predicate<Contender> which)
            throws IOException, InterruptedException {
        for (String scene : scenes) {
            for (int count : threads) {
                for (Contender contender : contenders) {
                    if (which.test(contender) && canDraw(contender, scene, count)) {
                        measure(contender, scene, side, 1, count, round);
                    }
                }
            }

            // If a long run is stopped, the results so far are kept
            results.write(file);
        }
    }

    private void measure(Contender contender, String scene, int side, int samples, int threads, int round)
            throws IOException, InterruptedException {
        List<String> command = contender.drawing(scene, file(scene).toString(), side, samples, threads);
        command.addAll(List.of("--warm-up", options.get("warm-up", "3"), "--measure", options.get("measure", "4")));
        JsonObject printed = process(command, threads);
        if (printed == null) {
            return;
        }
        PeerScene subject = new PeerScene(TriangleSource.label(scene), side, samples, threads);
        results.add(TIME, subject.toString(), contender.name(), round, number(printed, "median"));
        results.facts()
                .put(
                        "version of " + contender.name(),
                        JsonElementKt.getJsonPrimitive(printed.get("version")).getContent());
    }

    private static double number(JsonObject printed, String name) {
        return JsonElementKt.getDouble(JsonElementKt.getJsonPrimitive(printed.get(name)));
    }

    /** Times whole processes, from start to end, that render one image to a file. */
    private void start(int round) throws IOException, InterruptedException {
        for (String text : options.all("cold")) {
            Contender contender = Contender.parse(Contender.Kind.OURS, text);
            Path picture = folder.resolve("cold.png");
            List<String> command = contender.command().stream()
                    .map(word -> word.equals("PICTURE") ? picture.toString() : word)
                    .map(word -> word.equals("TRIANGLES") ? coldFile() : word)
                    .toList();
            long begin = System.nanoTime();
            Process process = Contender.builder(command, Runtime.getRuntime().availableProcessors())
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            if (!process.waitFor(MINUTES, TimeUnit.MINUTES) || process.exitValue() != 0 || !Files.exists(picture)) {
                process.destroyForcibly();
                System.err.println("failed: " + String.join(" ", command));
                continue;
            }
            double time = (System.nanoTime() - begin) / 1e6;
            Files.delete(picture);
            results.add(START, COLD_SCENE, contender.name(), round, time);
        }
    }

    private String coldFile() {
        Path file = file(COLD_SCENE);
        try {
            if (!Files.exists(file)) {
                TriangleSource.find(COLD_SCENE).write(file);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return file.toString();
    }

    /**
     * Runs a program on as many processors as it has threads; returns the JSON that it printed, or null if it failed.
     */
    private JsonObject process(List<String> command, int threads) throws IOException, InterruptedException {
        Path output = folder.resolve("output");
        Process process = Contender.builder(command, threads)
                .redirectOutput(output.toFile())
                .start();
        boolean hasEnded = process.waitFor(MINUTES, TimeUnit.MINUTES);
        String printed = Files.readString(output, StandardCharsets.UTF_8).trim();
        if (!hasEnded || process.exitValue() != 0) {
            process.destroyForcibly();
            System.err.println("failed: " + String.join(" ", command));
            return null;
        }
        return JsonElementKt.getJsonObject(
                Json.Default.parseToJsonElement(printed.substring(printed.lastIndexOf('\n') + 1)));
    }
}
