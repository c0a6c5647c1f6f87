package example;

import dev.lazyz.spi.Fragment;
import dev.lazyz.spi.Shader;

/** Squares of two colours in texture space, lit from one side of the world: from -x and +z. */
public class Checkers implements Shader {
    private final int squares;

    /** @param squares how many squares there are along each side of the texture */
    public Checkers(int squares) {
        this.squares = squares;
    }

    @Override
    public void shade(Fragment fragment) {
        // Which square
        int column = (int) Math.floor(fragment.u * squares);
        int row = (int) Math.floor(fragment.v * squares);
        float base = (column + row) % 2 == 0 ? 0.8f : 0.05f;

        // How much light, by the angle to the normal; only + - * / and sqrt give the same bits everywhere
        float x = fragment.normalX;
        float y = fragment.normalY;
        float z = fragment.normalZ;
        float length = (float) Math.sqrt(x * x + y * y + z * z);
        float light = length > 0f ? Math.max(0f, (z - x) / (1.4142135f * length)) : 1f;
        fragment.setColor(base * light, base * light, base * light);
    }
}
