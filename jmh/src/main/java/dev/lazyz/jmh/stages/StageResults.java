package dev.lazyz.jmh.stages;

import dev.lazyz.jmh.report.JsonRecords;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import kotlinx.serialization.json.JsonObject;

/**
 * Measurements of stages, of one or several Java runtimes, stored in a JSON file with a line for each. Limits are not
 * stored, as they follow from counts and machines.
 *
 * @param facts processor and date by the runtime's name
 * @param machines what the processor can do at most, by runtime
 * @param frames times of frames
 * @param stages times of stages
 * @param counts counts of frames, the same with every runtime
 */
record StageResults(
        Map<String, String> facts,
        List<Machine> machines,
        List<FrameTime> frames,
        List<StageTime> stages,
        List<FrameCounts> counts) {
    /**
     * The time of a frame in steady state.
     *
     * @param jvm name of the Java runtime
     * @param scene name of the scene or mesh file, without a folder
     * @param side width and height of the raster, samples
     * @param time the thread's time on its processor, milliseconds: the least of all frames, as other programs that use
     *     caches and memory can only make it longer
     * @param setUp the same of the part from the scene to the frame
     * @param median the median of all frames
     * @param frames number of measured frames
     * @param samples number of the profiler's samples
     * @param found number of samples for each millisecond of the thread; 1 if none was lost
     */
    record FrameTime(
            String jvm,
            String scene,
            int side,
            double time,
            double setUp,
            double median,
            int frames,
            int samples,
            double found) {}

    /**
     * The time of a stage.
     *
     * @param jvm name of the Java runtime
     * @param scene name of the scene or mesh file, without a folder
     * @param side width and height of the raster, samples
     * @param stage label of the stage
     * @param time milliseconds of a frame
     */
    record StageTime(String jvm, String scene, int side, String stage, double time) {}

    /** Returns the name of this Java runtime: its version, and whether it has the Vector API. */
    static String jvm() {
        boolean hasVectors =
                ModuleLayer.boot().findModule("jdk.incubator.vector").isPresent();
        return "JDK " + Runtime.version().feature() + (hasVectors ? ", Vector API" : "");
    }

    /** Returns empty results. */
    static StageResults empty() {
        return new StageResults(
                new TreeMap<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>(), new ArrayList<>());
    }

    /** Reads a file written by {@link #write}. */
    static StageResults read(Path file) throws IOException {
        JsonObject root = JsonRecords.parse(Files.readString(file));
        return new StageResults(
                JsonRecords.texts(root, "facts"),
                JsonRecords.records(root, "machines", Machine.class),
                JsonRecords.records(root, "frames", FrameTime.class),
                JsonRecords.records(root, "stages", StageTime.class),
                JsonRecords.records(root, "counts", FrameCounts.class));
    }

    /** Writes JSON with one measurement per line. */
    void write(Path file) throws IOException {
        Map<String, List<? extends Record>> lists = new LinkedHashMap<>();
        lists.put("machines", machines);
        lists.put("frames", frames);
        lists.put("stages", stages);
        lists.put("counts", counts);
        Files.writeString(file, JsonRecords.write(facts, lists));
    }

    /** Adds a line that {@link StageRun} printed: a kind and JSON. */
    void add(String line) {
        int at = line.indexOf(' ');
        JsonObject json = JsonRecords.parse(line.substring(at + 1));
        switch (line.substring(0, at)) {
            case "machine" -> machines.add(JsonRecords.record(json, Machine.class));
            case "frame" -> frames.add(JsonRecords.record(json, FrameTime.class));
            case "stage" -> stages.add(JsonRecords.record(json, StageTime.class));
            case "counts" -> {
                FrameCounts added = JsonRecords.record(json, FrameCounts.class);
                counts.removeIf(old -> old.scene().equals(added.scene()) && old.side() == added.side());
                counts.add(added);
            }
            default -> throw new IllegalArgumentException("neither a machine, a frame, a stage nor counts: " + line);
        }
    }

    /** Removes all measurements with a runtime, and counts of frames that no other runtime measured. */
    void remove(String jvm) {
        machines.removeIf(machine -> machine.jvm().equals(jvm));
        frames.removeIf(frame -> frame.jvm().equals(jvm));
        stages.removeIf(stage -> stage.jvm().equals(jvm));
        counts.removeIf(count -> frames.stream()
                .noneMatch(frame -> frame.scene().equals(count.scene()) && frame.side() == count.side()));
    }

    /** Removes the measurements of a frame with a runtime. */
    void remove(String jvm, String scene, int side) {
        frames.removeIf(frame -> frame.jvm().equals(jvm) && frame.scene().equals(scene) && frame.side() == side);
        stages.removeIf(stage -> stage.jvm().equals(jvm) && stage.scene().equals(scene) && stage.side() == side);
    }

    /** The names of all runtimes, the newest first. */
    List<String> jvms() {
        return machines.stream()
                .map(Machine::jvm)
                .distinct()
                .sorted(Comparator.reverseOrder())
                .toList();
    }

    /** The time of a frame, if it was measured. */
    Optional<FrameTime> frame(String jvm, FrameCounts counts) {
        return frames.stream()
                .filter(frame -> frame.jvm().equals(jvm)
                        && frame.scene().equals(counts.scene())
                        && frame.side() == counts.side())
                .findFirst();
    }

    /** The time of a stage of a frame that was measured, milliseconds. */
    double time(FrameTime frame, Stage stage) {
        return stages.stream()
                .filter(time -> time.jvm().equals(frame.jvm())
                        && time.scene().equals(frame.scene())
                        && time.side() == frame.side()
                        && time.stage().equals(stage.label()))
                .mapToDouble(StageTime::time)
                .sum();
    }

    /** The limit of a stage of a frame, by the best figures of the machine with any runtime. */
    Limit limit(FrameCounts counts, Stage stage) {
        return Limit.of(stage, counts, Machine.best(machines));
    }
}
