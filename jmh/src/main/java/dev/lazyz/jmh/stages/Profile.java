package dev.lazyz.jmh.stages;

import dev.lazyz.world.Scene;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import jdk.jfr.FlightRecorder;
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
    /** Samples by the thread's time on its processor, since JDK 25 on Linux; almost none are lost. */
    private static final String BY_PROCESSOR_TIME = "jdk.CPUTimeSample";

    /** Samples by the clock. Older JDKs lose those that they take at places where they cannot read the stack. */
    private static final String BY_CLOCK = "jdk.ExecutionSample";

    private final Map<Stage, Integer> inSetUp = new EnumMap<>(Stage.class);
    private final Map<Stage, Integer> inRendering = new EnumMap<>(Stage.class);
    private final Map<String, Integer> methods = new HashMap<>();
    private final Set<String> unknown = new TreeSet<>();

    private Profile() {}

    /** Work that is recorded. */
    @FunctionalInterface
    interface Work {
        /** Does all of it. */
        void run() throws InterruptedException, IOException;
    }

    /**
     * Records {@code work} on this thread, with a sample each millisecond.
     */
    static Profile of(Work work) throws InterruptedException, IOException {
        Path file = Files.createTempFile("lazyz-stages-", ".jfr");
        try (Recording recording = new Recording()) {
            String event = hasProcessorTime() ? BY_PROCESSOR_TIME : BY_CLOCK;
            recording.enable(event).with(event.equals(BY_CLOCK) ? "period" : "throttle", "1 ms");
            recording.start();
            work.run();
            recording.stop();
            recording.dump(file);
            Profile profile = new Profile();
            profile.read(file, event, Thread.currentThread().getName());
            return profile;
        } finally {
            Files.delete(file);
        }
    }

    private static boolean hasProcessorTime() {
        return FlightRecorder.getFlightRecorder().getEventTypes().stream()
                .anyMatch(type -> type.getName().equals(BY_PROCESSOR_TIME));
    }

    private void read(Path file, String name, String thread) throws IOException {
        String field = name.equals(BY_CLOCK) ? "sampledThread" : "eventThread";
        try (RecordingFile events = new RecordingFile(file)) {
            while (events.hasMoreEvents()) {
                RecordedEvent event = events.readEvent();
                if (event.getEventType().getName().equals(name)
                        && event.getStackTrace() != null
                        && thread.equals(event.getThread(field).getJavaName())) {
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
                String name = type.substring(type.lastIndexOf('.') + 1) + "." + method;
                methods.merge(stage.label() + ": " + name, 1, Integer::sum);
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

    /** The {@code count} methods with most samples, each with its stage and its part of all samples in percent. */
    List<String> methods(int count) {
        return methods.entrySet().stream()
                .sorted(Map.Entry.<String, Integer>comparingByValue().reversed())
                .limit(count)
                .map(each ->
                        String.format(Locale.ROOT, "%5.1f  %s", 100.0 * each.getValue() / samples(), each.getKey()))
                .toList();
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
