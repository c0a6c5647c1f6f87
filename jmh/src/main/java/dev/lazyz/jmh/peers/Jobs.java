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
 * Measures whole jobs, from mesh file to PNG file, of Lazy Z and of VTK, in warm processes that run alternately on the
 * same processor. {@code peers/whole-job} starts it.
 */
public final class Jobs {
    private static final Set<String> OPTIONS =
            Set.of("ours", "vtk", "files", "sides", "rounds", "warm-up", "measure", "results", "fact");

    static final String VTK = "VTK";
    private static final String SAMPLES = " samples";

    /** Ends the name of a program that draws one sample a pixel. */
    static final String ONE_SAMPLE = ": 1 sample";

    /** Samples a pixel of Lazy Z, the default first, and of VTK; llvmpipe has no more than 4. */
    private static final List<Integer> OUR_SAMPLES = List.of(16, 1);

    private static final List<Integer> THEIR_SAMPLES = List.of(4, 1);

    /** Wall-clock time of the shortest job of a round, from file to file. */
    static final String TOTAL = "job ms";

    /** Part of it: reading the file and computing normals. */
    static final String LOAD = "load ms";

    /** Part of it: rendering, and writing the PNG file. */
    private static final String PICTURE = "picture ms";

    private Jobs() {}

    /** Options: see {@code peers/whole-job}. */
    public static void main(String[] args) throws IOException {
        Options options = new Options(args, OPTIONS);
        Measurements results = new Measurements();
        results.noteMachine(options);
        String measure = options.get("measure", "2");
        int rounds = Integer.parseInt(options.get("rounds", "3"));
        List<Worker> workers = new ArrayList<>();
        try {
            for (String ours : options.all("ours")) {
                workers.add(new Worker(Contender.parse(Contender.Kind.OURS, ours), OUR_SAMPLES));
            }
            String vtk = options.get("vtk", "");
            workers.add(new Worker(Contender.parse(Contender.Kind.VTK, VTK + "=" + vtk), THEIR_SAMPLES));
            for (String file : options.list("files", "")) {
                for (Worker worker : workers) {
                    worker.job(file, 512, worker.samples.get(0), options.get("warm-up", "9"));
                }
                for (String side : options.list("sides", "256,512,1024")) {
                    for (int round = 1; round <= rounds; round++) {
                        for (Worker worker : workers) {
                            worker.measure(results, file, Integer.parseInt(side), measure, round);
                        }
                    }
                }
            }
        } finally {
            for (Worker worker : workers) {
                worker.close();
            }
        }
        results.write(Path.of(options.get("results", "jobs.csv")));
    }

    /** Returns the table of default pictures of the first of our programs, and a line for each of the others. */
    static String table(Measurements results) {
        String vtk = VTK + ": 4" + SAMPLES;
        List<List<String>> rows = new ArrayList<>();
        List<String> ours = results.programs(TOTAL).stream()
                .filter(program -> !program.startsWith(VTK))
                .toList();
        String first = ours.isEmpty() ? "" : ours.get(0);
        for (String subject : results.subjects(TOTAL)) {
            rows.add(List.of(
                    subject,
                    GeneratedPage.time(results.median(TOTAL, subject, vtk)),
                    GeneratedPage.time(results.median(TOTAL, subject, first)) + " ("
                            + GeneratedPage.time(results.median(LOAD, subject, first)) + ")",
                    GeneratedPage.ratio(Measurements.median(results.ratios(TOTAL, subject, first, vtk)))));
        }
        List<String> head = List.of("file; pixels", vtk + ", ms", first + ", ms (of this, loading)", "times as fast");
        StringBuilder text = new StringBuilder(GeneratedPage.table(head, rows)).append('\n');
        for (String program : ours.subList(Math.min(1, ours.size()), ours.size())) {
            String peer = program.endsWith(ONE_SAMPLE) ? VTK + ONE_SAMPLE : vtk;
            text.append(PeerPage.range(
                    program + ": ",
                    results.subjects(TOTAL).stream()
                            .map(subject -> Measurements.median(results.ratios(TOTAL, subject, program, peer))),
                    " times as fast as " + peer));
        }
        return text.append('\n').append(GeneratedPage.source(results)).toString();
    }

    /** A process that performs jobs on request. */
    private static final class Worker implements AutoCloseable {
        private final String name;
        private final List<Integer> samples;
        private final Process process;
        private final BufferedWriter requests;
        private final BufferedReader responses;

        Worker(Contender program, List<Integer> samples) throws IOException {
            this.name = program.name();
            this.samples = samples;
            process = Contender.builder(program.command(), 1)
                    .redirectError(ProcessBuilder.Redirect.INHERIT)
                    .start();
            requests = process.outputWriter(StandardCharsets.UTF_8);
            responses = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        }

        /** Measures pictures of a size, with each number of samples. */
        void measure(Measurements results, String file, int side, String seconds, int round) throws IOException {
            for (int each : samples) {
                double[] job = job(file, side, each, seconds);
                String subject = Path.of(file).getFileName() + "; " + side;
                String program = name + (each == 1 ? ONE_SAMPLE : ": " + each + SAMPLES);
                if (job[0] > 0) {
                    results.add(TOTAL, subject, program, round, job[1]);
                    results.add(LOAD, subject, program, round, job[2]);
                    results.add(PICTURE, subject, program, round, job[3]);
                }
            }
        }

        /**
         * Lets the process perform jobs for some seconds; returns their number, the time of the shortest in
         * milliseconds, and its parts for loading and for the picture.
         */
        double[] job(String file, int side, int samples, String seconds) throws IOException {
            requests.write(seconds + " " + side + " " + samples + " " + file + "\n");
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
