package dev.lazyz.jmh.peers;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Function;
import kotlinx.serialization.json.Json;
import kotlinx.serialization.json.JsonArray;
import kotlinx.serialization.json.JsonElement;
import kotlinx.serialization.json.JsonElementKt;
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
        JsonObject root = object(Json.Default.parseToJsonElement(Files.readString(file)));
        Results results = empty();
        object(root.get("facts")).forEach((name, value) -> results.facts.put(name, text(value)));
        each(root, "times", o -> results.times.add(time(o)));
        each(root, "pictures", o -> results.pictures.add(picture(o)));
        each(
                root,
                "starts",
                o -> results.starts.add(new Start(text(o, "contender"), integer(o, "round"), real(o, "time"))));
        return results;
    }

    /** Writes JSON, a measurement a line. */
    void write(Path file) throws IOException {
        StringBuilder text = new StringBuilder("{\n\"facts\": {\n");
        text.append(lines(new ArrayList<>(facts.entrySet()), e -> quoted(e.getKey()) + ": " + quoted(e.getValue())));
        text.append("\n},\n\"times\": [\n").append(lines(times, Results::json));
        text.append("\n],\n\"pictures\": [\n").append(lines(pictures, Results::json));
        text.append("\n],\n\"starts\": [\n")
                .append(lines(starts, Results::json))
                .append("\n]\n}\n");
        Files.writeString(file, text);
    }

    private static Time time(JsonObject o) {
        return new Time(
                text(o, "scene"),
                integer(o, "side"),
                integer(o, "threads"),
                text(o, "contender"),
                integer(o, "round"),
                real(o, "median"),
                real(o, "q1"),
                real(o, "q3"),
                real(o, "min"),
                real(o, "max"),
                real(o, "first"),
                integer(o, "frames"));
    }

    private static Picture picture(JsonObject o) {
        return new Picture(
                text(o, "scene"),
                integer(o, "side"),
                text(o, "contender"),
                (long) real(o, "covered"),
                (long) real(o, "oursOnly"),
                (long) real(o, "theirsOnly"),
                (long) real(o, "unequal"),
                real(o, "mean"));
    }

    /** Returns a record as a JSON object: its components by their names. */
    private static String json(Record measurement) {
        List<String> fields = new ArrayList<>();
        for (var component : measurement.getClass().getRecordComponents()) {
            try {
                Object value = component.getAccessor().invoke(measurement);
                String text = value instanceof String string ? quoted(string) : value.toString();
                fields.add(quoted(component.getName()) + ": " + text);
            } catch (ReflectiveOperationException e) {
                throw new IllegalStateException(e);
            }
        }
        return "{" + String.join(", ", fields) + "}";
    }

    private static <T> String lines(List<T> elements, Function<T, String> line) {
        return String.join(",\n", elements.stream().map(line).toList());
    }

    private static String quoted(String text) {
        return JsonElementKt.JsonPrimitive(text).toString();
    }

    private static void each(JsonObject root, String name, Consumer<JsonObject> consumer) {
        for (JsonElement element : (JsonArray) root.get(name)) {
            consumer.accept(object(element));
        }
    }

    static JsonObject object(JsonElement element) {
        return JsonElementKt.getJsonObject(element);
    }

    static String text(JsonElement element) {
        return JsonElementKt.getJsonPrimitive(element).getContent();
    }

    static String text(JsonObject object, String name) {
        JsonElement element = object.get(name);
        if (element == null) {
            throw new IllegalArgumentException("no '" + name + "' in " + object);
        }
        return text(element);
    }

    static double real(JsonObject object, String name) {
        return Double.parseDouble(text(object, name));
    }

    static int integer(JsonObject object, String name) {
        return Integer.parseInt(text(object, name));
    }
}
