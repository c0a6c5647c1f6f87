package dev.lazyz.jmh.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Function;

/**
 * A page of Markdown with generated parts: the text between {@code <!-- generated: NAME -->} and {@code <!-- end -->}
 * is replaced; the rest of the page stays unchanged.
 */
public final class GeneratedPage {
    private static final String BEGIN = "<!-- generated: ";
    private static final String END = "<!-- end -->";

    private GeneratedPage() {}

    /** Rewrites the generated parts of a page; see {@link #fill}. */
    public static void update(Path page, Function<String, String> section) throws IOException {
        Files.writeString(page, fill(Files.readString(page), section));
    }

    /**
     * Returns the page with its generated parts updated.
     *
     * @param section returns the text of a part by name, ending with a line break, or null to leave the part
     *     unchanged
     * @throws IllegalArgumentException if a part has no end
     */
    public static String fill(String page, Function<String, String> section) {
        StringBuilder filled = new StringBuilder();
        int from = 0;
        for (int begin = page.indexOf(BEGIN); begin >= 0; begin = page.indexOf(BEGIN, from)) {
            int nameEnd = page.indexOf(" -->", begin);
            int end = page.indexOf(END, begin);
            if (nameEnd < 0 || end < nameEnd) {
                throw new IllegalArgumentException("no " + END + " after position " + begin);
            }
            String name = page.substring(begin + BEGIN.length(), nameEnd);
            String text = section.apply(name);
            int kept = text == null ? end : nameEnd;
            filled.append(page, from, kept);
            if (text != null) {
                filled.append(" -->\n").append(text);
            }
            filled.append(END);
            from = end + END.length();
        }
        return filled.append(page.substring(from)).toString();
    }

    /** Returns a table. */
    public static String table(List<String> head, List<List<String>> rows) {
        StringBuilder text = new StringBuilder();
        text.append("| ").append(String.join(" | ", head)).append(" |\n");
        text.append("|").append("---|".repeat(head.size())).append('\n');
        for (List<String> row : rows) {
            text.append("| ").append(String.join(" | ", row)).append(" |\n");
        }
        return text.toString();
    }

    /** Returns a sentence: when and where something was measured. */
    public static String source(Measurements measured) {
        return "Measured on " + measured.facts().getOrDefault("date", "") + ", "
                + measured.facts().getOrDefault("processor", "") + ", Java "
                + measured.facts().getOrDefault("Java", "") + ".\n";
    }

    /** Returns a time in milliseconds with three digits; a dash if there is none. */
    public static String time(OptionalDouble time) {
        return number(
                time.isPresent() && time.getAsDouble() < 10 ? "%.2f" : time.orElse(0) < 100 ? "%.1f" : "%,.0f", time);
    }

    /** Returns how many times as fast something is, in bold; a dash if it is not known. */
    public static String ratio(OptionalDouble ratio) {
        return number("**%.2f**", ratio);
    }

    /** Returns bytes with two or three digits; a dash if there is no number. */
    public static String bytes(OptionalDouble bytes) {
        String[] units = {"B", "kB", "MB", "GB"};
        int unit = 0;
        double scaled = bytes.orElse(0);
        while (scaled >= 1000 && unit < units.length - 1) {
            scaled /= 1000;
            unit++;
        }
        return number(
                (scaled < 10 && unit > 0 ? "%.1f " : "%.0f ") + units[unit],
                bytes.isPresent() ? OptionalDouble.of(scaled) : bytes);
    }

    /** Returns a number in a format of Java; a dash if there is none. */
    public static String number(String format, OptionalDouble number) {
        return number.isPresent() ? String.format(Locale.ROOT, format, number.getAsDouble()) : "–";
    }
}
