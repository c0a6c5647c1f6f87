package dev.lazyz.jmh.growth;

import java.util.Locale;
import java.util.function.ToDoubleFunction;

/** A measured quantity of a rendering: one table and one chart for each axis. */
enum Quantity {
    TIME("time of a frame, ms", GrowthResults.Cost::millis),
    ALLOCATED("bytes allocated in a frame", GrowthResults.Cost::allocated),
    PEAK("working memory at its peak, bytes", GrowthResults.Cost::peak);

    final String title;
    final ToDoubleFunction<GrowthResults.Cost> of;

    Quantity(String title, ToDoubleFunction<GrowthResults.Cost> of) {
        this.title = title;
        this.of = of;
    }

    /** Name in files and on the page. */
    String id() {
        return name().toLowerCase(Locale.ROOT);
    }

    /**
     * Whether it has a table and a chart for an axis. With several threads, the figures for allocation do not cover
     * all threads.
     */
    boolean isShown(Axis axis) {
        return this == TIME || axis != Axis.THREADS && axis != Axis.SCENES;
    }

    /** Returns a value with about three digits. */
    String text(double value) {
        if (this == TIME) {
            return String.format(
                    Locale.ROOT, value < 0.1 ? "%.3f" : value < 10 ? "%.2f" : value < 100 ? "%.1f" : "%,.0f", value);
        }
        String[] units = {"B", "kB", "MB", "GB"};
        int unit = 0;
        double scaled = value;
        while (scaled >= 1000 && unit < units.length - 1) {
            scaled /= 1000;
            unit++;
        }
        return String.format(Locale.ROOT, scaled < 10 && unit > 0 ? "%.1f %s" : "%.0f %s", scaled, units[unit]);
    }
}
