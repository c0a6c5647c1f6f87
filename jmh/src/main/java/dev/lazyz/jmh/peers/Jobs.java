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
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

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

    /** Returns the tables of whole jobs: as both make pictures by default, and with one sample a pixel. */
    static String table(Measurements results) {
        return table(results, SAMPLES) + "\n" + table(results, ONE_SAMPLE) + "\n" + GeneratedPage.source(results);
    }

    private static String table(Measurements results, String samples) {
        Map<Boolean, List<String>> programs = results.programs(TOTAL).stream()
                .filter(program -> program.endsWith(samples))
                .collect(Collectors.partitioningBy(program -> program.startsWith(VTK)));
        if (programs.get(true).isEmpty()) {
            return "";
        }
        String vtk = programs.get(true).get(0);
        List<String> head = new ArrayList<>(List.of("file; pixels", vtk + ", ms"));
        for (String ours : programs.get(false)) {
            head.addAll(List.of(ours + ", ms (of this, loading)", "times as fast"));
        }
        List<List<String>> rows = new ArrayList<>();
        for (String subject : results.subjects(TOTAL)) {
            List<String> row =
                    new ArrayList<>(List.of(subject, GeneratedPage.time(results.median(TOTAL, subject, vtk))));
            for (String ours : programs.get(false)) {
                row.add(GeneratedPage.time(results.median(TOTAL, subject, ours)) + " ("
                        + GeneratedPage.time(results.median(LOAD, subject, ours)) + ")");
                row.add(GeneratedPage.ratio(Measurements.median(results.ratios(TOTAL, subject, ours, vtk))));
            }
            rows.add(row);
        }
        return GeneratedPage.table(head, rows);
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
