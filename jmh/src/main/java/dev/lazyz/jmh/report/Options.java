package dev.lazyz.jmh.report;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** A command line of {@code --name value} pairs; a name can occur more than once. */
public final class Options {
    private final Map<String, List<String>> values = new HashMap<>();

    /**
     * Reads a command line.
     *
     * @throws IllegalArgumentException if a name is not among {@code known}, or has no value
     */
    public Options(String[] args, Set<String> known) {
        for (int i = 0; i < args.length; i += 2) {
            String name = args[i].startsWith("--") ? args[i].substring(2) : "";
            if (!known.contains(name)) {
                throw new IllegalArgumentException("no option '" + args[i] + "'; there are " + known);
            }
            if (i + 1 == args.length) {
                throw new IllegalArgumentException("no value for " + args[i]);
            }
            values.computeIfAbsent(name, key -> new ArrayList<>()).add(args[i + 1]);
        }
    }

    /** Returns the last value of an option, or a default. */
    public String get(String name, String otherwise) {
        List<String> all = all(name);
        return all.isEmpty() ? otherwise : all.get(all.size() - 1);
    }

    /** Returns all values of an option. */
    public List<String> all(String name) {
        return values.getOrDefault(name, List.of());
    }

    /** Returns the comma-separated parts of an option; an empty list if it is empty. */
    public List<String> list(String name, String otherwise) {
        String value = get(name, otherwise);
        return value.isEmpty() ? List.of() : List.of(value.split(","));
    }
}
