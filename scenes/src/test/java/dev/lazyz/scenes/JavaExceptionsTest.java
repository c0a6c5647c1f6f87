package dev.lazyz.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;

import dev.lazyz.Counters;
import dev.lazyz.Image;
import dev.lazyz.RowSink;
import dev.lazyz.aov.Aov;
import dev.lazyz.aov.AovImage;
import dev.lazyz.scenes.aov.AovFiles;
import dev.lazyz.scenes.html.Html;
import dev.lazyz.scenes.pictures.Picture;
import dev.lazyz.scenes.scenefile.SceneFile;
import dev.lazyz.scenes.writers.AlphaChannel;
import dev.lazyz.scenes.writers.ImageFiles;
import dev.lazyz.scenes.writers.Images;
import dev.lazyz.scenes.writers.PfmSink;
import dev.lazyz.scenes.writers.PngSink;
import dev.lazyz.scenes.writers.PpmSink;
import dev.lazyz.scenes.writers.animation.Animation;
import dev.lazyz.scenes.writers.animation.AnimationFiles;
import dev.lazyz.scenes.writers.animation.ApngSink;
import dev.lazyz.scenes.writers.animation.GifSink;
import dev.lazyz.scenes.writers.deepzoom.DeepZoomFiles;
import dev.lazyz.scenes.writers.deepzoom.DeepZoomSink;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Java catches a checked exception only where a method declares it: this class does not compile if one of these
 * declarations is missing.
 */
class JavaExceptionsTest {
    private static final int[] ROW = new int[4];

    @TempDir
    Path folder;

    private final List<String> caught = new ArrayList<>();
    private final Image image = new Image(2, 2, ROW, ROW, ROW, Counters.NONE);

    /** A folder that does not exist. */
    private Path missing(String name) {
        return folder.resolve("missing").resolve(name);
    }

    private static int send(RowSink sink) throws IOException {
        for (int y = 0; y < 2; y++) {
            sink.row(y, ROW, ROW, ROW);
        }
        return 2;
    }

