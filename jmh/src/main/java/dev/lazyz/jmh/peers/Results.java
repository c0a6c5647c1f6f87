package dev.lazyz.jmh.peers;

import dev.lazyz.jmh.report.JsonRecords;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import kotlinx.serialization.json.JsonObject;

/**
 * All measurements of one run, stored in a JSON file: facts about the machine and the run by name, and one line for
 * each measurement.
 *
 * @param facts machine, versions, settings, commands
 * @param times times of frames in steady state
 * @param pictures comparisons with Lazy Z's images
 * @param starts times of whole processes
 */
record Results(Map<String, String> facts, List<Time> times, List<Picture> pictures, List<Start> starts) {
    /** The renderer that others are compared with. */
    static final String BASE = "llvmpipe";

    /** Begins the names of Lazy Z's contenders, which are those of JVMs. */
    private static final String OURS = "JDK ";

    /**
     * Times of the frames of one process.
     *
     * @param scene name of the scene or mesh file, without a folder
     * @param side width and height of the raster, pixels
     * @param samples a pixel has the square of this number of samples
     * @param threads number of threads of the renderer; the process has as many processors
     * @param contender name of the renderer
     * @param round number of the round, from 1; within a round, processes run directly one after the other
     * @param median milliseconds per frame
     * @param q1 first quartile, milliseconds
     * @param q3 third quartile, milliseconds
     * @param min shortest, milliseconds
     * @param max longest, milliseconds
     * @param first the process's first frame, milliseconds
     * @param frames number of measured frames
     */
    record Time(
            String scene,
            int side,
            int samples,
            int threads,
            String contender,
            int round,
            double median,
            double q1,
            double q3,
            double min,
            double max,
            double first,
            int frames) {}

    /**
     * A contender's image, compared with Lazy Z's sample by sample.
     *
     * @param scene name of the scene or mesh file, without a folder
     * @param side width and height of the raster, samples
     * @param contender name of the renderer
     * @param covered samples covered
     * @param oursOnly samples covered in Lazy Z's image but not in this one
     * @param theirsOnly samples covered in this image but not in Lazy Z's
     * @param unequal samples covered in both with a component that differs by more than
     *     {@link PictureDifference#TOLERANCE} of 255; -1 if colours cannot be compared
     * @param mean mean difference of the components of samples covered in both, of 255; -1 if colours cannot be
     *     compared
     */
    record Picture(
            String scene,
            int side,
            String contender,
            long covered,
            long oursOnly,
            long theirsOnly,
            long unequal,
            double mean) {
        /** Whether this is Lazy Z's image, which is compared with itself. */
        boolean isOurs() {
            return contender.startsWith(OURS);
        }
    }

    /**
     * The time of a process that renders one small image, from its start to its end.
     *
     * @param contender name of the renderer
     * @param round number of the round, from 1
     * @param time milliseconds
     */
    record Start(String contender, int round, double time) {}

    /** Returns empty results. */
    static Results empty() {
        return new Results(new TreeMap<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
    }

    /** Reads a file written by {@link #write}. */
    static Results read(Path file) throws IOException {
        JsonObject root = JsonRecords.parse(Files.readString(file));
        return new Results(
                new TreeMap<>(JsonRecords.texts(root, "facts")),
                JsonRecords.records(root, "times", Time.class),
                JsonRecords.records(root, "pictures", Picture.class),
                JsonRecords.records(root, "starts", Start.class));
    }

    /** Records a fact. Facts of several runs with the same name are all kept. */
    void addFact(String name, String value) {
        facts.merge(
                name, value, (before, now) -> List.of(before.split("; ")).contains(now) ? before : before + "; " + now);
    }

    /** Returns the number of rounds. */
    int rounds() {
        return times.stream().mapToInt(Time::round).max().orElse(0);
    }

    /** Removes all results of a scene. */
    void drop(String scene) {
        times.removeIf(time -> time.scene().equals(scene));
        pictures.removeIf(picture -> picture.scene().equals(scene));
    }

    /** Writes JSON with one measurement per line. */
    void write(Path file) throws IOException {
        Map<String, List<? extends Record>> lists = new LinkedHashMap<>();
        lists.put("times", times);
        lists.put("pictures", pictures);
        lists.put("starts", starts);
        Files.writeString(file, JsonRecords.write(facts, lists));
    }
}
