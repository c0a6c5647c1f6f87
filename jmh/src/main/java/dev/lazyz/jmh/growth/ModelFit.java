package dev.lazyz.jmh.growth;

import dev.lazyz.Capability;
import dev.lazyz.Renderer;
import dev.lazyz.jmh.report.Measurements;
import dev.lazyz.strategies.FrameNumbers;
import dev.lazyz.strategies.Renderers;
import dev.lazyz.strategies.StrategyMemory;
import dev.lazyz.strategies.StrategyModel;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;

/**
 * Fits {@link StrategyModel} to the measurements: for each strategy it finds the non-negative coefficients that
 * minimise the sum of squared relative errors.
 */
final class ModelFit {
    private static final int SWEEPS = 50_000;
    private static final double NANOS = 1e6;

    /** A term is omitted if its share of the total is below this at every point. */
    private static final double NEGLIGIBLE = 1e-3;

    private final Measurements results;
    private final Map<String, double[]> nanoseconds = new HashMap<>();

    ModelFit(Measurements results) {
        this.results = results;
    }

    /** Returns nanoseconds for each of the model's terms. */
    double[] nanoseconds(String strategy) {
        return nanoseconds.computeIfAbsent(
                strategy, id -> fit(id, Growth.TIME, NANOS, numbers -> colored(id, StrategyModel.timeTerms(numbers))));
    }

    /**
     * Clears the term of the colours that a strategy does not compute: a strategy computes either late or early
     * colours.
     */
    private static double[] colored(String strategy, double[] terms) {
        boolean isLate = Renderers.find(strategy).getCapabilities().contains(Capability.SHADES_ONLY_VISIBLE);
        terms[StrategyModel.getTimeTermNames().indexOf(isLate ? "early colours" : "late colours")] = 0;
        return terms;
    }

    /** Returns the model's estimate for a strategy with one thread, milliseconds. */
    double milliseconds(String strategy, FrameNumbers numbers) {
        double[] terms = StrategyModel.timeTerms(numbers);
        double sum = 0;
        for (int i = 0; i < terms.length; i++) {
            sum += nanoseconds(strategy)[i] * terms[i];
        }
        return sum / NANOS;
    }

    /** Returns bytes for each of the model's terms. */
    double[] bytes(String strategy) {
        return fit(strategy, Growth.PEAK, 1, StrategyMemory::terms);
    }

    /**
     * Returns the serial share of a strategy's time, computed from one and two threads; empty if it was not measured.
     */
    OptionalDouble serialShare(String strategy) {
        double[] times = new double[3];
        for (int threads = 1; threads < times.length; threads++) {
            times[threads] = results.median(Growth.TIME, GrowthAxis.THREADS.subject(threads), strategy)
                    .orElse(0);
        }
        return times[1] == 0 || times[2] == 0
                ? OptionalDouble.empty()
                : OptionalDouble.of(rounded(Math.min(1, Math.max(0, 2 * times[2] / times[1] - 1))));
    }

    /** Fits a quantity to all points with one thread but those of the built-in scenes. */
    private double[] fit(String strategy, String quantity, double unit, Function<FrameNumbers, double[]> terms) {
        List<double[]> rows = new ArrayList<>();
        for (GrowthAxis axis : GrowthAxis.values()) {
            for (long point : axis.values) {
                OptionalDouble value = results.median(quantity, axis.subject(point), strategy);
                if (value.isPresent() && axis.threads(point) == 1 && axis != GrowthAxis.SCENES) {
                    double[] row = terms.apply(Curve.numbers(results, axis, point));
                    for (int i = 0; i < row.length; i++) {
                        row[i] /= value.getAsDouble() * unit;
                    }
                    rows.add(row);
                }
            }
        }
        double[] coefficients = leastSquares(rows);
        for (int i = 0; i < coefficients.length; i++) {
            int term = i;
            double share = rows.stream().mapToDouble(row -> row[term]).max().orElse(0) * coefficients[i];
            coefficients[i] = share < NEGLIGIBLE ? 0 : rounded(coefficients[i]);
        }
        return coefficients;
    }

    /** Returns the non-negative coefficients that bring each row's sum closest to 1, by repeated coordinate descent. */
    static double[] leastSquares(List<double[]> rows) {
        int count = rows.get(0).length;
        double[][] columns = new double[count][rows.size()];
        double[] squares = new double[count];
        for (int i = 0; i < count; i++) {
            for (int k = 0; k < rows.size(); k++) {
                columns[i][k] = rows.get(k)[i];
                squares[i] += columns[i][k] * columns[i][k];
            }
        }
        double[] coefficients = new double[count];
        double[] rest = new double[rows.size()];
        Arrays.fill(rest, 1);
        boolean isChanged = true;
        for (int sweep = 0; sweep < SWEEPS && isChanged; sweep++) {
            isChanged = false;
            for (int i = 0; i < count; i++) {
                double[] column = columns[i];
                double slope = 0;
                for (int k = 0; k < rest.length; k++) {
                    slope += column[k] * rest[k];
                }
                double better = squares[i] == 0 ? 0 : Math.max(0, coefficients[i] + slope / squares[i]);
                double step = better - coefficients[i];
                if (step == 0) {
                    continue;
                }
                isChanged = true;
                for (int k = 0; k < rest.length; k++) {
                    rest[k] -= step * column[k];
                }
                coefficients[i] = better;
            }
        }
        return coefficients;
    }

    /** Returns all strategies that were measured, in the order of the built-in list. */
    List<String> strategies() {
        List<String> measured = results.programs(Growth.TIME);
        return Renderers.getBuiltIn().stream()
                .map(Renderer::getId)
                .filter(measured::contains)
                .toList();
    }

    private static double rounded(double value) {
        return new BigDecimal(value).round(new MathContext(3)).doubleValue();
    }

    /** Returns the Kotlin file with the coefficients. */
    String toKotlin() {
        List<String> shares = strategies().stream()
                .filter(strategy -> serialShare(strategy).isPresent())
                .map(strategy ->
                        "\"" + strategy + "\" to " + serialShare(strategy).getAsDouble())
                .toList();
        return String.format(Locale.ROOT, """
                package dev.lazyz.strategies

                /**
                 * Coefficients of [StrategyModel] and [StrategyMemory], fitted to `docs/growth/results.csv`.
                 * Generated by the command that measures them; do not edit.
                 */
                internal object StrategyCosts {
                    /** Nanoseconds for each of [StrategyModel.timeTermNames]. */
                    val nanoseconds: Map<String, DoubleArray> = mapOf(
                %s    )

                    /** Bytes for each of [StrategyMemory.termNames]. */
                    val bytes: Map<String, DoubleArray> = mapOf(
                %s    )

                    /** The part of the time that threads do not share. */
                    val serialShares: Map<String, Double> = mapOf(%s)
                }
                """, lines(this::nanoseconds), lines(this::bytes), String.join(", ", shares));
    }

    private String lines(Function<String, double[]> coefficients) {
        StringBuilder text = new StringBuilder();
        for (String strategy : strategies()) {
            List<String> numbers = new ArrayList<>();
            for (double number : coefficients.apply(strategy)) {
                numbers.add(Double.toString(number));
            }
            text.append("        \"" + strategy + "\" to doubleArrayOf(" + String.join(", ", numbers) + "),\n");
        }
        return text.toString();
    }
}
