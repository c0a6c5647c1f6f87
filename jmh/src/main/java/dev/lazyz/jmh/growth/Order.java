package dev.lazyz.jmh.growth;

import java.util.Set;

/**
 * A theoretical order of growth: n triangles, p pixels, d layers, c rounds.
 *
 * @param text the order
 * @param least smallest slope on log-log at the end of the curve that is consistent with the order
 * @param greatest greatest such slope
 */
record Order(String text, double least, double greatest) {
    private static final double SLACK = 0.15;

    /** Strategies that keep only one row, or a few rows, in memory at a time. */
    private static final Set<String> ROWS = Set.of("tiled", "lazy", "flow", "lists", "scanline", "warnock");

    private static Order of(String text, double slope) {
        return new Order(text, slope, slope);
    }

    /** Whether a slope is inconsistent with this order. */
    boolean isDeparture(double slope) {
        return slope < least - SLACK || slope > greatest + SLACK;
    }

    /** Returns the order in which a strategy's time grows along an axis that has one. */
    static Order time(Axis axis, String strategy) {
        return switch (axis) {
            case TRIANGLES -> Set.of("tiled", "zbuffer", "hybrid").contains(strategy) ? of("n", 1) : of("n log n", 1);
            case SMALL -> new Order("1 + p", 0, 1);
            case PIXELS -> strategy.equals("scanline") ? new Order("p + √p", 0.5, 1) : of("p", 1);
            case DEPTH ->
                switch (strategy) {
                    case "tiled", "warnock" -> new Order("p + d", 0, 1);
                    case "hierarchical" -> new Order("p + d log d", 0, 1);
                    case "scanline" -> new Order("p + √p d log d", 0, 1);
                    default -> of("p d", 1);
                };
            case SHADING -> of("p c", 1);
            default -> throw new IllegalArgumentException(axis.id());
        };
    }

    /** Returns the order in which a strategy's working memory grows along an axis that has one. */
    static Order memory(Axis axis, String strategy) {
        return switch (axis) {
            case TRIANGLES ->
                switch (strategy) {
                    case "zbuffer" -> of("1", 0);
                    case "hybrid" -> new Order("p + visible n", 0, 1);
                    case "painter", "hierarchical" -> new Order("p + n", 0, 1);
                    default -> new Order("√n + n", 0.5, 1);
                };
            case PIXELS, SMALL -> ROWS.contains(strategy) ? new Order("n + √p", 0, 0.5) : new Order("n + p", 0, 1);
            case DEPTH ->
                switch (strategy) {
                    case "zbuffer" -> of("1", 0);
                    case "lists" -> of("√p d up to a bound", 1);
                    case "hybrid", "painter", "hierarchical" -> new Order("p + d", 0, 1);
                    default -> new Order("√p + d", 0, 1);
                };
            case SHADING -> of("1", 0);
            default -> throw new IllegalArgumentException(axis.id());
        };
    }
}
