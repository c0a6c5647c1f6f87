package dev.lazyz.jmh.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * A page of Markdown with generated parts: the text between {@code <!-- generated: NAME -->} and {@code <!-- end -->}
 * is replaced; the rest of the page stays unchanged.
 */
public final class GeneratedPage {
    private static final String BEGIN = "<!-- generated: ";
    private static final String END = "<!-- end -->";

    private GeneratedPage() {}

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

    /**
     * Rewrites a page, and the page of its long tables beside it, if there is one: for {@code NAME.md}, that is
     * {@code NAME-tables.md}.
     *
     * @param filled returns a page with its generated parts updated
     */
    public static void update(Path page, UnaryOperator<String> filled) throws IOException {
        Path tables = page.resolveSibling(page.getFileName().toString().replace(".md", "-tables.md"));
        for (Path each : List.of(page, tables)) {
            if (Files.exists(each)) {
                Files.writeString(each, filled.apply(Files.readString(each)));
            }
        }
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
}
