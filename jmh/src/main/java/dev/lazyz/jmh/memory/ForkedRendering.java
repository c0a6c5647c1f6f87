package dev.lazyz.jmh.memory;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * One run of {@code zcli render} in a JVM of its own.
 *
 * @param code the exit code, or -1 if it took too long
 * @param pixelHash the hash of the picture, or nothing
 * @param errors standard error
 */
record ForkedRendering(int code, String pixelHash, String errors) {
    private static final Pattern HASH = Pattern.compile("\"pixelHash\":\"(\\w+)\"");

    /** Runs zcli with a heap of {@code mebibytes}. */
    static ForkedRendering run(Path jar, List<String> javaOptions, int mebibytes, List<String> words, int seconds)
            throws IOException, InterruptedException {
        Path output = Files.createTempFile("memory", ".txt");
        Path errors = Files.createTempFile("memory", ".txt");
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(javaOptions);
        command.addAll(List.of("-Xmx" + mebibytes + "m", "-jar", jar.toString(), "render"));
        command.addAll(words);
        command.add("--stats=json");
        try {
            Process process = new ProcessBuilder(command)
                    .redirectInput(new File("/dev/null"))
                    .redirectOutput(output.toFile())
                    .redirectError(errors.toFile())
                    .start();
            boolean isOver = process.waitFor(seconds, TimeUnit.SECONDS);
            if (!isOver) {
                process.destroyForcibly().waitFor();
            }
            Matcher hash = HASH.matcher(Files.readString(output));
            return new ForkedRendering(
                    isOver ? process.exitValue() : -1, hash.find() ? hash.group(1) : "", Files.readString(errors));
        } finally {
            Files.delete(output);
            Files.delete(errors);
        }
    }
}
