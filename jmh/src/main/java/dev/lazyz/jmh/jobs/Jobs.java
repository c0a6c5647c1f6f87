package dev.lazyz.jmh.jobs;

import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.jmh.report.Options;
import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Measures whole jobs, from mesh file to PNG file, of Lazy Z and of VTK, in two warm processes that run alternately
 * on the same processor. {@code peers/whole-job} starts it.
 */
public final class Jobs {
    private static final Set<String> OPTIONS =
            Set.of("ours", "vtk", "files", "rounds", "warm-up", "measure", "results", "page", "fact");

    private Jobs() {}

    /** Options: see {@code peers/whole-job}. */
    public static void main(String[] args) throws IOException {
        Options options = new Options(args, OPTIONS);
        JobResults results = new JobResults(facts(options), new ArrayList<>());
        List<String> files = options.list("files", "");
        String warmUp = options.get("warm-up", "9");
        String measure = options.get("measure", "4");
        int rounds = Integer.parseInt(options.get("rounds", "3"));
        try (Worker ours = new Worker(JobResults.OURS, options.get("ours", ""));
                Worker theirs = new Worker(JobResults.VTK, options.get("vtk", ""))) {
            for (String file : files) {
                ours.job(file, warmUp, 0);
                theirs.job(file, "1", 0);
            }
            for (int round = 1; round <= rounds; round++) {
                for (String file : files) {
                    for (Worker worker : List.of(ours, theirs)) {
                        JobResults.Job job = worker.job(file, measure, round);
                        if (job.count() > 0) {
                            results.jobs().add(job);
                        }
                    }
                }
            }
        }
        Files.writeString(Path.of(options.get("results", "jobs.json")), results.toJson());
        Path page = Path.of(options.get("page", "docs/performance.md"));
        GeneratedPage.update(page, results::fill);
    }

    private static Map<String, String> facts(Options options) {
        Map<String, String> facts = new LinkedHashMap<>();
        for (String fact : options.all("fact")) {
            int at = fact.indexOf('=');
            facts.put(fact.substring(0, at), fact.substring(at + 1));
        }
        facts.put("date", LocalDate.now().toString());
        return facts;
    }

    /** A process that performs jobs on request. */
    private static final class Worker implements AutoCloseable {
        private final String name;
        private final Process process;
        private final BufferedWriter requests;
        private final BufferedReader responses;

        Worker(String name, String command) throws IOException {
            List<String> words = new ArrayList<>(List.of("taskset", "-c", "0"));
            words.addAll(List.of(command.trim().split(" +")));
            ProcessBuilder builder = new ProcessBuilder(words).redirectError(ProcessBuilder.Redirect.INHERIT);
            builder.environment().put("LP_NUM_THREADS", "1");
            builder.environment().put("GALLIUM_DRIVER", "llvmpipe");
            builder.environment().put("LIBGL_ALWAYS_SOFTWARE", "1");
            this.name = name;
            process = builder.start();
            requests = process.outputWriter(StandardCharsets.UTF_8);
            responses = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        }

        /** Lets the process perform jobs for some seconds, and returns the shortest. */
        JobResults.Job job(String file, String seconds, int round) throws IOException {
            requests.write(seconds + " " + file + "\n");
            requests.flush();
            String response = responses.readLine();
            if (response == null) {
                throw new IOException(name + " ended at " + file);
            }
            String[] words = response.split(" ");
            return new JobResults.Job(
                    Path.of(file).getFileName().toString(),
                    name,
                    round,
                    Integer.parseInt(words[0]),
                    Double.parseDouble(words[1]),
                    Double.parseDouble(words[2]),
                    Double.parseDouble(words[3]));
        }

        @Override
        public void close() throws IOException {
            requests.close();
            process.destroy();
        }
    }
}
