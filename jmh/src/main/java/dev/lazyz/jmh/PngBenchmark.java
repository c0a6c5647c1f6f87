package dev.lazyz.jmh;

import dev.lazyz.Image;
import dev.lazyz.Image.PixelHash;
import dev.lazyz.jmh.workload.Workloads;
import dev.lazyz.scenes.writers.Images;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import javax.imageio.ImageIO;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** The time to write an image to a PNG file, compared with Java's own writer for the same pixels. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@State(Scope.Benchmark)
public class PngBenchmark {
    /** A scene's id, see {@link Workloads}. */
    @Param({"teapot", "city", "S1"})
    public String scene;

    /** Width and height of the image, samples. */
    @Param({"1024"})
    public int side;

    private Image image;
    private BufferedImage picture;
    private Path file;

    /** Renders the image, and fails if the written file contains different pixels. */
    @Setup
    public void setUp() throws InterruptedException, IOException {
        image = PictureCheck.renderer("zbuffer").render(Workloads.scene(scene).frame(side, side));
        picture = opaque(image);
        file = Files.createTempFile("lazyz-", ".png");
        PictureCheck.verify(hash(write()), image.pixelHash(), "the file");
    }

    /** Removes the file. */
    @TearDown
    public void tearDown() throws IOException {
        Files.delete(file);
    }

    /** Writes the file. */
    @Benchmark
    public Path write() throws IOException {
        Images.writePng(image, file);
        return file;
    }

    /** Writes the same file with javax.imageio. */
    @Benchmark
    public Path imageIo() throws IOException {
        ImageIO.write(picture, "png", file.toFile());
        return file;
    }

    /** Returns an image without an alpha channel, as the project's writer writes it. */
    private static BufferedImage opaque(Image image) {
        BufferedImage picture = new BufferedImage(image.getWidth(), image.getHeight(), BufferedImage.TYPE_3BYTE_BGR);
        picture.createGraphics().drawImage(Images.toBufferedImage(image), 0, 0, null);
        return picture;
    }

    private static String hash(Path file) throws IOException {
        BufferedImage read = ImageIO.read(file.toFile());
        int width = read.getWidth();
        PixelHash hash = new PixelHash();
        for (int y = 0; y < read.getHeight(); y++) {
            hash.add(read.getRGB(0, y, width, 1, null, 0, width), width);
        }
        return hash.digest();
    }
}
