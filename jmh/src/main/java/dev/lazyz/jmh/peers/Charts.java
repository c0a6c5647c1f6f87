package dev.lazyz.jmh.peers;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.ChartEncoder;
import org.knowm.xchart.style.Styler;

/** Draws bar charts of how many times faster than the base each renderer is, for each scene. */
final class Charts {
    private static final int WIDTH = 1000;
    private static final int HEIGHT = 420;

    private final Results results;

    Charts(Results results) {
        this.results = results;
    }

    /** Writes a PNG file for each table of times that has a chart. */
    void write(Path folder) throws IOException {
        write(folder, PerformancePage::isCompared);
        write(folder, PerformancePage::isOther);
    }

    private void write(Path folder, Predicate<Results.Time> which) throws IOException {
        Map<String, List<Results.Time>> groups = new PerformancePage(results).groups(which);
        for (Map.Entry<String, List<Results.Time>> group : groups.entrySet()) {
            Optional<String> name = fileName(group.getValue());
            if (name.isPresent()) {
                CategoryChart chart = chart(group.getKey(), group.getValue());
                ChartEncoder.saveChart(chart, folder.resolve(name.get()).toString(), "png");
            }
        }
    }

    /**
     * Returns the name of the chart of a table's times, if it has a chart: {@code compared-1024-1.png} is S1 to S6 at
     * 1024 x 1024, one thread. A table without times of the base has no chart.
     */
    static Optional<String> fileName(List<Results.Time> times) {
        if (times.stream().noneMatch(time -> time.contender().equals(Results.BASE))) {
            return Optional.empty();
        }
        Results.Time any = times.get(0);
        String kind = PerformancePage.isCompared(any) ? "compared" : "others";
        return Optional.of(kind + "-" + any.side() + "-" + any.threads() + ".png");
    }

    private static CategoryChart chart(String title, List<Results.Time> times) {
        CategoryChart chart = new CategoryChartBuilder()
                .width(WIDTH)
                .height(HEIGHT)
                .title("Times faster than " + Results.BASE + ": " + title)
                .build();
        chart.getStyler().setYAxisLogarithmic(true);
        chart.getStyler().setLegendPosition(Styler.LegendPosition.OutsideS);
        chart.getStyler().setLegendLayout(Styler.LegendLayout.Horizontal);
        chart.getStyler().setChartBackgroundColor(Color.WHITE);
        chart.getStyler().setYAxisDecimalPattern("#0.####");
        List<String> scenes =
                PerformancePage.distinct(times.stream().map(Results.Time::scene).toList());
        double least = 1;
        double greatest = 1;
        for (String contender : PerformancePage.distinct(
                times.stream().map(Results.Time::contender).toList())) {
            if (contender.equals(Results.BASE)) {
                continue;
            }
            List<Double> bars = new ArrayList<>();
            for (String scene : scenes) {
                double[] ratios = PerformancePage.ratios(times, scene, contender);
                bars.add(ratios.length == 0 ? null : (Double) PerformancePage.median(ratios));
                for (double ratio : ratios) {
                    least = Math.min(least, ratio);
                    greatest = Math.max(greatest, ratio);
                }
            }
            if (bars.stream().anyMatch(Objects::nonNull)) {
                chart.addSeries(contender, scenes, bars);
            }
        }

        // Full decades, because bars begin at the lower end of the axis
        chart.getStyler().setYAxisMin(Math.pow(10, Math.floor(Math.log10(least))));
        chart.getStyler().setYAxisMax(Math.pow(10, Math.ceil(Math.log10(greatest))));
        return chart;
    }
}
