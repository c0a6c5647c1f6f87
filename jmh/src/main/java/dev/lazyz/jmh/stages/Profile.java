package dev.lazyz.jmh.stages;

import dev.lazyz.world.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.EnumMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordedFrame;
import jdk.jfr.consumer.RecordingFile;

/**
 * How often each stage was found at work by Java Flight Recorder, in one thread. The innermost method that
 * {@link StageMap} assigns to a stage decides.
 *
 * <p>Samples are counted separately within {@link Scene#frame}, so that each part can be scaled to its own time by the
 * clock.
 */
final class Profile {
    private static final String EVENT = "jdk.ExecutionSample";

    private final Map<Stage, Integer> inSetUp = new EnumMap<>(Stage.class);
    private final Map<Stage, Integer> inRendering = new EnumMap<>(Stage.class);
    private final Set<String> unknown = new TreeSet<>();

    private Profile() {}

    /** Work that is recorded. */
    @FunctionalInterface
    interface Work {
        /** Does all of it. */
        void run() throws InterruptedException, IOException;
    }

    /**
     * Records {@code work} on this thread.
     *
     * @param period time between samples; the recorder's least is 1 ms
     */
    static Profile of(Duration period, Work work) throws InterruptedException, IOException {
        Path file = Files.createTempFile("lazyz-stages-", ".jfr");
        try (Recording recording = new Recording()) {
            recording.enable(EVENT).withPeriod(period);
            recording.start();
            work.run();
            recording.stop();
            recording.dump(file);
            Profile profile = new Profile();
            profile.read(file, Thread.currentThread().getName());
            return profile;
        } finally {
            Files.delete(file);
        }
    }

    private void read(Path file, String thread) throws IOException {
        try (RecordingFile events = new RecordingFile(file)) {
            while (events.hasMoreEvents()) {
                RecordedEvent event = events.readEvent();
                if (event.getEventType().getName().equals(EVENT)
                        && event.getStackTrace() != null
                        && thread.equals(event.getThread("sampledThread").getJavaName())) {
                    add(event);
                }
            }
        }
    }

    private void add(RecordedEvent event) {
        Stage stage = null;
        boolean isSetUp = false;
        for (RecordedFrame frame : event.getStackTrace().getFrames()) {
            String type = frame.getMethod().getType().getName();
            String method = frame.getMethod().getName();
            isSetUp |= type.equals(Scene.class.getName()) && method.equals("frame");
            StageMap.Found found = StageMap.find(type, method);
            if (stage == null && found.kind() == StageMap.Kind.STAGE) {
                stage = found.stage();
            }
            if (found.kind() == StageMap.Kind.NONE && type.startsWith(StageMap.ROOT)) {
                unknown.add(type);
            }
        }
        (isSetUp ? inSetUp : inRendering).merge(stage == null ? Stage.OTHER : stage, 1, Integer::sum);
    }

    /** Number of samples. */
    int samples() {
        return sum(inSetUp) + sum(inRendering);
    }

    /** Classes of the project that have no rule; the next outer method with a rule decided. */
    Set<String> unknown() {
        return unknown;
    }

    /**
     * Returns the time of a stage, milliseconds.
     *
     * @param setUp time of {@link Scene#frame}, milliseconds
     * @param rendering the rest of a frame, milliseconds
     */
    double time(Stage stage, double setUp, double rendering) {
        return part(inSetUp, stage) * setUp + part(inRendering, stage) * rendering;
    }

    /** The share of a stage, 0..1; without samples, all time belongs to {@link Stage#OTHER}. */
    private static double part(Map<Stage, Integer> samples, Stage stage) {
        int sum = sum(samples);
        return sum == 0 ? (stage == Stage.OTHER ? 1 : 0) : (double) samples.getOrDefault(stage, 0) / sum;
    }

    private static int sum(Map<Stage, Integer> samples) {
        return samples.values().stream().mapToInt(Integer::intValue).sum();
    }
}