    /** A stream that fails. */
    private static OutputStream broken() {
        return new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("broken");
            }
        };
    }

    @Test
    void picturesInMemory() {
        try {
            Images.writePng(image, missing("a.png"));
        } catch (IOException e) {
            caught.add("png");
        }
        try {
            Images.writePng(image, broken());
        } catch (IOException e) {
            caught.add("stream");
        }
        try {
            Images.writePpm(image, missing("a.ppm"));
        } catch (IOException e) {
            caught.add("ppm");
        }
        try {
            Images.writePfm(image, missing("a.pfm"));
        } catch (IOException e) {
            caught.add("pfm");
        }
        try {
            Images.sendTo(image, (y, argb, depth, primitive) -> {
                throw new IOException("broken");
            });
        } catch (IOException e) {
            caught.add("sink");
        }
        assertEquals(List.of("png", "stream", "ppm", "pfm", "sink"), caught);
    }

    @Test
    void filesOfOtherKinds() {
        try {
            SceneFile.write(Scenes.teapot(), missing("a.json"));
        } catch (IOException e) {
            caught.add("scene");
        }
        AovImage aov = new AovImage(Aov.OBJECT, image.getRegion(), new int[4]);
        try {
            AovFiles.write(missing("a.npy"), aov);
        } catch (IOException e) {
            caught.add("aov");
        }
        try {
            AovFiles.write(missing("a.npz"), List.of(aov));
        } catch (IOException e) {
            caught.add("aovs");
        }
        try {
            Html.write(missing("a.html"), "");
        } catch (IOException e) {
            caught.add("html");
        }
        try {
            DeepZoomFiles.publish(missing("a.dzi"), folder, 2, 2);
        } catch (IOException e) {
            caught.add("publish");
        }
        assertEquals(List.of("scene", "aov", "aovs", "html", "publish"), caught);
    }

    @Test
    void models() {
        Path none = missing("a.obj");
        try {
            Scenes.load(none);
        } catch (IOException e) {
            caught.add("model");
        }
        try {
            Scenes.load(new byte[] {1}, SceneFormat.OBJ);
        } catch (SceneReadException e) {
            caught.add("unreadable");
        } catch (SceneFormatException e) {
            caught.add("bytes");
        }
        try {
            Scenes.stream(none).close();
        } catch (IOException e) {
            caught.add("stream");
        }
        try {
            Scenes.texture(none);
        } catch (IOException e) {
            caught.add("texture");
        }
        try {
            Picture.read(none);
        } catch (IOException e) {
            caught.add("picture");
        }
        try {
            SceneFile.parse("{");
        } catch (IOException e) {
            caught.add("scene");
        }
        assertEquals(List.of("model", "bytes", "stream", "texture", "picture", "scene"), caught);
    }

    /** The file that is written is not what is wrong. */
    @Test
    void modelsThatAreDrawnIntoAFile() throws InterruptedException {
        try {
            ImageFiles.write(folder.resolve("a.png"), 2, 2, sink -> {
                Scenes.load(missing("a.obj"));
                return send(sink);
            });
        } catch (IOException e) {
            caught.add(e.getMessage());
        }
        assertEquals(List.of(missing("a.obj") + ": there is no such file; check the name"), caught);
    }

    @Test
    void renderings() {
        Thread.currentThread().interrupt();
        try {
            ImageFiles.write(folder.resolve("a.png"), 2, 2, JavaExceptionsTest::send);
        } catch (IOException e) {
            caught.add("failed");
        } catch (InterruptedException e) {
            caught.add("picture");
        }
        Thread.currentThread().interrupt();
        try {
            AnimationFiles.write(folder.resolve("a.gif"), new Animation(2, 2, 1), JavaExceptionsTest::send);
        } catch (IOException e) {
            caught.add("failed");
        } catch (InterruptedException e) {
            caught.add("animation");
        }
        Thread.currentThread().interrupt();
        try {
            DeepZoomFiles.write(folder.resolve("a.dzi"), 2, 2, JavaExceptionsTest::send);
        } catch (IOException e) {
            caught.add("failed");
        } catch (InterruptedException e) {
            caught.add("pyramid");
        }
        Thread.currentThread().interrupt();
        try {
            DeepZoomFiles.resume(
                    folder.resolve("a.dzi"), 2, 2, AlphaChannel.KEEP, Map.of(), (sink, first) -> send(sink));
        } catch (IOException e) {
            caught.add("failed");
        } catch (InterruptedException e) {
            caught.add("resumed");
        }
        assertEquals(List.of("picture", "animation", "pyramid", "resumed"), caught);
    }

    @Test
    void sinksOfStreams() {
        try (PngSink sink = new PngSink(OutputStream.nullOutputStream(), 2, 2)) {
            sink.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("png");
        }
        try (PpmSink sink = new PpmSink(broken(), 2, 2)) {
            sink.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("ppm");
        }
        try (ApngSink sink = new ApngSink(broken(), new Animation(2, 2, 1))) {
            sink.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("apng");
        }
        try (GifSink sink = new GifSink(broken(), new Animation(2, 2, 1))) {
            sink.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("gif");
        }
        assertEquals(List.of("png", "ppm", "apng", "gif"), caught);
    }

    @Test
    void sinksOfFiles() throws IOException {
        FileChannel closed =
                FileChannel.open(folder.resolve("a.pfm"), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        closed.close();
        try (PfmSink sink = new PfmSink(closed, 2, 2)) {
            sink.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("pfm");
        }
        try (DeepZoomSink sink = new DeepZoomSink(folder.resolve("a.pfm"), 2, 2)) {
            sink.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("pyramid");
        }
        assertEquals(List.of("pfm", "pyramid"), caught);
    }

    /** Each method and constructor, alone. */
    @SuppressWarnings("unused")
    private void theRest(
            PngSink png, PpmSink ppm, PfmSink pfm, ApngSink apng, DeepZoomSink pyramid, FileChannel channel) {
        try {
            png.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("row");
        }
        try {
            ppm.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("row");
        }
        try {
            pfm.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("row");
        }
        try {
            apng.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("row");
        }
        try {
            pyramid.row(0, ROW, ROW, ROW);
        } catch (IOException e) {
            caught.add("row");
        }
        try {
            png.close();
        } catch (IOException e) {
            caught.add("close");
        }
        try {
            ppm.close();
        } catch (IOException e) {
            caught.add("close");
        }
        try {
            pfm.close();
        } catch (IOException e) {
            caught.add("close");
        }
        try {
            apng.close();
        } catch (IOException e) {
            caught.add("close");
        }
        try {
            pyramid.close();
        } catch (IOException e) {
            caught.add("close");
        }
        try {
            new PfmSink(channel, 2, 2);
        } catch (IOException e) {
            caught.add("new");
        }
    }
}
