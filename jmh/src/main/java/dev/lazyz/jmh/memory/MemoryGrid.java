package dev.lazyz.jmh.memory;

import dev.lazyz.Renderer;
import dev.lazyz.StreamingRenderer;
import dev.lazyz.jmh.large.Hills;
import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.jmh.report.Options;
import dev.lazyz.strategies.Renderers;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Checks the promise of {@code zcli render --memory}: renders scenes in several sizes to several formats with several
 * amounts of memory, each in a JVM with a heap of that size. Each picture must have the same hash as without a limit,
 * or be refused before it is rendered. Prints tables, and writes them into a page. Fails if a cell fails.
 *
 * <p>{@code java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.memory.MemoryGrid}
 *
 * <p>Options: {@code --jar}, that of zcli; {@code --page}; {@code --memory}, mebibytes, repeated; {@code --java}, an
 * option of Java, repeated; {@code --seconds}, the longest time of a cell; {@code --formats}, of pictures, png,ppm,dzi;
 * {@code --tables}, by default both: {@code grid} of the default strategy, and {@code strategies}.
 */
public final class MemoryGrid {
    private static final List<List<String>> SIZES = List.of(
            List.of("--size", "640x480"),
            List.of("--size", "3000x3000", "--aa", "1"),
            List.of("--size", "20000x400", "--aa", "1"));

    /** Mebibytes; other strategies than the default one need more. */
    private static final List<String> AMOUNTS = List.of("16", "32", "64", "128", "256");

    private static final List<String> MORE = List.of("32", "64", "128", "256", "512", "1024");

    private final Path jar;
    private final List<String> javaOptions;
    private final int seconds;
    private final List<String> formats;
    private final Path folder;
    private int failed;
    private int rendered;
    private int refused;

    private MemoryGrid(Path jar, List<String> javaOptions, int seconds, List<String> formats, Path folder) {
        this.jar = jar;
        this.javaOptions = javaOptions;
        this.seconds = seconds;
        this.formats = formats;
        this.folder = folder;
    }

    public static void main(String[] args) throws IOException, InterruptedException {
        Options options = new Options(args, Set.of("jar", "page", "memory", "java", "seconds", "formats", "tables"));
        Path folder = Files.createTempDirectory("memory-grid");
        MemoryGrid grid = new MemoryGrid(
                Path.of(options.get("jar", "cli/target/zcli.jar")),
                options.all("java"),
                Integer.parseInt(options.get("seconds", "120")),
                options.list("formats", "png,ppm,dzi"),
                folder);
        try {
            Map<String, String> tables = new HashMap<>();
            for (String table : options.list("tables", "grid,strategies")) {
                boolean isGrid = table.equals("grid");
                List<String> amounts = options.all("memory");
                if (amounts.isEmpty()) {
                    amounts = isGrid ? AMOUNTS : MORE;
                }
                tables.put(
                        table,
                        grid.table(
                                isGrid ? grid.inputs() : grid.strategies(),
                                amounts.stream().map(Integer::valueOf).toList()));
            }
            System.out.printf(
                    "%d rendered with the same hash, %d refused, %d failed%n",
                    grid.rendered, grid.refused, grid.failed);
            Path page = Path.of(options.get("page", "docs/memory.md"));
            if (Files.exists(page)) {
                GeneratedPage.update(page, tables::get);
            }
        } finally {
            delete(folder);
        }
        System.exit(grid.failed == 0 ? 0 : 1);
    }

    /** Returns what is rendered, by its name in the table. */
    private Map<String, List<String>> inputs() throws IOException {
        Map<String, List<String>> inputs = new LinkedHashMap<>();
        for (String builtIn : List.of("teapot", "city")) {
            inputs.put(builtIn, List.of(builtIn));
        }
        String small = hills(100_000);
        String large = hills(1_000_000);
        inputs.put("100,000 triangles", List.of(small));
        inputs.put("1 million, `--shading flat`", List.of(large, "--shading", "flat"));
        inputs.put("1 million, `--stream`", List.of(large, "--stream"));
        return inputs;
    }

