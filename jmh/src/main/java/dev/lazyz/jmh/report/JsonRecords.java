package dev.lazyz.jmh.report;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import kotlinx.serialization.json.Json;
import kotlinx.serialization.json.JsonArray;
import kotlinx.serialization.json.JsonElement;
import kotlinx.serialization.json.JsonElementKt;
import kotlinx.serialization.json.JsonObject;

/**
 * Measurements as JSON: an object with facts by name, and lists of records, one record per line. A record's
 * components are texts and numbers, stored by component name.
 */
public final class JsonRecords {
    private JsonRecords() {}

    /** Parses {@code text} as a JSON object. */
    public static JsonObject parse(String text) {
        return JsonElementKt.getJsonObject(Json.Default.parseToJsonElement(text));
    }

    /** Returns the text of a file: {@code facts}, then the lists, by name. */
    public static String write(Map<String, String> facts, Map<String, List<? extends Record>> lists) {
        List<String> members = new ArrayList<>();
        members.add(member("facts", "{", facts.entrySet(), e -> quoted(e.getKey()) + ":" + quoted(e.getValue()), "}"));
        lists.forEach((name, records) -> members.add(member(name, "[", records, r -> of(r).toString(), "]")));
        return "{\n" + String.join(",\n", members) + "\n}\n";
    }

    /** Returns the components of {@code measurement} by name. */
    public static JsonObject of(Record measurement) {
        Map<String, JsonElement> members = new LinkedHashMap<>();
        for (RecordComponent component : measurement.getClass().getRecordComponents()) {
            try {
                component.getAccessor().setAccessible(true);
                Object value = component.getAccessor().invoke(measurement);
                members.put(
                        component.getName(),
                        value instanceof Number number
                                ? JsonElementKt.JsonPrimitive(number)
                                : JsonElementKt.JsonPrimitive((String) value));
            } catch (ReflectiveOperationException e) {
                throw new IllegalStateException(e);
            }
        }
        return new JsonObject(members);
    }

    /** Returns the texts of the object called {@code name}. */
    public static Map<String, String> texts(JsonObject root, String name) {
        Map<String, String> texts = new LinkedHashMap<>();
        JsonElementKt.getJsonObject(root.get(name)).forEach((key, value) -> texts.put(key, text(value)));
        return texts;
    }

    /** Returns the records of the list called {@code name}. */
    public static <R extends Record> List<R> records(JsonObject root, String name, Class<R> type) {
        List<R> records = new ArrayList<>();
        for (JsonElement element : (JsonArray) root.get(name)) {
            records.add(record(JsonElementKt.getJsonObject(element), type));
        }
        return records;
    }

    /** Returns the text called {@code name}. */
    public static String text(JsonObject object, String name) {
        JsonElement element = object.get(name);
        if (element == null) {
            throw new IllegalArgumentException("no '" + name + "' in " + object);
        }
        return text(element);
    }

    /** Returns the number called {@code name}. */
    public static double real(JsonObject object, String name) {
        return Double.parseDouble(text(object, name));
    }

    /** Returns the whole number called {@code name}. */
    public static int integer(JsonObject object, String name) {
        return Integer.parseInt(text(object, name));
    }

    /** Returns the record of type {@code type} whose components are in {@code object}. */
    public static <R extends Record> R record(JsonObject object, Class<R> type) {
        RecordComponent[] components = type.getRecordComponents();
        Class<?>[] types = new Class<?>[components.length];
        Object[] values = new Object[components.length];
        for (int i = 0; i < components.length; i++) {
            types[i] = components[i].getType();
            values[i] = value(text(object, components[i].getName()), types[i]);
        }
        try {
            var constructor = type.getDeclaredConstructor(types);
            constructor.setAccessible(true);
            return constructor.newInstance(values);
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Object value(String text, Class<?> type) {
        if (type == int.class) {
            return Integer.valueOf(text);
        }
        if (type == long.class) {
            return Long.valueOf(text);
        }
        return type == double.class ? Double.valueOf(text) : text;
    }

    /** Returns a member with one element per line, so that a new measurement is one line of a difference. */
    private static <T> String member(
            String name, String open, Collection<T> elements, Function<T, String> line, String close) {
        List<String> lines = elements.stream().map(line).toList();
        return quoted(name) + ":" + open + "\n" + String.join(",\n", lines) + "\n" + close;
    }

    private static String quoted(String text) {
        return JsonElementKt.JsonPrimitive(text).toString();
    }

    private static String text(JsonElement element) {
        return JsonElementKt.getJsonPrimitive(element).getContent();
    }
}
