package dev.lazyz.jmh.growth;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.knowm.xchart.ChartEncoder;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import org.knowm.xchart.style.Styler;

/** Draws the curves of each axis and quantity on logarithmic axes. */
final class GrowthCharts {
    private static final int WIDTH = 1000;
    private static final int HEIGHT = 620;

    /** Ten easily distinguishable colours. */
    private static final Color[] COLORS = {
        new Color(0x1F77B4), new Color(0xFF7F0E), new Color(0x2CA02C), new Color(0xD62728), new Color(0x9467BD),
        new Color(0x8C564B), new Color(0xE377C2), new Color(0x7F7F7F), new Color(0xBCBD22), new Color(0x17BECF),
    };

    private final GrowthResults results;

    GrowthCharts(GrowthResults results) {
        this.results = results;
    }

    /** Writes a PNG file for each axis and quantity that has figures. */
    void write(Path folder) throws IOException {
        for (Axis axis : Axis.values()) {
            for (Quantity quantity : Quantity.values()) {
                if (axis != Axis.SCENES
                        && quantity.isShown(axis)
                        && !results.points(axis).isEmpty()) {
                    ChartEncoder.saveChart(
                            chart(axis, quantity),
                            folder.resolve(fileName(axis, quantity)).toString(),
                            "png");
                }
            }
        }
    }

    static String fileName(Axis axis, Quantity quantity) {
        return axis.id() + "-" + quantity.id() + ".png";
    }

    private XYChart chart(Axis axis, Quantity quantity) {
        XYChart chart = new XYChartBuilder()
                .width(WIDTH)
                .height(HEIGHT)
                .title(quantity.title + ", by " + axis.title)
                .xAxisTitle(axis.title)
                .yAxisTitle(quantity.title)
                .build();
        chart.getStyler().setXAxisLogarithmic(true);
        chart.getStyler().setYAxisLogarithmic(true);
        chart.getStyler().setLegendPosition(Styler.LegendPosition.OutsideE);
        chart.getStyler().setChartBackgroundColor(Color.WHITE);
        chart.getStyler().setSeriesColors(COLORS);
        double least = Double.MAX_VALUE;
        double greatest = 0;
        for (String strategy : results.strategies(axis)) {
            List<double[]> curve = results.curve(axis, strategy, quantity);
            if (!curve.isEmpty()) {
                chart.addSeries(
                        strategy,
                        curve.stream().mapToDouble(point -> point[0]).toArray(),
                        curve.stream().mapToDouble(point -> point[1]).toArray());
            }
            for (double[] point : curve) {
                least = Math.min(least, point[1]);
                greatest = Math.max(greatest, point[1]);
            }
        }

        // A range of less than a decade would leave the axis with at most one number
        if (greatest < 10 * least) {
            chart.getStyler().setYAxisMin(Math.pow(10, Math.floor(Math.log10(least))));
            chart.getStyler().setYAxisMax(Math.pow(10, Math.ceil(Math.log10(greatest))));
        }
        if (axis == Axis.THREADS) {
            chart.getStyler().setXAxisMax(10.0);
        }
        return chart;
    }
}
