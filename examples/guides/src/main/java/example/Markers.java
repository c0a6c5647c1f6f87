package example;

import dev.lazyz.Primitive;
import dev.lazyz.Raster;
import dev.lazyz.geometry.Box;
import dev.lazyz.world.surface.SetUp.ScreenPoint;
import dev.lazyz.world.surface.SetUp;
import dev.lazyz.world.surface.Surface;
import java.util.ArrayList;
import java.util.List;
import kotlin.sequences.Sequence;
import org.joml.Vector3dc;

/** Discs at places of the world that have the same size at any distance: a surface that Lazy Z does not have. */
public class Markers implements Surface {
    private final List<Vector3dc> places;
    private final int radius;

    /** @param radius in pixels */
    public Markers(List<Vector3dc> places, int radius) {
        this.places = List.copyOf(places);
        this.radius = radius;
    }

    @Override
    public Box getBounds() {
        return places.stream()
                .map(it -> new Box(it.x(), it.y(), it.z(), it.x(), it.y(), it.z()))
                .reduce(Box::union)
                .orElse(null);
    }

    @Override
    public Sequence<Primitive> primitives(SetUp setUp) {
        Raster raster = setUp.getRaster();
        List<Primitive> discs = new ArrayList<>();
        for (Vector3dc place : places) {
            ScreenPoint at = setUp.project(place);
            int x = at == null ? 0 : (int) Math.floor(at.getX());
            int y = at == null ? 0 : (int) Math.floor(at.getY());
            discs.add(new Disc(raster, x, y, at == null ? -1 : radius, at == null ? 0 : at.getDepth()));
        }
        return discs::iterator;
    }

    @Override
    public Markers magnified(int factor) {
        return new Markers(places, factor * radius);
    }
}
