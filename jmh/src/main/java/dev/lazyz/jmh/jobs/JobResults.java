package dev.lazyz.jmh.jobs;

import dev.lazyz.jmh.report.GeneratedPage;
import dev.lazyz.jmh.report.JsonRecords;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Measurements of whole jobs.
 *
 * @param facts machine, versions, command
 * @param jobs one entry for each file, round and program
 */
record JobResults(Map<String, String> facts, List<Job> jobs) {
    static final String OURS = "Lazy Z";
    static final String VTK = "VTK";

    /**
     * The shortest job of a program in a round.
     *
     * @param file name of the mesh file, without its folder
     * @param program {@link #OURS} or {@link #VTK}
     * @param round number of the round, from 1
     * @param count number of jobs in the round
     * @param total milliseconds from file to file
     * @param load part of the total: reading the file and computing normals
     * @param picture part of the total: rendering, and writing the PNG file
     */
    record Job(String file, String program, int round, int count, double total, double load, double picture) {}

    String toJson() {
        return JsonRecords.write(facts, Map.of("jobs", jobs));
    }

    /** Returns the page with the parts "jobs" and "jobs summary" replaced by those of these results. */
    String fill(String page) {
        return GeneratedPage.fill(page, name -> switch (name) {
            case "jobs" -> tables();
            case "jobs summary" -> summary();
            default -> null;
        });
    }

    /** Returns a sentence: how many times as fast as VTK, for the files that both can read. */
    private String summary() {
        List<Double> medians = files().stream()
                .map(this::ratios)
                .filter(ratios -> !ratios.isEmpty())
                .map(JobResults::median)
                .sorted()
                .toList();
        return String.format(
                Locale.ROOT,
                "From a mesh file to a PNG file of 512 x 512 samples, %.1f to %.1f times as fast as VTK (%d files).%n",
                medians.get(0),
                last(medians),
                medians.size());
    }

    private List<String> files() {
        return jobs.stream().map(Job::file).distinct().toList();
    }

    /** Returns the tables: a row for each file with the median of the rounds, by Lazy Z's time; then the facts. */
    String tables() {
        List<List<String>> rows = new ArrayList<>();
        for (String file : files()) {
            List<Double> ratios = ratios(file);
            String ratio = ratios.isEmpty()
                    ? ""
                    : String.format(
                            Locale.ROOT, "**%.2f x** (%.2f..%.2f)", median(ratios), ratios.get(0), last(ratios));
            rows.add(List.of(file, cell(file, OURS), cell(file, VTK), ratio));
        }
        List<List<String>> noted = new ArrayList<>();
        facts.forEach((name, value) -> noted.add(List.of(name, value)));
        List<String> head =
                List.of("file", OURS + ", ms (load + picture)", VTK + ", ms (load + picture)", "times as fast");
        return GeneratedPage.table(head, rows) + "\n" + GeneratedPage.table(List.of("fact", "value"), noted);
    }

    private String cell(String file, String program) {
        List<Job> found = of(file, program);
        if (found.isEmpty()) {
            return "";
        }
        Job job = found.get(found.size() / 2);
        return String.format(Locale.ROOT, "%.1f (%.1f + %.1f)", job.total, job.load, job.picture);
    }

    /** Returns the program's jobs on a file, the shortest first. */
    private List<Job> of(String file, String program) {
        return jobs.stream()
                .filter(job -> job.file.equals(file) && job.program.equals(program))
                .sorted(Comparator.comparingDouble(Job::total))
                .toList();
    }

    /** Returns the ratios of VTK's time to Lazy Z's in each round, in ascending order. */
    private List<Double> ratios(String file) {
        List<Double> ratios = new ArrayList<>();
        for (Job ours : of(file, OURS)) {
            for (Job theirs : of(file, VTK)) {
                if (ours.round == theirs.round) {
                    ratios.add(theirs.total / ours.total);
                }
            }
        }
        ratios.sort(null);
        return ratios;
    }

    private static double median(List<Double> sorted) {
        return sorted.get(sorted.size() / 2);
    }

    private static double last(List<Double> sorted) {
        return sorted.get(sorted.size() - 1);
    }
}
