package example;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The code on the pages is that of this project. */
class PagesTest {
    private static final Pattern BLOCK = Pattern.compile("```java\n(.*?)\n```", Pattern.DOTALL);

    private static String read(Path path) {
        try {
            return Files.readString(path);
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private static List<Path> files(Path folder, String ending) throws IOException {
        try (Stream<Path> paths = Files.walk(folder)) {
            return paths.filter(it -> it.toString().endsWith(ending)).sorted().collect(Collectors.toList());
        }
    }

    /** The lines without their indentation. */
    private static String flat(String code) {
        return code.lines().map(String::strip).collect(Collectors.joining("\n"));
    }

    @Test
    void theCodeOnThePagesIsCompiled() throws IOException {
        String sources = files(Path.of("src"), ".java").stream()
                .map(it -> flat(read(it)))
                .collect(Collectors.joining("\n"));
        int blocks = 0;
        for (Path page : files(Path.of("../../docs/guides"), ".md")) {
            for (var found = BLOCK.matcher(read(page)); found.find(); blocks++) {
                assertTrue(sources.contains(flat(found.group(1))), page + ": not in src:\n" + found.group(1));
            }
        }
        assertTrue(blocks >= 10, "only " + blocks + " blocks");
    }
}
