package dev.lazyz.jmh.report;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.CategoryChartBuilder;
import org.knowm.xchart.ChartEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.AxesChartStyler;
import org.knowm.xchart.style.Styler;

/** Charts as PNG files, with logarithmic axes. */
public final class Charts {
    private static final int WIDTH = 1000;

    /** Ten easily distinguishable colours. */
    private static final Color[] COLORS = {
        new Color(0x1F77B4), new Color(0xFF7F0E), new Color(0x2CA02C), new Color(0xD62728), new Color(0x9467BD),
        new Color(0x8C564B), new Color(0xE377C2), new Color(0x7F7F7F), new Color(0xBCBD22), new Color(0x17BECF),
    };

    private Charts() {}

    /** Draws curves through points (x, y) that are positive, by name. */
    public static void curves(Path file, String title, String x, String y, Map<String, List<double[]>> curves)
            throws IOException {
        XYChart chart = new XYChartBuilder()
                .width(WIDTH)
                .height(620)
                .title(title)
                .xAxisTitle(x)
                .yAxisTitle(y)
                .build();
        chart.getStyler().setXAxisLogarithmic(true);
        chart.getStyler().setLegendPosition(Styler.LegendPosition.OutsideE);
        chart.getStyler().setSeriesColors(COLORS);
        List<Double> heights = new ArrayList<>();
        curves.forEach((name, curve) -> {
            if (!curve.isEmpty()) {
                chart.addSeries(
                        name,
                        curve.stream().mapToDouble(point -> point[0]).toArray(),
                        curve.stream().mapToDouble(point -> point[1]).toArray());
                curve.forEach(point -> heights.add(point[1]));
            }
        });
        style(chart.getStyler(), heights);
        ChartEncoder.saveChart(chart, file.toString(), "png");
    }

    /** Draws a group of bars for each subject, with a bar for each program; a height that is null has no bar. */
    public static void bars(Path file, String title, List<String> subjects, Map<String, List<Double>> programs)
            throws IOException {
        CategoryChart chart =
                new CategoryChartBuilder().width(WIDTH).height(420).title(title).build();
        chart.getStyler().setLegendPosition(Styler.LegendPosition.OutsideS);
        chart.getStyler().setLegendLayout(Styler.LegendLayout.Horizontal);
        chart.getStyler().setXAxisLabelRotation(45);
        chart.getStyler().setYAxisDecimalPattern("#0.####");
        // Bars begin at 1: above it is more, below less
        List<Double> heights = new ArrayList<>(List.of(1.0));
        programs.forEach((name, bars) -> {
            if (bars.stream().anyMatch(Objects::nonNull)) {
                chart.addSeries(name, subjects, bars);
                bars.stream().filter(Objects::nonNull).forEach(heights::add);
            }
        });
        style(chart.getStyler(), heights);
        ChartEncoder.saveChart(chart, file.toString(), "png");
    }

    /** Makes the vertical axis logarithmic, with whole decades: others would leave it with at most one number. */
    private static void style(AxesChartStyler styler, List<Double> heights) {
        styler.setYAxisLogarithmic(true);
        styler.setChartBackgroundColor(Color.WHITE);
        double least = heights.stream().mapToDouble(Double::doubleValue).min().orElse(1);
        double greatest =
                heights.stream().mapToDouble(Double::doubleValue).max().orElse(10);
        styler.setYAxisMin(Math.pow(10, Math.floor(Math.log10(least))));
        styler.setYAxisMax(Math.pow(10, Math.ceil(Math.log10(greatest))));
    }
}
