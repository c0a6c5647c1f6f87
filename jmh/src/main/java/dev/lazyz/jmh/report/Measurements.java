package dev.lazyz.jmh.report;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * Numbers that were measured, and facts about the machine and the run.
 *
 * <p>In a file, a fact is a line {@code # name: value}, and a number is a line of comma-separated values: quantity with
 * its unit, subject, program, round, value. Pages of the documentation show such files, which lie in folders beside
 * them.
 */
public final class Measurements {
    private static final String HEAD = "quantity,subject,program,round,value";
    private static final int COLUMNS = 5;
    private static final String FACT = "# ";

    private final Map<String, String> facts = new TreeMap<>();
    private final List<Value> values = new ArrayList<>();

    /**
     * One number.
     *
     * @param quantity what was measured, with its unit: {@code frame ms}
     * @param subject of what: a scene, a file, a point on an axis
     * @param program by which program, or with which setting
     * @param round number of the round, from 1; within a round, programs take turns. 0 is for what is measured once
     * @param value the number
     */
    public record Value(String quantity, String subject, String program, int round, double value) {
        /** Checks that texts can be stored. */
        public Value {
            for (String text : List.of(quantity, subject, program)) {
                if (text.isEmpty() || text.indexOf(',') >= 0 || text.indexOf('\n') >= 0 || text.startsWith("#")) {
                    throw new IllegalArgumentException("not a name for a column: '" + text + "'");
                }
            }
        }
    }

    /** Reads a file that {@link #write} has written. */
    public static Measurements read(Path file) throws IOException {
        Measurements read = new Measurements();
        for (String line : Files.readAllLines(file)) {
            if (line.startsWith(FACT)) {
                int at = line.indexOf(": ");
                read.facts.put(line.substring(FACT.length(), at), line.substring(at + 2));
            } else if (!line.equals(HEAD)) {
                String[] cells = line.split(",");
                if (cells.length != COLUMNS) {
                    throw new IllegalArgumentException(file + ": " + COLUMNS + " columns are expected: " + line);
                }
                read.values.add(new Value(
                        cells[0], cells[1], cells[2], Integer.parseInt(cells[3]), Double.parseDouble(cells[4])));
            }
        }
        return read;
    }

    /** Writes facts by name, and numbers in the order in which they were added. */
    public void write(Path file) throws IOException {
        List<String> lines = new ArrayList<>();
        facts.forEach((name, value) -> lines.add(FACT + name + ": " + value));
        lines.add(HEAD);
        for (Value value : values) {
            // Whole numbers have no decimals: most are bytes or counts
            String number = value.value == Math.rint(value.value) && Math.abs(value.value) < 1e15
                    ? Long.toString((long) value.value)
                    : Double.toString(value.value);
            lines.add(String.join(
                    ",", value.quantity, value.subject, value.program, Integer.toString(value.round), number));
        }
        Files.write(file, lines);
    }

    /** Facts by name. */
    public Map<String, String> facts() {
        return facts;
    }

    /** Records a fact; values of several runs are all kept. */
    public void note(String name, String value) {
        facts.merge(
                name, value, (before, now) -> List.of(before.split("; ")).contains(now) ? before : before + "; " + now);
    }

    /** Records the day, the machine and its Java. */
    public void noteMachine() throws IOException {
        note("date", LocalDate.now().toString());
        note("Java", Runtime.version().toString());
        note("system", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
        note("processors", Integer.toString(Runtime.getRuntime().availableProcessors()));
        Path processors = Path.of("/proc/cpuinfo");
        if (Files.exists(processors)) {
            Files.readString(processors)
                    .lines()
                    .filter(line -> line.startsWith("model name"))
                    .findFirst()
                    .ifPresent(line -> note("processor", line.substring(line.indexOf(':') + 2)));
        }
    }

    /** Adds a number, rounded to four decimals, and prints it. */
    public void add(String quantity, String subject, String program, int round, double value) {
        double rounded = Math.rint(1e4 * value) / 1e4;
        values.add(new Value(quantity, subject, program, round, rounded));
        System.out.printf(Locale.ROOT, "%-16s  %-40s  %-28s %d  %,.3f%n", quantity, subject, program, round, rounded);
    }

    /** Records the machine, and facts given as {@code --fact NAME=VALUE}. */
    public void noteMachine(Options options) throws IOException {
        noteMachine();
        for (String fact : options.all("fact")) {
            int at = fact.indexOf('=');
            note(fact.substring(0, at), fact.substring(at + 1));
        }
    }

    /** Removes numbers, because they are measured again. */
    public void removeIf(Predicate<Value> isOld) {
        values.removeIf(isOld);
    }

    /** Subjects of a quantity, in the order of measurement. */
    public List<String> subjects(String quantity) {
        return distinct(quantity, Value::subject);
    }

    /** Programs of a quantity, in the order of measurement. */
    public List<String> programs(String quantity) {
        return distinct(quantity, Value::program);
    }

    private List<String> distinct(String quantity, Function<Value, String> column) {
        return values.stream()
                .filter(value -> value.quantity.equals(quantity))
                .map(column)
                .distinct()
                .toList();
    }

    private List<Value> of(String quantity, String subject, String program) {
        return values.stream()
                .filter(value -> value.subject.equals(subject))
                .filter(value -> value.program.equals(program) && value.quantity.equals(quantity))
                .toList();
    }

    /** Returns the numbers of all rounds in ascending order. */
    public double[] ascending(String quantity, String subject, String program) {
        return of(quantity, subject, program).stream()
                .mapToDouble(Value::value)
                .sorted()
                .toArray();
    }

    /** Returns the median of the rounds; empty if there is none. */
    public OptionalDouble median(String quantity, String subject, String program) {
        return median(ascending(quantity, subject, program));
    }

    /**
     * Returns how many times as large the number of {@code base} is, for each round that has both, in ascending order.
     */
    public double[] ratios(String quantity, String subject, String program, String base) {
        return of(quantity, subject, program).stream()
                .flatMapToDouble(own -> of(quantity, subject, base).stream()
                        .filter(other -> other.round == own.round)
                        .mapToDouble(other -> other.value / own.value))
                .sorted()
                .toArray();
    }

    /** Returns the median of values in any order; empty if there is none. */
    public static OptionalDouble median(double... values) {
        double[] ascending = values.clone();
        Arrays.sort(ascending);
        int middle = ascending.length / 2;
        return ascending.length == 0
                ? OptionalDouble.empty()
                : OptionalDouble.of(
                        ascending.length % 2 == 1
                                ? ascending[middle]
                                : (ascending[middle - 1] + ascending[middle]) / 2);
    }
}