    /** Returns what is rendered with each strategy but the default one. */
    private Map<String, List<String>> strategies() throws IOException {
        Map<String, List<String>> inputs = new LinkedHashMap<>();
        String large = hills(1_000_000);
        for (Renderer renderer : Renderers.getBuiltIn()) {
            String id = renderer.getId();
            if (!id.equals("tiled")) {
                inputs.put("teapot, `" + id + "`", List.of("teapot", "--strategy", id));
            }
        }
        for (Renderer renderer : Renderers.getBuiltIn()) {
            String id = renderer.getId();
            if (renderer instanceof StreamingRenderer && !id.equals("tiled")) {
                inputs.put("1 million, `--stream`, `" + id + "`", List.of(large, "--stream", "--strategy", id));
            }
        }
        return inputs;
    }

    private String hills(int triangles) throws IOException {
        Path file = folder.resolve(triangles + ".stl");
        Hills.write(file, triangles, "stl");
        return file.toString();
    }

    private String table(Map<String, List<String>> inputs, List<Integer> amounts)
            throws IOException, InterruptedException {
        List<String> head = new ArrayList<>(List.of("input"));
        SIZES.forEach(size -> head.add(String.join(" ", size.subList(1, size.size()))));
        List<List<String>> rows = new ArrayList<>();
        for (Map.Entry<String, List<String>> input : inputs.entrySet()) {
            List<String> row = new ArrayList<>(List.of(input.getKey()));
            for (List<String> size : SIZES) {
                row.add(least(input.getValue(), size, amounts));
            }
            rows.add(row);
            System.out.println(String.join(" | ", row));
        }
        return GeneratedPage.table(head, rows);
    }

    /** Returns the least amount from which on the picture is rendered in all formats; a dash if there is none. */
    private String least(List<String> input, List<String> size, List<Integer> amounts)
            throws IOException, InterruptedException {
        String expected = expected(input, size);
        String least = "–";
        for (int amount : amounts) {
            if (!isRendered(input, size, amount, expected)) {
                least = "–";
            } else if (least.equals("–")) {
                least = amount + " MiB";
            }
        }
        return least;
    }

    /** Returns the hash of the picture without a limit. */
    private String expected(List<String> input, List<String> size) throws IOException, InterruptedException {
        Path picture = folder.resolve("expected.ppm");
        ForkedRendering free = ForkedRendering.run(jar, List.of(), 3000, words(input, size, picture), seconds);
        if (free.pixelHash().isEmpty()) {
            throw new IllegalStateException(input + " cannot be rendered: " + free.errors());
        }
        Files.delete(picture);
        return free.pixelHash();
    }

    /** Returns whether the picture is rendered in all formats. A failure is printed and counted. */
    private boolean isRendered(List<String> input, List<String> size, int amount, String expected)
            throws IOException, InterruptedException {
        boolean isEach = true;
        for (String format : formats) {
            Path picture = folder.resolve("picture." + format);
            List<String> words = words(input, size, picture);
            words.addAll(List.of("--memory", amount + "m"));
            ForkedRendering run = ForkedRendering.run(jar, javaOptions, amount, words, seconds);
            boolean isRefused =
                    run.code() == 2 && run.errors().contains(", and --memory allows ") && !Files.exists(picture);
            if (run.code() == 0 && run.pixelHash().equals(expected)) {
                rendered++;
            } else if (isRefused) {
                refused++;
                isEach = false;
            } else {
                failed++;
                isEach = false;
                System.out.println(String.join(" ", words) + ": code " + run.code() + ", " + run.errors());
            }
            delete(picture);
            delete(folder.resolve("picture_files"));
        }
        return isEach;
    }

    private static List<String> words(List<String> input, List<String> size, Path picture) {
        List<String> words = new ArrayList<>(input);
        words.addAll(size);
        words.addAll(List.of("-o", picture.toString()));
        return words;
    }

    private static void delete(Path path) throws IOException {
        if (!Files.exists(path)) {
            return;
        }
        try (Stream<Path> all = Files.walk(path)) {
            for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(each);
            }
        }
    }
}
