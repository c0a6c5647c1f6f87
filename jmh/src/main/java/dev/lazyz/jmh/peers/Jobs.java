package dev.lazyz.jmh.peers;

import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.jmh.report.Measurements;
import dev.lazyz.jmh.report.Options;
import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;

/**
 * Measures whole jobs, from mesh file to PNG file, of Lazy Z and of VTK, in two warm processes that run alternately
 * on the same processor. {@code peers/whole-job} starts it.
 */
public final class Jobs {
    private static final Set<String> OPTIONS =
            Set.of("ours", "vtk", "files", "rounds", "warm-up", "measure", "results", "fact");

    static final String OURS = "Lazy Z";
    static final String VTK = "VTK";

    /** Wall-clock time of the shortest job of a round, from file to file. */
    static final String TOTAL = "job ms";

    /** Part of it: reading the file and computing normals. */
    static final String LOAD = "load ms";

    /** Part of it: rendering, and writing the PNG file. */
    static final String PICTURE = "picture ms";

    private Jobs() {}

    /** Options: see {@code peers/whole-job}. */
    public static void main(String[] args) throws IOException {
        Options options = new Options(args, OPTIONS);
        Measurements results = new Measurements();
        results.noteMachine(options);
        List<String> files = options.list("files", "");
        String warmUp = options.get("warm-up", "9");
        String measure = options.get("measure", "4");
        int rounds = Integer.parseInt(options.get("rounds", "3"));
        try (Worker ours = new Worker(OURS, options.get("ours", ""));
                Worker theirs = new Worker(VTK, options.get("vtk", ""))) {
            for (String file : files) {
                ours.job(file, warmUp);
                theirs.job(file, "1");
            }
            for (int round = 1; round <= rounds; round++) {
                for (String file : files) {
                    for (Worker worker : List.of(ours, theirs)) {
                        double[] job = worker.job(file, measure);
                        String name = Path.of(file).getFileName().toString();
                        if (job[0] > 0) {
                            results.add(TOTAL, name, worker.name, round, job[1]);
                            results.add(LOAD, name, worker.name, round, job[2]);
                            results.add(PICTURE, name, worker.name, round, job[3]);
                        }
                    }
                }
            }
        }
        results.write(Path.of(options.get("results", "jobs.csv")));
    }

    /** Returns the table of whole jobs. */
    static String table(Measurements results) {
        List<List<String>> rows = new ArrayList<>();
        for (String file : results.subjects(TOTAL)) {
            rows.add(List.of(
                    file,
                    cell(results, file, OURS),
                    cell(results, file, VTK),
                    GeneratedPage.ratio(Measurements.median(results.ratios(TOTAL, file, OURS, VTK)))));
        }
        List<String> head = List.of(
                "mesh file to PNG, 512 x 512",
                OURS + ", ms (load + picture)",
                VTK + ", ms (load + picture)",
                "times as fast");
        return GeneratedPage.table(head, rows) + "\n" + GeneratedPage.source(results);
    }

    private static String cell(Measurements results, String file, String program) {
        return GeneratedPage.time(results.median(TOTAL, file, program)) + " ("
                + GeneratedPage.time(results.median(LOAD, file, program)) + " + "
                + GeneratedPage.time(results.median(PICTURE, file, program)) + ")";
    }

    /** A process that performs jobs on request. */
    private static final class Worker implements AutoCloseable {
        private final String name;
        private final Process process;
        private final BufferedWriter requests;
        private final BufferedReader responses;

        Worker(String name, String command) throws IOException {
            this.name = name;
            process = Contender.builder(List.of(command.trim().split(" +")), 1)
                    .redirectError(ProcessBuilder.Redirect.INHERIT)
                    .start();
            requests = process.outputWriter(StandardCharsets.UTF_8);
            responses = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        }

        /**
         * Lets the process perform jobs for some seconds; returns their number, the time of the shortest in
         * milliseconds, and its parts for loading and for the picture.
         */
        double[] job(String file, String seconds) throws IOException {
            requests.write(seconds + " " + file + "\n");
            requests.flush();
            String response = responses.readLine();
            if (response == null) {
                throw new IOException(name + " ended at " + file);
            }
            return Arrays.stream(response.split(" "))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
        }

        @Override
        public void close() throws IOException {
            requests.close();
            process.destroy();
        }
    }
}
