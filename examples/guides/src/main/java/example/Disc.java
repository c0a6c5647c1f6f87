package example;

import dev.lazyz.Primitive;
import dev.lazyz.Raster;
import dev.lazyz.spi.Fragment;
import dev.lazyz.spi.Spans;

/** A disc on the screen, at one depth: a primitive that Lazy Z does not have. */
public class Disc implements Primitive {
    private final Raster raster;
    private final int centerX;
    private final int centerY;
    private final int radius;
    private final int depth;

    /**
     * @param radius in samples; a negative one covers nothing
     * @param depth 0, near, to 2^31-2, far; the background is at 2^31-1
     */
    public Disc(Raster raster, int centerX, int centerY, int radius, int depth) {
        this.raster = raster;
        this.centerX = centerX;
        this.centerY = centerY;
        this.radius = radius;
        this.depth = depth;
    }

    @Override
    public int getRowStart() {
        return Math.max(centerY - radius, 0);
    }

    @Override
    public int getRowEnd() {
        return Math.min(centerY + radius + 1, raster.getHeight());
    }

    @Override
    public int getColumnStart() {
        return Math.max(centerX - radius, 0);
    }

    @Override
    public int getColumnEnd() {
        return Math.min(centerX + radius + 1, raster.getWidth());
    }

    @Override
    public void spans(int y, Spans spans) {
        long rest = (long) radius * radius - (long) (y - centerY) * (y - centerY);
        if (radius < 0 || rest < 0) return;
        int half = (int) Math.sqrt(rest);
        int start = Math.max(centerX - half, 0);
        int end = Math.min(centerX + half + 1, raster.getWidth());
        if (start < end) spans.add(start, end);
    }

    @Override
    public int depth(int x, int y) {
        return depth;
    }

    @Override
    public void shade(Fragment fragment) {
        float distance = Math.abs(fragment.getX() - centerX) / (float) radius;
        fragment.setColor(1f - 0.5f * distance, 0.4f, 0.1f);
    }
}
