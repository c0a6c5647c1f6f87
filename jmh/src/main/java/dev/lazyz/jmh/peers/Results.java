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
 * Everything that was measured in one run, as it is kept in a JSON file: facts about the machine and the run by name, and
 * one line for each measurement.
 *
 * @param facts machine, versions, settings, commands
 * @param times of frames in steady state
 * @param pictures compared with ours
 * @param starts of whole processes
 */
record Results(Map<String, String> facts, List<Time> times, List<Picture> pictures, List<Start> starts) {
    /** The renderer that others are compared with. */
    static final String BASE = "llvmpipe";

    /**
     * Frames of one process.
     *
     * @param scene its name, without a folder
     * @param side width and height of the raster, samples
     * @param threads of the renderer; the process has as many processors
     * @param contender who rendered
     * @param round in which round, from 1; within one, processes follow each other closely
     * @param median milliseconds a frame
     * @param q1 first quartile, milliseconds
     * @param q3 third quartile, milliseconds
     * @param min shortest, milliseconds
     * @param max longest, milliseconds
     * @param first the process's first frame, milliseconds
     * @param frames how many were measured
     */
    record Time(
            String scene,
            int side,
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
     * A contender's picture, sample by sample beside ours.
     *
     * @param scene its name, without a folder
     * @param side width and height of the raster, samples
     * @param contender who rendered
     * @param covered samples covered
     * @param oursOnly samples covered in our picture and not in this one
     * @param theirsOnly samples covered in this picture and not in ours
     * @param unequal samples covered in both with a component that differs by more than {@link PictureDifference#TOLERANCE}
     *     of 255; -1 if colours cannot be compared
     * @param mean difference of components of samples covered in both, of 255; -1 if colours cannot be compared
     */
    record Picture(
            String scene,
            int side,
            String contender,
            long covered,
            long oursOnly,
            long theirsOnly,
            long unequal,
            double mean) {}

    /**
     * A process from its start to its end, with one small picture in between.
     *
     * @param contender who rendered
     * @param round in which round, from 1
     * @param time milliseconds
     */
    record Start(String contender, int round, double time) {}

    /** Results without any. */
    static Results empty() {
        return new Results(new TreeMap<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
    }

    /** Reads what {@link #write} wrote. */
    static Results read(Path file) throws IOException {
        JsonObject root = JsonRecords.parse(Files.readString(file));
        return new Results(
                JsonRecords.texts(root, "facts"),
                JsonRecords.records(root, "times", Time.class),
                JsonRecords.records(root, "pictures", Picture.class),
                JsonRecords.records(root, "starts", Start.class));
    }

    /** Writes JSON, a measurement a line. */
    void write(Path file) throws IOException {
        Map<String, List<? extends Record>> lists = new LinkedHashMap<>();
        lists.put("times", times);
        lists.put("pictures", pictures);
        lists.put("starts", starts);
        Files.writeString(file, JsonRecords.write(facts, lists));
    }
}
