import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Hashtable;
import java.util.Locale;
import java.util.Map;
import javajs.util.M3;
import javajs.util.P3;
import org.jmol.script.T;
import org.jmol.util.GData;
import org.jmol.viewer.JC;
import org.jmol.viewer.Viewer;

/**
 * Draws a file of triangles with the software renderer of Jmol, and prints one line of JSON.
 *
 * <p>{@code java -Djava.awt.headless=true -cp jmol.jar JmolPeer.java FILE [--side N] [--warm-up SECONDS] [--measure
 * SECONDS] [--picture FILE]}
 *
 * <p>Options and output are those of {@code llvmpipe.c}. Jmol moves vertices to whole pixels and lets neighbours
 * overlap by one, interpolates no colour that is not of its palette (so each triangle gets that of its first vertex),
 * and neither clips nor divides by w here: scenes under perspective and rounds of shading are refused.
 */
public final class JmolPeer {
    private static final int LEAST_FRAMES = 5;
    private static final int ROUNDS = 2;

    /** Depths of Jmol are whole; more than these lose their last bits in its floats. */
    private static final float DEPTHS = 1 << 20;

    private final int side;
    private final float[] matrix = new float[16];
    private final float[] positions;
    private final int[] corners;
    private final int[] colors;
    private final P3[] screen;
    private final GData graphics;
    private final M3 noRotation = new M3();

    private JmolPeer(Path file, int side) throws IOException {
        this.side = side;
        ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
        byte[] magic = new byte[8];
        bytes.get(magic);
        if (!new String(magic, StandardCharsets.US_ASCII).equals("LZTRI001")) {
            throw new IOException("not a file of triangles");
        }
        if (bytes.getInt() == ROUNDS || bytes.getInt() == 1) {
            throw new IOException("Jmol does not draw this scene");
        }
        int vertices = bytes.getInt();
        int indices = bytes.getInt();
        for (int i = 0; i < 16; i++) {
            matrix[i] = bytes.getFloat();
        }
        positions = new float[3 * vertices];
        int[] vertexColors = new int[vertices];
        for (int vertex = 0; vertex < vertices; vertex++) {
            for (int i = 0; i < 3; i++) {
                positions[3 * vertex + i] = bytes.getFloat();
            }
            int color = 0xFF000000;
            for (int i = 0; i < 3; i++) {
                color |= (bytes.get() & 0xFF) << 16 - 8 * i;
            }
            bytes.get();
            vertexColors[vertex] = color;
        }
        corners = new int[indices > 0 ? indices : vertices];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = indices > 0 ? bytes.getInt() : i;
        }
        colors = new int[corners.length / 3];
        for (int i = 0; i < colors.length; i++) {
            colors[i] = vertexColors[corners[3 * i]];
        }
        screen = new P3[vertices];
        Arrays.setAll(screen, i -> new P3());
        noRotation.setScale(1);

        Map<String, Object> options = new Hashtable<>();
        options.put("platform", "org.jmol.awt.Platform");
        options.put("options", "-n -i");
        Viewer viewer = new Viewer(options);
        viewer.setScreenDimension(side, side);
        viewer.tm.perspectiveDepth = false;
        graphics = viewer.gdata;
        graphics.setWindowParameters(side, side, false);
        graphics.setBackgroundArgb(0xFF000000);
        graphics.addRenderer(T.triangles);
    }

    private void draw() {
        float[] m = matrix;
        for (int i = 0; i < screen.length; i++) {
            float x = positions[3 * i];
            float y = positions[3 * i + 1];
            float z = positions[3 * i + 2];
            screen[i].set(
                    ((m[0] * x + m[4] * y + m[8] * z + m[12]) + 1) / 2 * side - 0.5f,
                    (1 - (m[1] * x + m[5] * y + m[9] * z + m[13])) / 2 * side - 0.5f,
                    2 + ((m[2] * x + m[6] * y + m[10] * z + m[14]) + 1) / 2 * DEPTHS);
        }
        graphics.beginRendering(noRotation, false, false, false);
        graphics.setSlab(0);
        graphics.setDepth(Integer.MAX_VALUE);
        org.jmol.api.JmolRendererInterface renderer = (org.jmol.api.JmolRendererInterface) graphics;
        for (int i = 0; i < colors.length; i++) {
            graphics.setColor(colors[i]);
            renderer.fillTriangle3i(
                    screen[corners[3 * i]], screen[corners[3 * i + 1]], screen[corners[3 * i + 2]], null, null, null, false);
        }
        graphics.endRendering();
    }

    private double frame() {
        long start = System.nanoTime();
        draw();
        return (System.nanoTime() - start) / 1e6;
    }

    private int[] pixels() {
        BufferedImage image = (BufferedImage) graphics.getScreenImage(false);
        return image.getRGB(0, 0, side, side, null, 0, side);
    }

    private String write(Path file) throws IOException {
        draw();
        byte[] picture = new byte[4 * side * side];
        int covered = 0;
        int at = 0;
        for (int pixel : pixels()) {
            boolean isCovered = (pixel & 0xFFFFFF) != 0;
            covered += isCovered ? 1 : 0;
            picture[at++] = (byte) (pixel >> 16);
            picture[at++] = (byte) (pixel >> 8);
            picture[at++] = (byte) pixel;
            picture[at++] = (byte) (isCovered ? 255 : 0);
        }
        Files.write(file, picture);
        return String.format(Locale.ROOT, "{\"covered\":%d}", covered);
    }

    private String measure(double warmUp, double seconds) {
        double first = frame();
        for (long end = System.nanoTime() + (long) (1e9 * warmUp); System.nanoTime() < end; ) {
            frame();
        }
        double[] times = new double[1 << 16];
        int count = 0;
        long end = System.nanoTime() + (long) (1e9 * seconds);
        while (count < times.length && (count < LEAST_FRAMES || System.nanoTime() < end)) {
            times[count++] = frame();
        }
        Arrays.sort(times, 0, count);
        return String.format(
                Locale.ROOT,
                "{\"median\":%.4f,\"q1\":%.4f,\"q3\":%.4f,\"min\":%.4f,\"max\":%.4f,\"first\":%.2f,\"frames\":%d,"
                        + "\"version\":\"%s, Java %s\"}",
                times[count / 2],
                times[count / 4],
                times[3 * count / 4],
                times[0],
                times[count - 1],
                first,
                count,
                JC.version,
                Runtime.version());
    }

    /** Options: see above. */
    public static void main(String[] args) throws IOException {
        Map<String, String> options = new Hashtable<>();
        for (int i = 1; i + 1 < args.length; i += 2) {
            options.put(args[i], args[i + 1]);
        }
        JmolPeer peer = new JmolPeer(Path.of(args[0]), Integer.parseInt(options.getOrDefault("--side", "1024")));
        String picture = options.get("--picture");
        System.out.println(
                picture != null
                        ? peer.write(Path.of(picture))
                        : peer.measure(
                                Double.parseDouble(options.getOrDefault("--warm-up", "1.5")),
                                Double.parseDouble(options.getOrDefault("--measure", "4"))));
        System.exit(0);
    }
}
